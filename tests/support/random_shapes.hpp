#pragma once
// Shapes and sheets of triangles at random, for tests that must hold for any.

#include <array>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom_test {

using carom::Random;
using carom::Real;
using carom::Vector3;

// The corners of a cube, each pushed about: a hull that is never flat.
inline carom::ConvexHull randomHull(Random& random, Real size) {
  std::array<Vector3, 8> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    points[i] = size / 2 * (corner + random.vector(0.6));
  }
  return carom::hullOfPoints(points);
}

// A solid, no point of which is farther from its origin than 1.6 times the size.
inline carom::Shape randomShape(Random& random, Real size) {
  const int kind = random.integer(0, 5);
  const Real a = size * random.between(0.2, 1);
  const Real b = size * random.between(0.2, 1);
  if (kind == 0) return carom::Ball{a};
  if (kind == 1) return carom::Box{{a, b, size * 0.4}};
  if (kind == 2) return carom::Capsule{a / 2, b};
  if (kind == 3) return carom::Cylinder{a, b / 2};
  if (kind == 4) return randomHull(random, size);
  carom::Pose left, right;
  left.p_WB = {-a / 2, 0, 0};
  right.p_WB = {a / 2, 0, 0};
  return carom::makeCompound(
      {{carom::Ball{b / 2}, left}, {carom::Box{{a / 2, b / 2, a / 4}}, right}});
}

// A square sheet of cells x cells x 2 triangles over [-half, half]^2. height: of (x, y).
template <class Height>
carom::TriangleMesh sheetOf(Real half, int cells, const Height& height) {
  carom::TriangleMesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const Real x = half * (2.0 * i / cells - 1), y = half * (2.0 * j / cells - 1);
      mesh.vertices.push_back({x, y, height(x, y)});
    }
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const int a = (cells + 1) * i + j, b = a + cells + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return mesh;
}

// A square sheet of little hills. size: half of its edge; hills: height of the highest.
inline carom::TriangleMesh randomSheet(Random& random, Real size, Real hills) {
  return sheetOf(size, 3, [&](Real, Real) { return random.between(-hills, hills); });
}

}  // namespace carom_test

#pragma once
// Boxes to try the broad phase with.

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/aabb.hpp"

namespace carom_test {

using carom::Aabb;
using carom::IndexPair;
using carom::Random;
using carom::Real;
using carom::Vector3;

/// A cube of edge 1 m about a point [m].
inline Aabb<3> unitBoxAt(Real x, Real y, Real z) {
  const Vector3 center(x, y, z);
  return {center - Vector3::Constant(0.5), center + Vector3::Constant(0.5)};
}

/// Boxes of edges 0.2 to 1 m, all over a cube in which each has about 4 m^3.
inline std::vector<Aabb<3>> gasBoxes(int count, std::uint64_t seed) {
  Random random(seed);
  const Real size = std::cbrt(4.0 * count) / 2;
  std::vector<Aabb<3>> boxes;
  for (int i = 0; i < count; ++i) {
    const Vector3 center = random.vector(size);
    const Vector3 half = random.vector(0.4).cwiseAbs() + Vector3::Constant(0.1);
    boxes.push_back({center - half, center + half});
  }
  return boxes;
}

/// The boxes of case D16: whole numbers, so that every comparison is exact.
inline std::vector<Aabb<3>> caseBoxes(int count, int world, int size) {
  std::uint64_t state = 5;
  const auto next = [&](int limit) {
    state = 6364136223846793005u * state + 1442695040888963407u;
    return static_cast<Real>((state >> 33) % static_cast<std::uint64_t>(limit));
  };
  std::vector<Aabb<3>> boxes(count);
  for (Aabb<3>& box : boxes) {
    for (int k = 0; k < 3; ++k) box.low(k) = next(world);
    for (int k = 0; k < 3; ++k) box.high(k) = box.low(k) + 1 + next(size);
  }
  return boxes;
}

/// Scenes that are hard on a broad phase, by number from 0 to 9.
inline std::vector<Aabb<3>> hardBoxes(int scene, int count) {
  const Real infinity = std::numeric_limits<Real>::infinity();
  Random random(100 + static_cast<std::uint64_t>(scene));
  std::vector<Aabb<3>> boxes = gasBoxes(count, 50 + static_cast<std::uint64_t>(scene));
  for (int i = 0; i < count; ++i) {
    Aabb<3>& box = boxes[i];
    switch (scene) {
      case 0:
        break;
      case 1:  // in a few crowds
        box.low += Vector3::Constant(1000 * (i % 4)) - 0.9 * box.low;
        box.high = box.low + Vector3::Constant(0.3);
        break;
      case 2:
        box = unitBoxAt(1, 2, 3);
        break;  // all at one place
      case 3:
        box.low.z() = box.high.z() = 0;
        break;  // flat
      case 4:
        box.high = box.low;
        break;  // points
      case 5:
        box = {0x1p-133 * box.low, 0x1p-133 * box.high};
        break;  // about 1e-40 m
      case 6:
        box = {0x1p133 * box.low, 0x1p133 * box.high};
        break;  // about 1e40 m
      case 7:   // half-spaces and slabs
        if (i % 7 == 0) box.low(i % 3) = -infinity;
        if (i % 21 == 0) box.high((i + 1) % 3) = infinity;
        break;
      case 8:  // every size from a grain to a continent
        box.high = box.low + (box.high - box.low) * std::exp2(random.between(-20, 5));
        break;
      default:  // on a grid, touching each other
        box = unitBoxAt(i % 6, i / 6 % 6, i / 36);
    }
  }
  return boxes;
}

/// How many scenes hardBoxes() has.
inline constexpr int kHardScenes = 10;

/// Pairs as they are compared: sorted.
inline std::vector<IndexPair> sorted(std::vector<IndexPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace carom_test

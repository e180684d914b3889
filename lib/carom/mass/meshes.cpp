#include "carom/mass/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {
namespace {

constexpr Real kTwoPi = 2 * std::numbers::pi;

void require(bool holds, const std::string& rule) {
  if (!holds) throw InvalidInput(rule);
}

bool positive(Real value) {
  return value > 0 && std::isfinite(value);
}

// Corners of a square in a grid, as two triangles along the diagonal from `a` to `c`.
void addSquare(TriangleMesh& mesh, int a, int b, int c, int d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

// z of the normal of (origin, p, q): positive if q is counter-clockwise of p.
Real turn(const Vector2& p, const Vector2& q) {
  return p.x() * q.y() - p.y() * q.x();
}

void requireOutline(const char* maker, std::span<const Vector2> outline, Real height) {
  require(outline.size() >= 3, std::string(maker) + ": an outline needs at least 3 corners, not " +
                                   std::to_string(outline.size()));
  require(positive(height),
          std::string(maker) + ": height must be positive, but is " + std::to_string(height));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2& next = outline[(i + 1) % outline.size()];
    require(turn(outline[i], next) > 0,
            std::string(maker) + ": corner " + std::to_string((i + 1) % outline.size()) +
                " is not counter-clockwise of the corner before it, seen from the origin");
  }
}

}  // namespace

TriangleMesh boxMesh(const Vector3& low, const Vector3& high) {
  require(low.allFinite() && high.allFinite() && (high - low).minCoeff() > 0,
          "boxMesh: high must be above low in every coordinate");
  TriangleMesh mesh;
  // Bit 0, 1, 2 of the number of a vertex: at the high end in x, y, z.
  for (int v = 0; v < 8; ++v) {
    mesh.vertices.emplace_back((v & 1) != 0 ? high.x() : low.x(), (v & 2) != 0 ? high.y() : low.y(),
                               (v & 4) != 0 ? high.z() : low.z());
  }
  addSquare(mesh, 0, 2, 3, 1);  // bottom
  addSquare(mesh, 4, 5, 7, 6);  // top
  addSquare(mesh, 0, 1, 5, 4);  // front, y low
  addSquare(mesh, 2, 6, 7, 3);  // back
  addSquare(mesh, 0, 4, 6, 2);  // left, x low
  addSquare(mesh, 1, 3, 7, 5);  // right
  return mesh;
}

TriangleMesh tetrahedronMesh(const Vector3& a, const Vector3& b, const Vector3& c,
                             const Vector3& d) {
  TriangleMesh mesh{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const bool mirrored = cross(b - a, c - a).dot(d - a) < 0;
  return mirrored ? reversed(std::move(mesh)) : mesh;
}

TriangleMesh ellipsoidMesh(const Vector3& semiAxes, int rings) {
  require(semiAxes.allFinite() && semiAxes.minCoeff() > 0,
          "ellipsoidMesh: half lengths must be positive and finite");
  require(rings >= 2 && rings <= 10000,
          "ellipsoidMesh: rings must be 2 to 10000, but is " + std::to_string(rings));
  const int around = 2 * rings;
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, semiAxes.z());
  for (int i = 1; i < rings; ++i) {
    const Real polar = std::numbers::pi * i / rings;
    for (int j = 0; j < around; ++j) {
      const Real longitude = kTwoPi * j / around;
      mesh.vertices.push_back(
          semiAxes.cwiseProduct(Vector3(std::sin(polar) * std::cos(longitude),
                                        std::sin(polar) * std::sin(longitude), std::cos(polar))));
    }
  }
  mesh.vertices.emplace_back(0, 0, -semiAxes.z());

  const int south = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [around](int i, int j) { return 1 + (i - 1) * around + j % around; };
  for (int j = 0; j < around; ++j) mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
  for (int i = 1; i < rings - 1; ++i) {
    for (int j = 0; j < around; ++j) {
      addSquare(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  for (int j = 0; j < around; ++j) {
    mesh.triangles.push_back({at(rings - 1, j), south, at(rings - 1, j + 1)});
  }
  return mesh;
}

TriangleMesh icosphereMesh(Real radius, int splits) {
  require(positive(radius), "icosphereMesh: radius must be positive and finite");
  require(splits >= 0 && splits <= 9,
          "icosphereMesh: splits must be 0 to 9, but is " + std::to_string(splits));
  // The icosahedron: three golden rectangles at right angles.
  const Real g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int split = 0; split < splits; ++split) {
    // A new vertex in the middle of each edge, made once for the two triangles that share it.
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
      const auto [place, isNew] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.vertices.size()));
      if (isNew) {
        const Vector3 sum =
            mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)];
        mesh.vertices.push_back(sum);
      }
      return place->second;
    };
    std::vector<std::array<std::int32_t, 3>> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::int32_t ab = middle(a, b);
      const std::int32_t bc = middle(b, c);
      const std::int32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
    for (Vector3& vertex : mesh.vertices) vertex /= vertex.norm();
  }
  for (Vector3& vertex : mesh.vertices) vertex *= radius / vertex.norm();
  return mesh;
}

TriangleMesh torusMesh(Real ringRadius, Real tubeRadius, int around, int across) {
  require(positive(tubeRadius) && tubeRadius < ringRadius && std::isfinite(ringRadius),
          "torusMesh: needs 0 < tubeRadius < ringRadius");
  require(around >= 3 && across >= 3 && around <= 100000 && across <= 10000,
          "torusMesh: needs at least 3 steps around and across");
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i) {
    const Real u = kTwoPi * i / around;
    for (int j = 0; j < across; ++j) {
      const Real v = kTwoPi * j / across;
      const Real distance = ringRadius + tubeRadius * std::cos(v);
      mesh.vertices.emplace_back(distance * std::cos(u), distance * std::sin(u),
                                 tubeRadius * std::sin(v));
    }
  }
  const auto at = [=](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      addSquare(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh;
}

TriangleMesh latheMesh(std::span<const Vector2> profile, int around) {
  require(around >= 3, "latheMesh: needs at least 3 steps around, not " + std::to_string(around));
  require(profile.size() >= 3, "latheMesh: a profile needs at least 3 points");
  require(profile.front().x() == 0 && profile.back().x() == 0,
          "latheMesh: the profile must begin and end on the axis");
  for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
    require(positive(profile[i].x()),
            "latheMesh: point " + std::to_string(i) + " of the profile must lie off the axis");
  }
  const int circles = static_cast<int>(profile.size()) - 2;
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, profile.front().y());
  for (int i = 1; i <= circles; ++i) {
    const Vector2& point = profile[static_cast<std::size_t>(i)];
    for (int j = 0; j < around; ++j) {
      const Real u = kTwoPi * j / around;
      mesh.vertices.emplace_back(point.x() * std::cos(u), point.x() * std::sin(u), point.y());
    }
  }
  mesh.vertices.emplace_back(0, 0, profile.back().y());

  const int top = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [around](int i, int j) { return 1 + i * around + j % around; };
  for (int j = 0; j < around; ++j) mesh.triangles.push_back({0, at(0, j + 1), at(0, j)});
  for (int i = 0; i + 1 < circles; ++i) {
    for (int j = 0; j < around; ++j) {
      addSquare(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  for (int j = 0; j < around; ++j) {
    mesh.triangles.push_back({at(circles - 1, j), at(circles - 1, j + 1), top});
  }
  return mesh;
}

TriangleMesh prismMesh(std::span<const Vector2> outline, Real height) {
  requireOutline("prismMesh", outline, height);
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, -height / 2);
  mesh.vertices.emplace_back(0, 0, height / 2);
  for (const Vector2& corner : outline) {
    mesh.vertices.emplace_back(corner.x(), corner.y(), -height / 2);
    mesh.vertices.emplace_back(corner.x(), corner.y(), height / 2);
  }
  const int n = static_cast<int>(outline.size());
  for (int i = 0; i < n; ++i) {
    const int here = 2 + 2 * i;
    const int next = 2 + 2 * ((i + 1) % n);
    mesh.triangles.push_back({0, next, here});
    mesh.triangles.push_back({1, here + 1, next + 1});
    addSquare(mesh, here, next, next + 1, here + 1);
  }
  return mesh;
}

TriangleMesh hollowPrismMesh(std::span<const Vector2> outline, std::span<const Vector2> hole,
                             Real height) {
  requireOutline("hollowPrismMesh", outline, height);
  requireOutline("hollowPrismMesh", hole, height);
  require(hole.size() == outline.size(),
          "hollowPrismMesh: outline and hole need equally many corners");
  TriangleMesh mesh;
  const int n = static_cast<int>(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (const Vector2& corner : {outline[i], hole[i]}) {
      mesh.vertices.emplace_back(corner.x(), corner.y(), -height / 2);
      mesh.vertices.emplace_back(corner.x(), corner.y(), height / 2);
    }
  }
  for (int i = 0; i < n; ++i) {
    const int here = 4 * i;  // outer low, outer high, inner low, inner high
    const int next = 4 * ((i + 1) % n);
    addSquare(mesh, here, next, next + 1, here + 1);          // outer wall
    addSquare(mesh, here + 2, here + 3, next + 3, next + 2);  // inner wall
    addSquare(mesh, here + 1, next + 1, next + 3, here + 3);  // top
    addSquare(mesh, here, here + 2, next + 2, next);          // bottom
  }
  return mesh;
}

TriangleMesh translated(TriangleMesh mesh, const Vector3& offset) {
  for (Vector3& vertex : mesh.vertices) vertex += offset;
  return mesh;
}

TriangleMesh transformed(TriangleMesh mesh, const Matrix3& map) {
  for (Vector3& vertex : mesh.vertices) {
    const Vector3 old = vertex;
    vertex = map * old;
  }
  const bool mirrors = cross(map.col(0), map.col(1)).dot(map.col(2)) < 0;
  return mirrors ? reversed(std::move(mesh)) : mesh;
}

TriangleMesh reversed(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

TriangleMesh joined(TriangleMesh first, const TriangleMesh& second) {
  const auto shift = static_cast<std::int32_t>(first.vertices.size());
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const auto& [a, b, c] : second.triangles) {
    first.triangles.push_back({a + shift, b + shift, c + shift});
  }
  return first;
}

TriangleMesh snapToGrid(TriangleMesh mesh, Real grid) {
  require(positive(grid), "snapToGrid: grid must be positive");
  for (Vector3& vertex : mesh.vertices) {
    for (Real& coordinate : vertex) coordinate = std::nearbyint(coordinate / grid) * grid;
  }
  return mesh;
}

}  // namespace carom

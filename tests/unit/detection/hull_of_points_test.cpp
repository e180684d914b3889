// Hulls of points: known solids, points in bad positions, and a judge that computes with integers.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "detection_reference.hpp"
#include "hull_checks.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

using Points = std::vector<Vector3>;
constexpr Real kUlp = 2.220446049250313e-16;

Points placed(Points points, const Pose& pose) {
  for (Vector3& point : points) point = pointToWorld(pose, point);
  return points;
}

Real farthestOutside(const ConvexHull& hull, const Points& points) {
  Real worst = 0;
  for (const HullFace& face : hull.faces) {
    for (const Vector3& p : points) worst = std::max(worst, face.normal.dot(p) - face.offset);
  }
  return worst;
}

Real largestCoordinate(const Points& points) {
  Real largest = 0;
  for (const Vector3& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

void checkWraps(const ConvexHull& hull, const Points& points) {
  checkHull(hull);
  CHECK(farthestOutside(hull, points) <= 2 * kFlatness * largestCoordinate(points));
}

// Points spread evenly over a sphere.
Points spiral(int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const Real z = 1 - (2 * i + 1.0) / count;
    const Real angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Real r = std::sqrt(1 - z * z);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return points;
}

// The judge: all planes through three of the points that have all others on one side, as
// (normal, offset) divided by their common divisor, and the points that are corners.
using Plane = std::array<std::int64_t, 4>;
struct IntegerHull {
  std::set<Plane> planes;
  std::size_t corners = 0;
};

IntegerHull judge(const std::vector<std::array<std::int64_t, 3>>& p) {
  IntegerHull hull;
  const auto minus = [](const auto& a, const auto& b) {
    return std::array<std::int64_t, 3>{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto times = [](const auto& a, const auto& b) {
    return std::array<std::int64_t, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                       a[0] * b[1] - a[1] * b[0]};
  };
  const auto dot = [](const auto& a, const auto& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      for (std::size_t k = j + 1; k < p.size(); ++k) {
        auto n = times(minus(p[j], p[i]), minus(p[k], p[i]));
        if (n[0] == 0 && n[1] == 0 && n[2] == 0) continue;
        std::int64_t low = 0, high = 0;
        for (const auto& q : p) {
          low = std::min(low, dot(n, minus(q, p[i])));
          high = std::max(high, dot(n, minus(q, p[i])));
        }
        if (low < 0 && high > 0) continue;
        if (high > 0) n = {-n[0], -n[1], -n[2]};
        const std::int64_t divisor = std::gcd(std::gcd(n[0], n[1]), n[2]);
        for (auto& c : n) c /= divisor;
        hull.planes.insert({n[0], n[1], n[2], dot(n, p[i])});
      }
    }
  }
  // A corner lies on three planes whose normals are not in one plane.
  std::set<std::array<std::int64_t, 3>> seen;
  for (const auto& q : p) {
    if (!seen.insert(q).second) continue;
    std::vector<std::array<std::int64_t, 3>> normals;
    for (const Plane& plane : hull.planes) {
      const std::array<std::int64_t, 3> n = {plane[0], plane[1], plane[2]};
      if (dot(n, q) == plane[3]) normals.push_back(n);
    }
    bool corner = false;
    for (std::size_t i = 0; i < normals.size() && !corner; ++i) {
      for (std::size_t j = i + 1; j < normals.size() && !corner; ++j) {
        for (std::size_t k = j + 1; k < normals.size() && !corner; ++k) {
          corner = dot(normals[i], times(normals[j], normals[k])) != 0;
        }
      }
    }
    hull.corners += corner;
  }
  return hull;
}

}  // namespace

TEST_CASE("eight corners make a cube, with square faces, whatever else lies inside or on it") {
  Points points = boxHull({1, 1, 1}).vertices;
  for (Real x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (Real y : {-1.0, 0.0, 0.25, 1.0}) {
      for (Real z : {-1.0, 0.0, 1.0}) points.emplace_back(x, y, z);
    }
  }
  const ConvexHull hull = hullOfPoints(points);
  checkWraps(hull, points);
  CHECK(hull.vertices == boxHull({1, 1, 1}).vertices);
  CHECK(hull.faces.size() == 6);
  CHECK(hull.edges.size() == 12);
  CHECK(hull.volume == 8);
  for (const HullFace& face : hull.faces) CHECK(face.count == 4);
}

TEST_CASE("a cube that has been turned and moved is still a cube of six faces") {
  CaseNumbers random(2024);
  for (int i = 0; i < 300; ++i) {
    const Real far = i % 3 == 0 ? 0 : (i % 3 == 1 ? 100 : 1e6);
    const Points points = placed(boxHull({0.5, 1, 2}).vertices, random.pose(far));
    const ConvexHull hull = hullOfPoints(points);
    REQUIRE(hull.faces.size() == 6);
    REQUIRE(hull.vertices.size() == 8);
    REQUIRE(std::abs(hull.volume - 8) <= 64 * kUlp * (far + 8));
    checkWraps(hull, points);
  }
}

TEST_CASE("four points make a tetrahedron, in any order") {
  Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  do {
    const Points shuffled = {points[order[0]], points[order[1]], points[order[2]],
                             points[order[3]]};
    const ConvexHull hull = hullOfPoints(shuffled);
    REQUIRE(hull.faces.size() == 4);
    REQUIRE_THAT(hull.volume, WithinULP(1.0 / 6, 2));
    REQUIRE(hull.vertices == shuffled);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("known solids have their known volumes") {
  // Octahedron: 4/3. Icosahedron of edge 2: 10 (3 + sqrt 5) / 3.
  const Points octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  CHECK_THAT(hullOfPoints(octahedron).volume, WithinULP(4.0 / 3, 2));
  const Real golden = (1 + std::sqrt(5.0)) / 2;
  Points icosahedron;
  for (Real s : {-1.0, 1.0}) {
    for (Real t : {-golden, golden}) {
      icosahedron.emplace_back(0, s, t);
      icosahedron.emplace_back(s, t, 0);
      icosahedron.emplace_back(t, 0, s);
    }
  }
  const ConvexHull ico = hullOfPoints(icosahedron);
  checkWraps(ico, icosahedron);
  CHECK(ico.faces.size() == 20);
  CHECK_THAT(ico.volume, WithinULP(10 * (3 + std::sqrt(5.0)) / 3, 8));
  // Dodecahedron: the corners of its faces are not exactly in one plane; they become pentagons.
  Points dodecahedron = boxHull({1, 1, 1}).vertices;
  for (Real s : {-1.0, 1.0}) {
    for (Real t : {-1.0, 1.0}) {
      dodecahedron.emplace_back(0, s / golden, t * golden);
      dodecahedron.emplace_back(s / golden, t * golden, 0);
      dodecahedron.emplace_back(t * golden, 0, s / golden);
    }
  }
  const ConvexHull dode = hullOfPoints(dodecahedron);
  checkWraps(dode, dodecahedron);
  REQUIRE(dode.faces.size() == 12);
  for (const HullFace& face : dode.faces) CHECK(face.count == 5);
}

TEST_CASE("the centroid of a hull follows when it is moved") {
  const Points points = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}, {1, 1, 1}};
  CaseNumbers random(8);
  const ConvexHull hull = hullOfPoints(points);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = random.pose(10);
    const ConvexHull moved = hullOfPoints(placed(points, pose));
    CHECK((moved.centroid - pointToWorld(pose, hull.centroid)).norm() <= 1e-14);
    CHECK_THAT(moved.volume, WithinRel(hull.volume, 1e-13));
  }
}

TEST_CASE("points on a sphere are all corners, and the volume nears that of the ball") {
  const Points points = spiral(1000);
  const ConvexHull hull = hullOfPoints(points);
  checkWraps(hull, points);
  CHECK(hull.vertices == points);
  CHECK(hull.volume < 4 * std::numbers::pi / 3);
  CHECK(hull.volume > 4 * std::numbers::pi / 3 * 0.99);
}

TEST_CASE("small integer points agree with the judge: the same planes, the same corners") {
  CaseNumbers random(99);
  int hulls = 0, flat = 0;
  for (int round = 0; round < 1500; ++round) {
    const std::uint64_t side = 2 + random.next() % 4;
    const std::size_t count = 4 + random.next() % 12;
    std::vector<std::array<std::int64_t, 3>> whole;
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
      std::array<std::int64_t, 3> p{};
      for (auto& c : p) c = static_cast<std::int64_t>(random.next() % side);
      whole.push_back(p);
      points.emplace_back(p[0], p[1], p[2]);
    }
    const IntegerHull expected = judge(whole);
    if (expected.planes.size() < 4) {
      ++flat;
      REQUIRE_THROWS_AS(hullOfPoints(points), InvalidInput);
      continue;
    }
    ++hulls;
    const ConvexHull hull = hullOfPoints(points);
    REQUIRE(hull.faces.size() == expected.planes.size());
    REQUIRE(hull.vertices.size() == expected.corners);
    for (const Plane& plane : expected.planes) {
      const Vector3 n(static_cast<Real>(plane[0]), static_cast<Real>(plane[1]),
                      static_cast<Real>(plane[2]));
      const bool found = std::any_of(hull.faces.begin(), hull.faces.end(), [&](const HullFace& f) {
        return (f.normal - n / n.norm()).norm() <= 8 * kUlp &&
               std::abs(f.offset - static_cast<Real>(plane[3]) / n.norm()) <= 16 * kUlp;
      });
      REQUIRE(found);
    }
    if (round % 10 == 0) checkWraps(hull, points);
  }
  CHECK(hulls > 1000);
  CHECK(flat > 10);
}

TEST_CASE("the same integer points, turned and moved, keep their faces") {
  CaseNumbers random(100);
  for (int round = 0; round < 1000; ++round) {
    Points points;
    for (int i = 0; i < 20; ++i) {
      points.emplace_back(static_cast<Real>(random.next() % 4),
                          static_cast<Real>(random.next() % 4),
                          static_cast<Real>(random.next() % 4));
    }
    const ConvexHull straight = hullOfPoints(points);
    const Points turned = placed(points, random.pose(round % 2 == 0 ? 0 : 1000));
    const ConvexHull hull = hullOfPoints(turned);
    REQUIRE(hull.faces.size() == straight.faces.size());
    REQUIRE(hull.edges.size() == straight.edges.size());
    checkWraps(hull, turned);
  }
}

TEST_CASE("points without a volume are refused, and the reason is said") {
  const Vector3 p(1, 2, 3), d(0.1, 0.2, -0.3), e(1, 0, 0.5);
  CHECK_THROWS_WITH(hullOfPoints({}), ContainsSubstring("0 points"));
  CHECK_THROWS_WITH(hullOfPoints(Points{p, p, p, p, p}), ContainsSubstring("one place"));
  CHECK_THROWS_WITH(hullOfPoints(Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}),
                    ContainsSubstring("in a line"));
  CHECK_THROWS_WITH(hullOfPoints(Points{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {3, 4, 1}, {-1, 2, 1}}),
                    ContainsSubstring("one plane"));
  // In a plane up to rounding only: still refused, because such a solid has no inside.
  CaseNumbers random(5);
  for (int round = 0; round < 50; ++round) {
    Points flat;
    for (int i = 0; i < 20; ++i) {
      flat.push_back(p + random.between(-1, 1) * d + random.between(-1, 1) * e);
    }
    REQUIRE_THROWS_WITH(hullOfPoints(flat), ContainsSubstring("one plane"));
    Points line;
    for (int i = 0; i < 20; ++i) line.push_back(p + random.between(-1, 1) * d);
    REQUIRE_THROWS_AS(hullOfPoints(line), InvalidInput);
  }
  const Points bad = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::nan("")}};
  CHECK_THROWS_WITH(hullOfPoints(bad), ContainsSubstring("must be finite"));
}

TEST_CASE("doubles of a point, exact and by a rounding error, are one corner") {
  CaseNumbers random(6);
  Points points;
  for (const Vector3& corner : boxHull({1, 2, 3}).vertices) {
    for (int i = 0; i < 5; ++i) points.push_back(corner + kUlp * random.vectorBetween(-1, 1));
  }
  const ConvexHull hull = hullOfPoints(points);
  CHECK(hull.vertices.size() == 8);
  CHECK(hull.faces.size() == 6);
  checkWraps(hull, points);
}

TEST_CASE("needles, plates and random clouds have hulls") {
  CaseNumbers random(7);
  for (int round = 0; round < 60; ++round) {
    Points points;
    const Real thin = std::pow(10.0, -static_cast<Real>(round % 8));
    for (int i = 0; i < 60; ++i) {
      Vector3 p = random.vectorBetween(-1, 1);
      p.z() *= thin;
      if (round % 2 == 0) p.y() *= thin;
      points.push_back(p);
    }
    const Points turned = placed(points, random.pose(1));
    checkWraps(hullOfPoints(turned), turned);
  }
}

TEST_CASE("a prism of 60 sides has two faces of 60 corners") {
  Points points;
  for (int i = 0; i < 60; ++i) {
    const Real angle = i * std::numbers::pi / 30;
    points.emplace_back(std::cos(angle), std::sin(angle), -1);
    points.emplace_back(std::cos(angle), std::sin(angle), 1);
  }
  CaseNumbers random(61);
  const Points turned = placed(points, random.pose(3));
  const ConvexHull hull = hullOfPoints(turned);
  checkWraps(hull, turned);
  REQUIRE(hull.faces.size() == 62);
  CHECK(std::count_if(hull.faces.begin(), hull.faces.end(),
                      [](const HullFace& face) { return face.count == 60; }) == 2);
}

TEST_CASE("the hull does not depend on the order of the points") {
  CaseNumbers random(62);
  Points points;
  for (int i = 0; i < 40; ++i) points.push_back(random.vectorBetween(-1, 1));
  const ConvexHull first = hullOfPoints(points);
  for (int round = 0; round < 10; ++round) {
    std::rotate(points.begin(), points.begin() + 7, points.end());
    const ConvexHull other = hullOfPoints(points);
    CHECK(other.faces.size() == first.faces.size());
    CHECK_THAT(other.volume, WithinRel(first.volume, 1e-15));
  }
}

// Signed distances of all pairs: closed forms and the case book, then proofs that hold for any pair.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/detection/closest_point.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/rounded_distance.hpp"
#include "carom/detection/segment_segment.hpp"
#include "carom/detection/separate_boxes.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/detection/separate_polygons.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/detection/support.hpp"
#include "detection_reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kUlp = 2.220446049250313e-16;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

Pose at(Real x, Real y, Real z) {
  return {Matrix3::Identity(), {x, y, z}};
}

ConvexHull cloud(int count, std::uint64_t seed) {
  CaseNumbers random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) points.push_back(random.direction());
  return hullOfPoints(points);
}

std::vector<ConvexShape> zoo() {
  return {Ball{0.7},          Box{{0.5, 1, 0.25}}, Capsule{0.4, 0.8},
          Cylinder{0.6, 0.5}, cloud(12, 1),        cloud(120, 2)};
}

bool isPolyhedron(const ConvexShape& shape) {
  return std::holds_alternative<Box>(shape) || std::holds_alternative<ConvexHull>(shape);
}
bool isCylinder(const ConvexShape& shape) {
  return std::holds_alternative<Cylinder>(shape);
}

// How far A reaches beyond B's nearest point along a direction: the way B must go to be free.
Real reach(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
           const Vector3& n) {
  const Vector3 onA = directionToWorld(A, supportOf(a, directionToBody(A, n)).point);
  const Vector3 onB =
      directionToWorld(B, supportOf(b, directionToBody(B, -n)).point) + (B.p_WB - A.p_WB);
  return n.dot(onA - onB);
}

// What every answer must be, whatever the pair. `tolerance` is in metres for bodies of size one.
void checkAnswer(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                 const Separation& s, Real tolerance) {
  REQUIRE(std::isfinite(s.separation));
  REQUIRE(std::abs(s.normal.norm() - 1) <= 8 * kUlp);
  // The points are where they say, and on both bodies.
  REQUIRE((s.pointB - s.pointA - s.separation * s.normal).norm() <= tolerance);
  REQUIRE(std::abs(closestPoint(a, A, s.pointA).distance) <= tolerance);
  REQUIRE(std::abs(closestPoint(b, B, s.pointB).distance) <= tolerance);
  // The normal is a proof: along it A ends and B begins just so far apart. For bodies that are
  // apart no nearer points can exist; for bodies that overlap this way out is as long as said.
  REQUIRE(std::abs(reach(a, A, b, B, s.normal) + s.separation) <= tolerance);
}

}  // namespace

TEST_CASE("balls, boxes, capsules and floors in closed form") {
  const Shape ball = Ball{1}, box = Box{{1, 2, 3}}, capsule = Capsule{1, 2};
  const Shape floor = makeHalfSpace({0, 0, 1}, {0, 0, 0});
  const Separation balls = signedDistance(ball, at(0, 0, 0), ball, at(3, 4, 0));
  CHECK(balls.separation == 3);
  CHECK(balls.normal == Vector3(0.6, 0.8, 0));
  CHECK(balls.pointA == Vector3(0.6, 0.8, 0));
  CHECK((balls.pointB - Vector3(2.4, 3.2, 0)).norm() <= kUlp);
  CHECK(signedDistance(ball, Pose{}, ball, Pose{}).separation == -2);

  CHECK(signedDistance(ball, at(3, 0, 0), box, Pose{}).separation == 1);
  CHECK(signedDistance(ball, at(3, 0, 0), box, Pose{}).normal == Vector3(-1, 0, 0));
  CHECK(signedDistance(box, Pose{}, ball, at(3, 0, 0)).normal == Vector3(1, 0, 0));
  CHECK(signedDistance(box, Pose{}, ball, at(0.75, 0, 0)).separation == -1.25);
  CHECK(signedDistance(box, Pose{}, box, at(5, 1, 1)).separation == 3);
  CHECK(signedDistance(box, Pose{}, box, at(1.5, 1, 1)).separation == -0.5);
  CHECK(signedDistance(capsule, Pose{}, capsule, at(5, 0, 1)).separation == 3);
  CHECK(signedDistance(capsule, Pose{}, capsule, at(0, 0, 7)).separation == 1);
  CHECK(signedDistance(capsule, Pose{}, box, at(3, 0, 0)).separation == 1);
  CHECK(signedDistance(Shape(Cylinder{1, 1}), Pose{}, box, at(0, 0, 7)).separation == 3);

  const Separation resting = signedDistance(floor, Pose{}, box, at(0, 0, 2.5));
  CHECK(resting.separation == -0.5);
  CHECK(resting.normal == Vector3(0, 0, 1));
  CHECK(signedDistance(box, at(0, 0, 2.5), floor, Pose{}).normal == Vector3(0, 0, -1));
  CHECK(signedDistance(floor, Pose{}, capsule, at(0, 0, 5)).separation == 2);
  CHECK(signedDistance(floor, Pose{}, Shape(Cylinder{1, 1}), at(0, 0, 5)).separation == 4);
}

TEST_CASE("a wall far from the origin loses nothing") {
  const Shape wall = makeHalfSpace({1, 0, 0}, {0, 0, 0});
  const Real far = 0x1p40;
  CHECK(
      signedDistance(wall, at(far, 0, 0), Shape(Ball{1}), at(far + 1 + 0x1p-12, 5, 5)).separation ==
      0x1p-12);
}

TEST_CASE("half-spaces: opposite walls have a gap, others overlap without end") {
  const Shape floor = makeHalfSpace({0, 0, 1}, {0, 0, 0});
  const Shape ceiling = makeHalfSpace({0, 0, -1}, {0, 0, 3});
  CHECK(signedDistance(floor, Pose{}, ceiling, Pose{}).separation == 3);
  CHECK(signedDistance(floor, at(0, 0, 5), ceiling, Pose{}).separation == -2);
  const Separation crossing =
      signedDistance(floor, Pose{}, makeHalfSpace({1, 0, 1}, {0, 0, 0}), Pose{});
  CHECK(crossing.separation == -kInfinity);
}

TEST_CASE("a compound is as near as its nearest part") {
  const Shape dumbbell = makeCompound({{Ball{1}, at(-3, 0, 0)}, {Ball{0.5}, at(3, 0, 0)}});
  const Separation s = signedDistance(dumbbell, at(0, 0, 10), Shape(Box{{1, 1, 1}}), at(3, 0, 0));
  CHECK(s.separation == 8.5);
  CHECK(s.normal == Vector3(0, 0, -1));
  CHECK(s.pointA == Vector3(3, 0, 9.5));
  CHECK(signedDistance(dumbbell, Pose{}, dumbbell, at(0, 4, 0)).separation == 2);
  CHECK(signedDistance(makeHalfSpace({0, 0, 1}, {0, 0, 0}), Pose{}, dumbbell, at(0, 0, 2))
            .separation == 1);
  // Between the balls nothing is hit.
  CHECK(signedDistance(dumbbell, Pose{}, Shape(Ball{1}), Pose{}).separation == 1);
}

TEST_CASE("D13: boxes in kissing contact are apart, and nothing is thrown") {
  const json expected = detectionCase("D13");
  const Real half = readNumber(expected["side"]) / 2;
  const Shape box = makeBox({half, half, half});
  const Matrix3 R = readMatrix(expected["R"]);
  const Separation s = signedDistance(box, {R, readVector(expected["positionA"])}, box,
                                      {R, readVector(expected["positionB"])});
  CHECK(s.separation > 0);
  CHECK(std::abs(s.separation - readNumber(expected["gap"])) <= readNumber(expected["accept"]));
  CHECK(std::abs(s.normal.norm() - 1) <= 4 * kUlp);
  CHECK(s.status != SeparationStatus::stalled);
}

TEST_CASE("D4, D7: the sign of the distance is the exact verdict, for touching bodies zero") {
  std::ifstream file(std::string(CAROM_CASES_DIR) + "/sat.json");
  const json all = json::parse(file);
  struct Count {
    int overlapping = 0, touching = 0, separated = 0;
    void add(Real separation) {
      (separation > 0 ? separated : (separation < 0 ? overlapping : touching)) += 1;
    }
  };
  for (const char* set : {"integer", "tenths"}) {
    const Real divisor = std::string(set) == "tenths" ? 10 : 1;
    const auto drawn = [&](CaseNumbers& random, std::uint64_t range) {
      return static_cast<Real>(random.next() % range) / divisor;
    };
    const auto check = [&](const Count& count, const json& expected) {
      CHECK(count.overlapping == expected["overlapping"].get<int>());
      CHECK(count.touching == expected["touching"].get<int>());
      CHECK(count.separated == expected["separated"].get<int>());
    };

    // Triangles; those without an area are skipped, clockwise ones turned.
    const json planar = all["D4"];
    CaseNumbers random2(planar[set]["seed"].get<std::uint64_t>());
    Count triangles;
    for (int n = 0; n < planar["pairs"].get<int>();) {
      std::vector<Vector2> pair[2];
      bool flat = false;
      for (auto& corners : pair) {
        for (int i = 0; i < 3; ++i) {
          const Real x = drawn(random2, 16), y = drawn(random2, 16);
          corners.emplace_back(x, y);
        }
        const Vector2 u = divisor * (corners[1] - corners[0]),
                      v = divisor * (corners[2] - corners[0]);
        const Real area =
            std::round(u.x()) * std::round(v.y()) - std::round(u.y()) * std::round(v.x());
        flat = flat || area == 0;
        if (area < 0) std::swap(corners[1], corners[2]);
      }
      if (flat) continue;
      ++n;
      triangles.add(signedDistance(PlanarShape(makePolygon(pair[0])), PlanarPose{},
                                   PlanarShape(makePolygon(pair[1])), PlanarPose{})
                        .separation);
    }
    check(triangles, planar[set]);

    const json spatial = all["D7"];
    CaseNumbers random3(spatial[set]["seed"].get<std::uint64_t>());
    Count tetrahedra;
    for (int n = 0; n < spatial["pairs"].get<int>();) {
      std::vector<Vector3> pair[2];
      bool flat = false;
      for (auto& corners : pair) {
        for (int i = 0; i < 4; ++i) {
          const Real x = drawn(random3, 8), y = drawn(random3, 8), z = drawn(random3, 8);
          corners.emplace_back(x, y, z);
        }
        Matrix3 edges;
        for (int i = 0; i < 3; ++i) {
          edges.col(i) = (divisor * (corners[static_cast<std::size_t>(i) + 1] - corners[0]))
                             .array()
                             .round()
                             .matrix();
        }
        flat = flat || std::abs(edges.col(0).dot(cross(edges.col(1), edges.col(2)))) < 0.5;
      }
      if (flat) continue;
      ++n;
      tetrahedra.add(
          signedDistance(Shape(hullOfPoints(pair[0])), Pose{}, Shape(hullOfPoints(pair[1])), Pose{})
              .separation);
    }
    check(tetrahedra, spatial[set]);
  }
}

TEST_CASE("a rounded distance is the distance, but for the sign of what touches") {
  CaseNumbers random(7);
  const std::vector<ConvexShape> shapes = zoo();
  for (const ConvexShape& a : shapes) {
    for (const ConvexShape& b : shapes) {
      for (int k = 0; k < 5; ++k) {
        const Vector3 way = random.direction();
        const Pose A = at(0, 0, 0), B{Matrix3::Identity(), 0.5 * k * way};
        const Shape one = std::visit([](const auto& s) { return Shape(s); }, a);
        const Shape other = std::visit([](const auto& s) { return Shape(s); }, b);
        const Separation exact = signedDistance(one, A, other, B);
        const Separation rounded = roundedDistance(one, A, other, B);
        REQUIRE(std::abs(rounded.separation - exact.separation) <= 16 * kUlp);
        REQUIRE((rounded.normal - exact.normal).norm() <= 16 * kUlp);
      }
    }
  }
  const Shape cube = Box{{0.5, 0.5, 0.5}};
  CHECK(signedDistance(cube, at(0, 0, 0), cube, at(1, 0, 0)).separation == 0);
  CHECK(std::abs(roundedDistance(cube, at(0, 0, 0), cube, at(1, 0, 0)).separation) <= 4 * kUlp);
  CHECK_THROWS_AS(roundedDistance(cube, at(NAN, 0, 0), cube, at(1, 0, 0)), InvalidInput);
}

TEST_CASE("D14: the gap of 3.6 micrometres between two boxes is right to a part in ten million") {
  const json expected = detectionCase("D14");
  const Shape a = makeBox(readVector(expected["sidesA"]) / 2);
  const Shape b = makeBox(readVector(expected["sidesB"]) / 2);
  const Separation s =
      signedDistance(a, {readMatrix(expected["RA"]), readVector(expected["positionA"])}, b,
                     {readMatrix(expected["RB"]), readVector(expected["positionB"])});
  CHECK(std::abs(s.separation - readNumber(expected["distance"])) <=
        readNumber(expected["accept"]));
  CHECK((s.pointA - readVector(expected["pointA"])).norm() <= readNumber(expected["accept"]));
  CHECK((s.pointB - readVector(expected["pointB"])).norm() <= readNumber(expected["accept"]));
}

TEST_CASE("D15: nearest points of segments and triangles in closed form") {
  const json expected = detectionCase("D15");
  const auto end = [&](const char* part, const char* segment, int i) {
    return readVector(expected[part][segment][static_cast<std::size_t>(i)]);
  };
  const SegmentPair skew = closestPoints(end("a", "first", 0), end("a", "first", 1),
                                         end("a", "second", 0), end("a", "second", 1));
  CHECK_THAT(skew.squared, WithinRel(readNumber(expected["a"]["squared"]), 4e-16));
  CHECK((skew.pointA - readVector(expected["a"]["points"][0])).norm() <= 2 * kUlp);
  CHECK((skew.pointB - readVector(expected["a"]["points"][1])).norm() <= 2 * kUlp);
  const SegmentPair parallel = closestPoints(end("b", "first", 0), end("b", "first", 1),
                                             end("b", "second", 0), end("b", "second", 1));
  CHECK_THAT(parallel.squared, WithinRel(6.0, 4e-16));
  const Vector3 nearest =
      closestOnTriangle(readVector(expected["c"]["point"]), end("c", "triangle", 0),
                        end("c", "triangle", 1), end("c", "triangle", 2));
  CHECK((nearest - readVector(expected["c"]["nearest"])).norm() <= 2 * kUlp);
  CHECK_THAT((nearest - readVector(expected["c"]["point"])).squaredNorm(), WithinRel(2.5, 4e-16));
}

TEST_CASE("D18: issues of other libraries that have simple answers") {
  const json expected = detectionCase("D18");
  const Real accept = readNumber(expected["accept"]);
  // Aligned cubes: depth 0.1 along z, and not a direction that is no number.
  const Shape cube = Box{{1, 1, 1}};
  const Separation a = signedDistance(cube, Pose{}, cube,
                                      at(0, 0, readNumber(expected["a"]["distance of centres"])));
  CHECK(std::abs(a.separation + readNumber(expected["a"]["depth"])) <= accept);
  CHECK((a.normal - readVector(expected["a"]["normal"])).norm() <= accept);
  // A small cube in the corner of a big one: 0.2 along an axis, and not the diagonal.
  const Real side = readNumber(expected["b"]["side of the small cube"]);
  const Real c = readNumber(expected["b"]["centre"]);
  for (const bool hulls : {false, true}) {
    const Shape big = hulls ? Shape(boxHull({0.5, 0.5, 0.5})) : Shape(Box{{0.5, 0.5, 0.5}});
    const Vector3 half(side / 2, side / 2, side / 2);
    const Shape small = hulls ? Shape(boxHull(half)) : Shape(Box{half});
    const Separation b = signedDistance(big, Pose{}, small, at(c, c, c));
    CHECK(std::abs(b.separation + readNumber(expected["b"]["depth"])) <= accept);
    CHECK(std::abs(b.normal.maxCoeff() - 1) <= accept);
  }
  // Face on face, slightly turned: as deep as the faces overlap, and no deeper.
  const Shape unit = Box{{0.5, 0.5, 0.5}};
  const Real overlap = std::ldexp(1.0, expected["c"]["overlap pow2"].get<int>());
  const Real shift = std::ldexp(1.0, expected["c"]["shift pow2"].get<int>());
  const Real angle = std::ldexp(1.0, expected["c"]["angle pow2"].get<int>());
  const Pose turned =
      poseOf({std::cos(angle / 2), 0, std::sin(angle / 2), 0}, {shift, 1 - overlap, 0});
  const Separation d = signedDistance(unit, Pose{}, unit, turned);
  CHECK(std::abs(d.separation + readNumber(expected["c"]["depth"])) <= accept);
  CHECK((d.normal - Vector3(0, 1, 0)).norm() <= accept);
}

TEST_CASE("crossing edges: two cubes balance on their edges, overlapping and apart") {
  const Real h = std::sqrt(0.5);
  const Pose A{(Matrix3() << h, 0, h, 0, 1, 0, -h, 0, h).finished(), {0, 0, 0}};
  const Matrix3 aboutX = (Matrix3() << 1, 0, 0, 0, h, -h, 0, h, h).finished();
  const Shape cube = Box{{1, 1, 1}};
  for (const Real gap : {-0.1, 0.1}) {
    const Separation s = signedDistance(cube, A, cube, {aboutX, {0, 0, 2 * std::sqrt(2.0) + gap}});
    CHECK(std::abs(s.separation - gap) <= 1e-15);
    CHECK((s.normal - Vector3(0, 0, 1)).norm() <= 1e-15);
    CHECK((s.pointA - Vector3(0, 0, std::sqrt(2.0))).norm() <= 1e-15);
  }
}

TEST_CASE("boxes that touch exactly have separation zero, and an ulp makes the difference") {
  const Shape cube = Box{{1, 1, 1}};
  CHECK(signedDistance(cube, Pose{}, cube, at(2, 0.5, 0)).separation == 0);
  CHECK(signedDistance(cube, Pose{}, cube, at(2, 2, 0)).separation == 0);
  CHECK(signedDistance(cube, Pose{}, cube, at(2, 2, 2)).separation == 0);
  CHECK(signedDistance(cube, Pose{}, cube, at(2 + 2 * kUlp, 0.5, 0)).separation == 2 * kUlp);
  CHECK(signedDistance(cube, Pose{}, cube, at(2 - kUlp, 0.5, 0)).separation == -kUlp);
  const Real far = 0x1p30;
  CHECK(signedDistance(cube, at(far, 0, 0), cube, at(far + 2 + 0x1p-20, 0, 0)).separation ==
        0x1p-20);
}

TEST_CASE("every pair: the points, the normal and the distance prove each other") {
  CaseNumbers random(31);
  for (const ConvexShape& a : zoo()) {
    for (const ConvexShape& b : zoo()) {
      // Curved bodies with edges are pushed apart by an iteration; all else is right to rounding.
      const bool curved = (isCylinder(a) || isCylinder(b)) && !std::holds_alternative<Ball>(a) &&
                          !std::holds_alternative<Ball>(b);
      int apart = 0, overlapping = 0;
      for (int i = 0; i < 150; ++i) {
        const Pose A = random.pose(1), B = random.pose(1);
        const Separation s = signedDistance(a, A, b, B);
        (s.separation > 0 ? apart : overlapping) += 1;
        INFO("shapes " << a.index() << " and " << b.index() << ", round " << i);
        checkAnswer(a, A, b, B, s, curved ? 1e-7 : 1e-13);
        if (s.separation >= 0) continue;
        // No other way out is shorter.
        for (int k = 0; k < 50; ++k) {
          REQUIRE(reach(a, A, b, B, random.direction()) >= -s.separation - (curved ? 1e-7 : 1e-13));
        }
      }
      CHECK(apart > 0);
      CHECK(overlapping > 0);
    }
  }
}

TEST_CASE("swapping the bodies mirrors the answer, moving both moves it") {
  CaseNumbers random(32);
  for (const ConvexShape& a : zoo()) {
    for (const ConvexShape& b : zoo()) {
      const bool curved = isCylinder(a) || isCylinder(b);
      const Real tolerance = curved ? 1e-8 : 1e-13;
      for (int i = 0; i < 30; ++i) {
        const Pose A = random.pose(1), B = random.pose(1), move = random.pose(3);
        const Separation s = signedDistance(a, A, b, B);
        const Separation mirrored = signedDistance(b, B, a, A);
        const Separation moved = signedDistance(a, composed(move, A), b, composed(move, B));
        REQUIRE(std::abs(mirrored.separation - s.separation) <= tolerance);
        REQUIRE(std::abs(moved.separation - s.separation) <= tolerance);
        // Overlaps can have two ways out that are equally long; distances have one normal.
        if (s.separation > 1e-3 && !curved) {
          REQUIRE((mirrored.normal + s.normal).norm() <= 1e-11);
          REQUIRE((directionToBody(move, moved.normal) - s.normal).norm() <= 1e-11);
        }
      }
    }
  }
}

TEST_CASE("the depth of polyhedra is that of the exact separating axes") {
  CaseNumbers random(33);
  const ConvexHull hullA = cloud(20, 5), hullB = cloud(20, 6);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose A = random.pose(0.7), B = random.pose(0.7);
    const Box a{random.vectorBetween(0.2, 1)}, b{random.vectorBetween(0.2, 1)};
    const Separation boxes = signedDistance(Shape(a), A, Shape(b), B);
    if (boxes.separation < 0) {
      ++hits;
      REQUIRE(std::abs(boxes.separation - separateBoxes(a, A, b, B).separation) <= 1e-14);
    }
    const Separation hulls = signedDistance(Shape(hullA), A, Shape(hullB), B);
    if (hulls.separation < 0) {
      REQUIRE(std::abs(hulls.separation - separateHulls(hullA, A, hullB, B).separation) <= 1e-14);
    }
  }
  CHECK(hits > 300);
}

TEST_CASE("the distance of hulls is that of their nearest features, by trying all") {
  CaseNumbers random(34);
  const ConvexHull a = cloud(10, 7), b = boxHull({0.5, 0.7, 0.9});
  const auto corner = [](const ConvexHull& hull, const std::vector<Vector3>& placed,
                         std::int32_t side) {
    return placed[static_cast<std::size_t>(hull.halfEdges[static_cast<std::size_t>(side)].origin)];
  };
  for (int i = 0; i < 300; ++i) {
    const Pose A = random.pose(2), B = random.pose(2);
    const Separation s = signedDistance(Shape(a), A, Shape(b), B);
    if (s.separation <= 0) continue;
    std::vector<Vector3> p, q;
    for (const Vector3& v : a.vertices) p.push_back(pointToWorld(A, v));
    for (const Vector3& v : b.vertices) q.push_back(pointToWorld(B, v));
    Real squared = kInfinity;
    for (const HullEdge& e : a.edges) {
      for (const HullEdge& f : b.edges) {
        squared = std::min(
            squared,
            closestPoints(p[static_cast<std::size_t>(e.from)], p[static_cast<std::size_t>(e.to)],
                          q[static_cast<std::size_t>(f.from)], q[static_cast<std::size_t>(f.to)])
                .squared);
      }
    }
    const auto faces = [&](const ConvexHull& hull, const std::vector<Vector3>& placed,
                           const std::vector<Vector3>& points) {
      for (const HullFace& face : hull.faces) {
        for (std::int32_t k = 1; k + 1 < face.count; ++k) {
          for (const Vector3& x : points) {
            const Vector3 near =
                closestOnTriangle(x, corner(hull, placed, face.firstHalfEdge),
                                  corner(hull, placed, face.firstHalfEdge + k),
                                  corner(hull, placed, face.firstHalfEdge + k + 1));
            squared = std::min(squared, (x - near).squaredNorm());
          }
        }
      }
    };
    faces(a, p, q);
    faces(b, q, p);
    REQUIRE(std::abs(s.separation - std::sqrt(squared)) <= 16 * kUlp);
  }
}

TEST_CASE(
    "cylinders and capsules with parallel axes: beside, above and inside each other, exactly") {
  const Shape wide = Cylinder{2, 1}, thin = Cylinder{0.5, 3}, capsule = Capsule{0.25, 1};
  CHECK(signedDistance(wide, Pose{}, thin, at(3, 4, 0)).separation == 2.5);
  CHECK(signedDistance(wide, Pose{}, thin, at(1, 0, 5)).separation == 1);
  CHECK(signedDistance(wide, Pose{}, thin, at(2.5 + 3, 0, 4 + 4)).separation == 5);
  CHECK(signedDistance(wide, Pose{}, thin, at(0, 0, 0)).separation == -2.5);
  CHECK(signedDistance(thin, Pose{}, wide, at(0, 0, 3.75)).separation == -0.25);
  CHECK(signedDistance(thin, Pose{}, wide, at(0, 0, 3.75)).normal == Vector3(0, 0, 1));
  CHECK(signedDistance(wide, Pose{}, capsule, at(4, 0, 1.5)).separation == 1.75);
  CHECK(signedDistance(capsule, Pose{}, wide, at(0, 0, 0)).separation == -2.25);
  CHECK(signedDistance(capsule, Pose{}, wide, at(0, 0, 0)).status == SeparationStatus::exact);

  CaseNumbers random(38);
  for (int i = 0; i < 2000; ++i) {
    const auto size = [&] { return random.between(0.1, 1.5); };
    ConvexShape a = Cylinder{size(), size()}, b = Capsule{size(), size()};
    if (i % 3 == 0) b = Cylinder{size(), size()};
    if (i % 2 == 0) std::swap(a, b);
    const Pose A = random.pose(1);
    Pose B = A;
    B.p_WB += random.vectorBetween(-2, 2);
    if (i % 4 == 0) B.R_WB.rightCols(2) *= -1;  // head down
    const Separation s = signedDistance(a, A, b, B);
    REQUIRE(s.status == SeparationStatus::exact);
    checkAnswer(a, A, b, B, s, 32 * kUlp);
    for (int k = 0; k < 20 && s.separation < 0; ++k) {
      REQUIRE(reach(a, A, b, B, random.direction()) >= -s.separation - 32 * kUlp);
    }
    // Leaning by a hair, GJK and EPA say the same, to how far the hair moves things.
    const Pose leaning = composed(B, poseOf({1, 1e-9, 0, 0}, {0, 0, 0}));
    REQUIRE(std::abs(signedDistance(a, A, b, leaning).separation - s.separation) <= 1e-8);
  }
}

TEST_CASE("a cylinder that stands on a box, upright or leaning, is as deep as its lowest point") {
  const Shape cylinder = Cylinder{0.5, 0.7}, box = Box{{5, 4, 1}};
  for (const Real depth : {-0.1, -1e-6, 1e-9, 1e-3}) {
    for (const Real lean : {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.7}) {
      const Real height = 1 + 0.7 * std::cos(lean) + 0.5 * std::sin(lean) - depth;
      const Pose pose = poseOf({std::cos(lean / 2), 0, std::sin(lean / 2), 0}, {0.3, 0.2, height});
      const Separation s = signedDistance(box, Pose{}, cylinder, pose);
      CHECK(std::abs(s.separation + depth) <= 1e-14);
      CHECK((s.normal - Vector3(0, 0, 1)).norm() <= 1e-12);
    }
  }
}

TEST_CASE("a cache changes nothing but the time") {
  CaseNumbers random(35);
  for (const ConvexShape& a : zoo()) {
    for (const ConvexShape& b : zoo()) {
      SimplexCache cache;
      Pose A = random.pose(1.2), B = random.pose(1.2);
      int cold = 0, warm = 0;
      for (int step = 0; step < 40; ++step) {
        A.p_WB += Vector3(0.003, -0.002, 0.001);
        const Separation fresh = signedDistance(a, A, b, B);
        const Separation cached = signedDistance(a, A, b, B, &cache);
        const bool curved = isCylinder(a) || isCylinder(b);
        REQUIRE(std::abs(fresh.separation - cached.separation) <= (curved ? 1e-8 : 1e-13));
        cold += fresh.iterations;
        warm += cached.iterations;
      }
      if (isPolyhedron(a) && isPolyhedron(b)) CHECK(warm <= cold);
    }
  }
  // A cache of another pair, or of nonsense, is only a bad start.
  SimplexCache wrong{{7, 1, 500, -1}, {3, 90, 2, 0}, 4, {0, 0, 1}};
  const Shape box = Box{{1, 1, 1}};
  CHECK(signedDistance(box, Pose{}, box, at(5, 0, 0), &wrong).separation == 3);
}

TEST_CASE("bodies in the worst positions: aligned, concentric, huge, tiny, thin, far away") {
  CaseNumbers random(36);
  const Real sizes[] = {1e-9, 1e-3, 1, 1e6};
  for (int i = 0; i < 4000; ++i) {
    const Real size = sizes[i % 4];
    const auto length = [&] { return size * (random.next() % 3 == 0 ? 1e-4 : 1.0); };
    const auto shape = [&]() -> ConvexShape {
      switch (random.next() % 5) {
        case 0:
          return Ball{length()};
        case 1:
          return Box{{length(), length(), length()}};
        case 2:
          return Capsule{length(), length()};
        case 3:
          return Cylinder{length(), length()};
        default:
          return boxHull({length(), length(), length()});
      }
    };
    const ConvexShape a = shape(), b = shape();
    // Positions on a coarse grid, turns by right angles or by a hair, often nothing at all.
    const auto pose = [&] {
      Pose p;
      for (int k = 0; k < 3; ++k) p.p_WB(k) = size * 0.5 * static_cast<Real>(random.next() % 4);
      const auto turn = random.next() % 4;
      const Real angle =
          turn == 0 ? 0 : (turn == 1 ? std::numbers::pi / 2 : (turn == 2 ? 1e-9 : 1));
      const Real s = std::sin(angle / 2), c = std::cos(angle / 2);
      const auto axis = random.next() % 3;
      p.R_WB = poseOf({c, axis == 0 ? s : 0, axis == 1 ? s : 0, axis == 2 ? s : 0}, p.p_WB).R_WB;
      return p;
    };
    const Pose A = pose(), B = pose();
    const Separation s = signedDistance(a, A, b, B);
    INFO("round " << i << ", shapes " << a.index() << " and " << b.index() << ", size " << size);
    REQUIRE(std::isfinite(s.separation));
    REQUIRE(std::abs(s.normal.norm() - 1) <= 8 * kUlp);
    REQUIRE(s.pointA.allFinite());
    REQUIRE(s.pointB.allFinite());
    REQUIRE(s.iterations <= 400);
    const bool curved = isCylinder(a) || isCylinder(b);
    REQUIRE(std::abs(reach(a, A, b, B, s.normal) + s.separation) <=
            (curved ? 1e-6 : 1e-13) * size + s.errorBound);
  }
}

TEST_CASE("bodies of all sizes and shapes against each other, from needles to plates") {
  CaseNumbers random(7);
  for (int i = 0; i < 10000; ++i) {
    const auto size = [&] {
      return random.next() % 4 == 0 ? 1.0 : std::pow(10.0, random.between(-3, 0.5));
    };
    const auto shape = [&]() -> ConvexShape {
      const Real x = size(), y = size(), z = size();
      switch (random.next() % 5) {
        case 0:
          return Ball{x};
        case 1:
          return Box{{x, y, z}};
        case 2:
          return Capsule{x, y};
        case 3:
          return Cylinder{x, y};
        default: {
          // Some of the clouds lie on a grid, with many corners in one plane or line.
          const bool grid = random.next() % 2 == 0;
          std::vector<Vector3> points = boxHull({x, y, z}).vertices;
          for (int k = 0; k < 20; ++k) {
            Vector3 p = random.vectorBetween(-1.5, 1.5);
            if (grid) p = (2 * p).array().round().matrix() / 2;
            points.push_back(p.cwiseProduct(Vector3(x, y, z)));
          }
          return hullOfPoints(points);
        }
      }
    };
    const ConvexShape a = shape(), b = shape();
    const Pose A = random.pose(2);
    Pose B = random.pose(2);
    if (random.next() % 4 == 0) B.R_WB = A.R_WB;
    if (random.next() % 8 == 0) B.p_WB = A.p_WB;
    INFO("round " << i << ", shapes " << a.index() << " and " << b.index());
    const Separation s = signedDistance(a, A, b, B);
    const bool curved = isCylinder(a) || isCylinder(b);
    checkAnswer(a, A, b, B, s, (curved ? 1e-7 : 1e-13) + 2 * s.errorBound);
  }
}

TEST_CASE("poses that are not finite are refused") {
  const Shape box = Box{{1, 1, 1}};
  CHECK_THROWS_WITH(signedDistance(box, at(std::nan(""), 0, 0), box, Pose{}),
                    ContainsSubstring("pose of A"));
  CHECK_THROWS_AS(signedDistance(box, Pose{}, box, at(0, kInfinity, 0)), InvalidInput);
}

TEST_CASE("planar figures in closed form") {
  const Polygon square = makePolygon(std::vector<Vector2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  const PlanarShape box = square, disc = Disc{1};
  const auto place = [](Real x, Real y) { return PlanarPose{1, 0, {x, y}}; };
  CHECK(signedDistance(box, place(0, 0), box, place(5, 0.5)).separation == 3);
  CHECK(signedDistance(box, place(0, 0), box, place(5, 6)).separation == 5);
  CHECK(signedDistance(box, place(0, 0), box, place(1.5, 0.5)).separation == -0.5);
  CHECK(signedDistance(box, place(0, 0), box, place(1.5, 0.5)).normal == Vector2(1, 0));
  CHECK(signedDistance(box, place(0, 0), box, place(2, 0.5)).separation == 0);
  CHECK(signedDistance(disc, place(0, 0), disc, place(3, 4)).separation == 3);
  CHECK(signedDistance(disc, place(0, 0), disc, place(0, 0)).separation == -2);
  CHECK(signedDistance(disc, place(4, 5), box, place(0, 0)).separation == 4);
  CHECK(signedDistance(box, place(0, 0), disc, place(0, 1.5)).separation == -0.5);
  const PlanarShape two = makePlanarCompound({{Disc{1}, place(-3, 0)}, {square, place(3, 0)}});
  CHECK(signedDistance(two, place(0, 0), disc, place(0, 0)).separation == 1);
  CHECK(signedDistance(disc, place(0, 0), two, place(0.5, 0)).normal == Vector2(-1, 0));
}

TEST_CASE("planar polygons with parallel sides show the depth at the sides that overlap") {
  const Polygon square = makePolygon(std::vector<Vector2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  // Its right side shares an axis with both upright sides of the square.
  const Polygon flag = makePolygon(std::vector<Vector2>{{-1, 0.25}, {1, -1}, {1, 1}});
  for (const Polygon& a : {square, flag}) {
    for (const Vector2& place : {Vector2(1.75, 0.25), Vector2(-1.75, 0.25), Vector2(0.25, 1.75),
                                 Vector2(0.25, -1.75), Vector2(0.125, 0), Vector2(-0.125, 0)}) {
      const PlanarPose B{1, 0, place};
      const PlanarSeparation s =
          signedDistance(PlanarShape(a), PlanarPose{}, PlanarShape(square), B);
      CAPTURE(place.x(), place.y(), s.separation);
      REQUIRE(s.separation < 0);
      CHECK(std::abs(closestPoint(PlanarShape(a), PlanarPose{}, s.pointA).distance) <= 16 * kUlp);
      CHECK(std::abs(closestPoint(PlanarShape(square), B, s.pointB).distance) <= 16 * kUlp);
    }
  }
}

TEST_CASE("planar polygons: points, normal and distance prove each other") {
  CaseNumbers random(37);
  int apart = 0, overlapping = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto polygon = [&] {
      std::vector<Vector2> corners;
      const int count = 3 + static_cast<int>(random.next() % 6);
      for (int k = 0; k < count; ++k) {
        const Real angle = (k + random.between(0.1, 0.9)) * 2 * std::numbers::pi / count;
        corners.emplace_back(std::cos(angle), 0.7 * std::sin(angle));
      }
      return makePolygon(corners);
    };
    const Polygon a = polygon(), b = polygon();
    const auto pose = [&] {
      return planarPoseOf(random.between(-4, 4),
                          {random.between(-1.3, 1.3), random.between(-1, 1)});
    };
    const PlanarPose A = pose(), B = pose();
    const PlanarSeparation s = signedDistance(PlanarShape(a), A, PlanarShape(b), B);
    (s.separation > 0 ? apart : overlapping) += 1;
    REQUIRE(std::abs(s.normal.norm() - 1) <= 4 * kUlp);
    REQUIRE((s.pointB - s.pointA - s.separation * s.normal).norm() <= 16 * kUlp);
    REQUIRE(std::abs(closestPoint(PlanarShape(a), A, s.pointA).distance) <= 16 * kUlp);
    REQUIRE(std::abs(closestPoint(PlanarShape(b), B, s.pointB).distance) <= 16 * kUlp);
    const auto way = [&](const Vector2& n) {
      return n.dot(pointToWorld(A, supportOf(a, directionToBody(A, n)).point) -
                   pointToWorld(B, supportOf(b, directionToBody(B, -n)).point));
    };
    REQUIRE(std::abs(way(s.normal) + s.separation) <= 16 * kUlp);
    for (int k = 0; k < 20 && s.separation < 0; ++k) {
      const Real angle = random.between(-4, 4);
      REQUIRE(way({std::cos(angle), std::sin(angle)}) >= -s.separation - 16 * kUlp);
    }
  }
  CHECK(apart > 500);
  CHECK(overlapping > 500);
}

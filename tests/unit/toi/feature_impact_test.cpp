// A vertex against a face, an edge against an edge.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/toi/contact_filter.hpp"
#include "carom/toi/exact_contact.hpp"
#include "carom/toi/feature_impact.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

bool isHit(const FeatureImpact& result) {
  return result.impact.status == ImpactStatus::kHit;
}

FeatureImpact impactOf(FeaturePair pair, const MovingPoints& points) {
  return pair == FeaturePair::kVertexFace ? vertexFaceImpact(points) : edgeEdgeImpact(points);
}

MovingPoints permuted(const MovingPoints& points, const std::array<std::size_t, 4>& order) {
  MovingPoints result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.start[i] = points.start[order[i]];
    result.end[i] = points.end[order[i]];
  }
  return result;
}

// Points that do not move but for the first one.
MovingPoints onlyFirstMoves(const Vector3& from, const Vector3& to, const Vector3& p1,
                            const Vector3& p2, const Vector3& p3) {
  return {{from, p1, p2, p3}, {to, p1, p2, p3}};
}

// --- Families of queries, from easy to as degenerate as they come

Vector3 gridPoint(Random& random, int size) {
  const int x = random.integer(0, size), y = random.integer(0, size);
  return Vector3(x, y, random.integer(0, size));
}

MovingPoints onGrid(Random& random, int size) {
  MovingPoints points;
  for (auto* places : {&points.start, &points.end}) {
    for (Vector3& p : *places) p = gridPoint(random, size);
  }
  return points;
}

MovingPoints anyMotion(Random& random) {
  MovingPoints points;
  for (auto* places : {&points.start, &points.end}) {
    for (Vector3& p : *places) p = random.vector();
  }
  return points;
}

// One coordinate is nearly or quite the same for all points.
MovingPoints nearlyFlat(Random& random) {
  MovingPoints points = anyMotion(random);
  const Real height = random.integer(0, 2) == 0 ? 0 : std::pow(10.0, -random.integer(3, 18));
  for (auto* places : {&points.start, &points.end}) {
    for (Vector3& p : *places) p.z() = 0.3 + height * p.z();
  }
  return points;
}

// In a plane that is not along an axis, exactly: sums of two vectors with small whole numbers.
MovingPoints inTiltedPlane(Random& random) {
  const Vector3 u = gridPoint(random, 4), v = gridPoint(random, 4);
  MovingPoints points;
  for (auto* places : {&points.start, &points.end}) {
    for (Vector3& p : *places) p = random.integer(-3, 3) * u + random.integer(-3, 3) * v;
  }
  return points;
}

// The first point passes through the middle of the others, or the edges cross, and then a little
// aside: a hit or a miss by rounding errors.
MovingPoints grazing(Random& random) {
  MovingPoints points = anyMotion(random);
  const Real t = random.between(0, 1);
  std::array<Vector3, 4> at = placesAt(points, t);
  const Real s = random.integer(0, 2) == 0 ? 0 : random.between(0, 1);
  const Vector3 onEdge = (1 - s) * at[1] + s * at[2];
  const Real aside = random.integer(0, 2) == 0 ? 0 : std::pow(10.0, -random.integer(10, 18));
  const Vector3 moved = onEdge + aside * random.vector();
  // Point 0 so that it is there at that time.
  points.end[0] = points.start[0] + (moved - points.start[0]) / std::max(t, 0.01);
  return points;
}

// Two points of different features are the same at the start, at the end, or always.
MovingPoints sharingPoints(Random& random) {
  MovingPoints points = random.integer(0, 1) ? anyMotion(random) : onGrid(random, 6);
  const int which = random.integer(0, 3);
  if (which != 1) points.start[0] = points.start[3];
  if (which != 2) points.end[0] = points.end[3];
  if (which == 3) points.start[0].x() = std::nextafter(points.start[0].x(), 7);
  return points;
}

MovingPoints tinyAndHuge(Random& random) {
  MovingPoints points = anyMotion(random);
  const Real scale = std::pow(10.0, random.integer(-60, 60));
  for (auto* places : {&points.start, &points.end}) {
    for (Vector3& p : *places) {
      p *= scale;
      if (random.integer(0, 3) == 0) p.x() *= 1e-30;
    }
  }
  return points;
}

struct Family {
  const char* name;
  std::function<MovingPoints(Random&)> make;
  int count;
};

std::vector<Family> families() {
  return {{"any", anyMotion, 4000},
          {"on a grid of 3", [](Random& r) { return onGrid(r, 2); }, 2000},
          {"on a grid of 9", [](Random& r) { return onGrid(r, 8); }, 2000},
          {"on a line",
           [](Random& r) {
             MovingPoints p = onGrid(r, 5);
             for (auto* places : {&p.start, &p.end}) {
               for (Vector3& x : *places) x = x.x() * Vector3(1, 2, -1);
             }
             return p;
           },
           500},
          {"nearly flat", nearlyFlat, 2000},
          {"in a tilted plane", inTiltedPlane, 1000},
          {"grazing", grazing, 2000},
          {"sharing points", sharingPoints, 1000},
          {"tiny and huge", tinyAndHuge, 500}};
}

}  // namespace

TEST_CASE("T6: a vertex meets a moving face when the cubic says so") {
  const MovingPoints points{{{{0, 0, 1}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}},
                            {{{0.25, 0.5, -1}, {-1, -1, 0.5}, {2, -1, -0.25}, {0, 2, 1.0 / 3}}}};
  const FeatureImpact result = vertexFaceImpact(points);
  REQUIRE(isHit(result));
  // The third of the case is not a double: its root moves by less than the 1e-14 allowed.
  const Real exact = 0.4485981308411214953271028;
  CHECK_THAT(result.impact.time, WithinAbs(exact, 1e-15));
  CHECK_THAT(result.weights[1], WithinAbs(0.25, 1e-14));
  CHECK_THAT(result.weights[2], WithinAbs(0.25, 1e-14));
  CHECK_THAT(result.weights[3], WithinAbs(0.5, 1e-14));
  CHECK(result.impact.gap < 1e-15);
  CHECK(result.impact.normal.z() < -0.5);  // it comes from above
}

TEST_CASE("T7: two edges meet when the cubic says so") {
  const MovingPoints points{{{{-1, 0, 1}, {1, 0, 1}, {0, -1, 0}, {0, 1, 0}}},
                            {{{-1, 0.5, -1}, {1, 0, -0.5}, {0.125, -1, 0}, {0, 1, 0.25}}}};
  const FeatureImpact result = edgeEdgeImpact(points);
  REQUIRE(isHit(result));
  // Here all is exact, so the answer is the reference rounded down.
  const Real exact = 0.5308183932197284319951751;
  CHECK(result.impact.time <= exact);
  CHECK(result.impact.time >= std::nextafter(exact, 0));
  CHECK(result.decidedBy == DecidedBy::kDoubleDouble);
  CHECK(result.impact.gap < 1e-15);
  CHECK(result.impact.normal.z() < -0.5);
}

TEST_CASE("T8: motion in the plane of the face is a hit although the cubic is zero") {
  const FeatureImpact result =
      vertexFaceImpact(onlyFirstMoves({-2, 0, 0}, {2, 0, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}));
  REQUIRE(isHit(result));
  CHECK(result.impact.time == 0.375);
  CHECK(result.decidedBy == DecidedBy::kExact);
  CHECK(result.impact.gap == 0);
  CHECK(result.impact.point == Vector3(-0.5, 0, 0));
}

TEST_CASE("touching is a hit: at a corner, on an edge, at the start and at the end") {
  const Vector3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  for (const Vector3& target : {a, b, c, Vector3(0.5, 0, 0), Vector3(0.5, 0.5, 0)}) {
    const Vector3 above = target + Vector3(0.25, 0.5, 1), below = 2 * target - above;
    CHECK(vertexFaceImpact(onlyFirstMoves(above, below, a, b, c)).impact.time == 0.5);
    const FeatureImpact atEnd = vertexFaceImpact(onlyFirstMoves(above, target, a, b, c));
    CHECK(isHit(atEnd));
    CHECK(atEnd.impact.time == 1);
    const FeatureImpact atStart = vertexFaceImpact(onlyFirstMoves(target, above, a, b, c));
    CHECK(isHit(atStart));
    CHECK(atStart.impact.time == 0);
    // One ulp short of the end is a miss, and so is one ulp beside an edge.
    const Vector3 shortOf(target.x(), target.y(), std::numeric_limits<Real>::denorm_min());
    CHECK_FALSE(isHit(vertexFaceImpact(onlyFirstMoves(above, shortOf, a, b, c))));
  }
  const Vector3 beside(0.5, -std::numeric_limits<Real>::denorm_min(), 1);
  CHECK_FALSE(isHit(vertexFaceImpact(onlyFirstMoves(beside, beside - Vector3(0, 0, 2), a, b, c))));
}

TEST_CASE("triangles and edges without extent are points and segments") {
  const Vector3 up(0, 0, 1), down(0, 0, -1), o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
  // A triangle that is a segment, and one that is a point.
  CHECK(vertexFaceImpact(onlyFirstMoves(up, down, -x, x, x)).impact.time == 0.5);
  CHECK(vertexFaceImpact(onlyFirstMoves(up, down, -x, 2 * x, x)).impact.time == 0.5);
  CHECK(vertexFaceImpact(onlyFirstMoves(up, down, o, o, o)).impact.time == 0.5);
  CHECK_FALSE(isHit(vertexFaceImpact(onlyFirstMoves(up + y, down + y, -x, x, x))));
  CHECK_FALSE(isHit(vertexFaceImpact(onlyFirstMoves(up, down, x, x, x))));
  // Edges: a point against a segment, two points, collinear ones, parallel ones.
  const MovingPoints pointOnEdge{{{up, up, -x, x}}, {{down, down, -x, x}}};
  CHECK(edgeEdgeImpact(pointOnEdge).impact.time == 0.5);
  const MovingPoints twoPoints{{{up, up, o, o}}, {{down, down, o, o}}};
  CHECK(edgeEdgeImpact(twoPoints).impact.time == 0.5);
  const MovingPoints inARow{{{-3 * x, -2 * x, o, x}}, {{x, 2 * x, o, x}}};
  CHECK(edgeEdgeImpact(inARow).impact.time == 0.5);
  const MovingPoints parallel{{{up - x, up + x, o, 3 * x}}, {{down - x, down + x, o, 3 * x}}};
  CHECK(edgeEdgeImpact(parallel).impact.time == 0.5);
  const MovingPoints passing{{{up - x, up, y, y + x}}, {{down - x, down, y, y + x}}};
  CHECK_FALSE(isHit(edgeEdgeImpact(passing)));
}

TEST_CASE("all points at one place touch at once, and nothing moving stays apart") {
  const Vector3 o(0.1, 0.2, 0.3), x(1, 0, 0);
  for (const FeaturePair pair : {FeaturePair::kVertexFace, FeaturePair::kEdgeEdge}) {
    CHECK(isHit(impactOf(pair, {{{o, o, o, o}}, {{o, o, o, o}}})));
    const MovingPoints still{{{o, x, 3 * x + o, 2 * x}}, {{o, x, 3 * x + o, 2 * x}}};
    CHECK_FALSE(isHit(impactOf(pair, still)));
  }
}

TEST_CASE("features that touch at a double root of the cubic and part again are found") {
  // An edge along y, and one above it that tilts and grows: (2 t - 1)^2 times a positive number is
  // the height between them. The ends of the second one:
  const Vector3 c0(-1, 0, -3), c1(-1, 0, 1), d0(1, 0, 4), d1(2, 0, -1), y(0, 1, 0), o(0, 0, 0);
  CHECK(edgeEdgeImpact({{{-y, y, c0, d0}}, {{-y, y, c1, d1}}}).impact.time == 0.5);
  // The same height between a vertex and a triangle.
  const MovingPoints face{{{o, c0 - y, d0 - y, c0 + 3 * y}}, {{o, c1 - y, d1 - y, c1 + 3 * y}}};
  CHECK(vertexFaceImpact(face).impact.time == 0.5);
  // 1e-12 m higher it is a miss, 1e-12 m lower a hit before that.
  const Vector3 up(0, 0, 0x1p-40);
  CHECK_FALSE(isHit(edgeEdgeImpact({{{-y, y, c0 + up, d0 + up}}, {{-y, y, c1 + up, d1 + up}}})));
  const FeatureImpact lower =
      edgeEdgeImpact({{{-y, y, c0 - up, d0 - up}}, {{-y, y, c1 - up, d1 - up}}});
  CHECK(isHit(lower));
  CHECK(lower.impact.time < 0.5);
  CHECK(lower.impact.time > 0.5 - 0x1p-19);
}

TEST_CASE("doubles with error bounds say what whole numbers say, or leave it open") {
  for (const Family& family : families()) {
    Random random(31);
    int hits = 0, open = 0;
    for (int i = 0; i < family.count; ++i) {
      const MovingPoints points = family.make(random);
      for (const FeaturePair pair : {FeaturePair::kVertexFace, FeaturePair::kEdgeEdge}) {
        CAPTURE(family.name, i, static_cast<int>(pair));
        const std::optional<Real> exact = exactFirstContact(pair, points);
        hits += exact.has_value();
        if (axisKeepsApart(pair, points)) REQUIRE_FALSE(exact);
        const Filtered filtered = filterContact(pair, points);
        if (filtered.verdict == FilterVerdict::kMiss) REQUIRE_FALSE(exact);
        if (filtered.verdict == FilterVerdict::kHit) REQUIRE(exact == filtered.time);
        open += filtered.verdict == FilterVerdict::kOpen;
        const FeatureImpact result = impactOf(pair, points);
        REQUIRE(isHit(result) == exact.has_value());
        if (exact) REQUIRE(result.impact.time == *exact);
      }
    }
    CAPTURE(family.name, hits, open);
    CHECK(hits > 0);
    // What the filter is for.
    if (family.name == std::string("any")) CHECK(open == 0);
  }
}

TEST_CASE("the order of corners, of the ends of an edge, and of the edges does not matter") {
  for (const Family& family : families()) {
    Random random(32);
    for (int i = 0; i < family.count / 10; ++i) {
      const MovingPoints points = family.make(random);
      const FeatureImpact face = vertexFaceImpact(points), edges = edgeEdgeImpact(points);
      CAPTURE(family.name, i);
      for (const std::array<std::size_t, 4>& order :
           {std::array<std::size_t, 4>{0, 2, 3, 1}, {0, 1, 3, 2}}) {
        const FeatureImpact other = vertexFaceImpact(permuted(points, order));
        REQUIRE(isHit(other) == isHit(face));
        REQUIRE(other.impact.time == face.impact.time);
      }
      for (const std::array<std::size_t, 4>& order :
           {std::array<std::size_t, 4>{1, 0, 2, 3}, {0, 1, 3, 2}, {2, 3, 0, 1}}) {
        const FeatureImpact other = edgeEdgeImpact(permuted(points, order));
        REQUIRE(isHit(other) == isHit(edges));
        REQUIRE(other.impact.time == edges.impact.time);
      }
    }
  }
}

TEST_CASE("the point of contact is on both features, and the normal is square to them") {
  Random random(33);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const MovingPoints points = anyMotion(random);
    for (const FeaturePair pair : {FeaturePair::kVertexFace, FeaturePair::kEdgeEdge}) {
      const FeatureImpact result = impactOf(pair, points);
      if (!isHit(result)) continue;
      ++hits;
      const std::array<Vector3, 4> at = placesAt(points, result.impact.time);
      const std::size_t ofA = pair == FeaturePair::kVertexFace ? 1 : 2;
      Vector3 a = Vector3::Zero(), b = Vector3::Zero(), startA = a, startB = a;
      Real sumA = 0, sumB = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Real w = result.weights[k];
        REQUIRE(w >= 0);
        (k < ofA ? a : b) += w * at[k];
        (k < ofA ? startA : startB) += w * points.start[k];
        (k < ofA ? sumA : sumB) += w;
      }
      CAPTURE(i, result.impact.gap);
      REQUIRE_THAT(sumA, WithinAbs(1, 1e-15));
      REQUIRE_THAT(sumB, WithinAbs(1, 1e-15));
      REQUIRE((a - b).norm() < 1e-13);
      REQUIRE((b - result.impact.point).norm() < 1e-15);
      REQUIRE_THAT(result.impact.normal.norm(), WithinAbs(1, 1e-15));
      const Vector3 edge = at[ofA == 1 ? 2 : 1] - at[ofA == 1 ? 1 : 0];
      REQUIRE(std::abs(result.impact.normal.dot(edge)) < 1e-13);
      REQUIRE(std::abs(result.impact.normal.dot(at[3] - at[2])) < 1e-13);
      // B was on the side that the normal points to.
      REQUIRE(result.impact.normal.dot(startB - startA) > 0);
    }
  }
  CHECK(hits > 300);
}

TEST_CASE("queries that are not finite are refused by name") {
  MovingPoints points{{{{0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                      {{{0, 0, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  points.end[2].y() = std::numeric_limits<Real>::infinity();
  CHECK_THROWS_AS(vertexFaceImpact(points), InvalidInput);
  CHECK_THROWS_WITH(edgeEdgeImpact(points), ContainsSubstring("end = (1, inf, 0) must be finite"));
  points.end[2].y() = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(vertexFaceImpact(points), InvalidInput);
  CHECK_THROWS_AS(exactFirstContact(FeaturePair::kEdgeEdge, points), InvalidInput);
}

// Boxes along the axes: equations 23 and 24, put right.

#include <limits>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/aabb.hpp"
#include "carom/detection/aabb_of_points.hpp"
#include "carom/detection/aabb_overlap.hpp"
#include "detection_reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

Aabb<3> boxOf(const Vector3& low, const Vector3& high) {
  return {low, high};
}

}  // namespace

TEST_CASE("the box of points far from the origin does not hold the origin") {
  const std::vector<Vector3> points = {{5, -6, 7}, {6, -8, 9}, {5.5, -7, 8}};
  const Aabb<3> box = aabbOfPoints(points);
  CHECK(box.low == Vector3(5, -8, 7));
  CHECK(box.high == Vector3(6, -6, 9));
}

TEST_CASE("the box of one point is the point") {
  const std::vector<Vector3> one = {{-1, 2, -3}};
  CHECK(aabbOfPoints(one).low == one[0]);
  CHECK(aabbOfPoints(one).high == one[0]);
}

TEST_CASE("no points, and points that are not numbers, have no box") {
  CHECK_THROWS_AS(aabbOfPoints({}), InvalidInput);
  const std::vector<Vector3> bad = {{0, 0, 0}, {0, kNan, 0}};
  CHECK_THROWS_WITH(aabbOfPoints(bad), ContainsSubstring("point = (0, nan, 0)"));
}

TEST_CASE("boxes overlap only if they do on all three axes") {
  const Aabb<3> unit = boxOf({0, 0, 0}, {1, 1, 1});
  CHECK(aabbOverlap(unit, boxOf({0.5, 0.5, 0.5}, {2, 2, 2})) == Verdict::overlapping);
  CHECK(aabbOverlap(unit, unit) == Verdict::overlapping);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 away = 5 * Vector3::Unit(axis);
    CHECK(aabbOverlap(unit, boxOf(away, away + Vector3::Ones())) == Verdict::separated);
    CHECK(aabbOverlap(unit, boxOf(-away, Vector3::Ones() - away)) == Verdict::separated);
  }
}

TEST_CASE("boxes touch if they meet everywhere and one axis only just") {
  const Aabb<3> unit = boxOf({0, 0, 0}, {1, 1, 1});
  // The two counterexamples to the source's rule: a shared face, and equality on x while 4 apart.
  CHECK(aabbOverlap(unit, boxOf({1, 0, 0}, {2, 1, 1})) == Verdict::touching);
  CHECK(aabbOverlap(unit, boxOf({1, 5, 0}, {2, 6, 1})) == Verdict::separated);
  CHECK(aabbOverlap(unit, boxOf({1, 1, 1}, {2, 2, 2})) == Verdict::touching);
  CHECK(aabbOverlap(boxOf({1, 0, 0}, {2, 1, 1}), unit) == Verdict::touching);
}

TEST_CASE("a box that lies deep inside another overlaps it") {
  CHECK(aabbOverlap(boxOf({0, 0, 0}, {9, 9, 9}), boxOf({4, 4, 4}, {5, 5, 5})) ==
        Verdict::overlapping);
}

TEST_CASE("D16: of 499,500 pairs of boxes 441 overlap and 749 meet") {
  const json expected = detectionCase("D16");
  CaseNumbers random(5);
  std::vector<Aabb<3>> boxes;
  for (int i = 0; i < expected["boxes"].get<int>(); ++i) {
    Aabb<3> box;
    for (int k = 0; k < 3; ++k) box.low(k) = static_cast<Real>(random.next() % 100);
    for (int k = 0; k < 3; ++k) {
      box.high(k) = box.low(k) + 1 + static_cast<Real>(random.next() % 10);
    }
    boxes.push_back(box);
  }
  int strict = 0, closed = 0, fast = 0, bySource = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Verdict verdict = aabbOverlap(boxes[i], boxes[j]);
      strict += verdict == Verdict::overlapping;
      closed += verdict != Verdict::separated;
      fast += meets(boxes[i], boxes[j]);
      bool orRule = true;  // equation 23 as printed
      for (int k = 0; k < 3; ++k) {
        orRule =
            orRule && (boxes[i].high(k) > boxes[j].low(k) || boxes[j].high(k) > boxes[i].low(k));
      }
      bySource += orRule;
    }
  }
  CHECK(strict == expected["strict"].get<int>());
  CHECK(closed == expected["closed"].get<int>());
  CHECK(fast == closed);
  CHECK(bySource == expected["by the source's OR"].get<int>());
}

TEST_CASE("a box whose corner is not a number is refused") {
  CHECK_THROWS_AS(aabbOverlap(boxOf({0, kNan, 0}, {1, 1, 1}), boxOf({0, 0, 0}, {1, 1, 1})),
                  InvalidInput);
  // Infinite sides are those of a half-space, and welcome.
  CHECK(aabbOverlap(boxOf({-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, 0}),
                    boxOf({0, 0, -1}, {1, 1, 1})) == Verdict::overlapping);
}

TEST_CASE("an empty box takes the first point that joins it") {
  const Aabb<2> box = joined(joined(Aabb<2>{}, Vector2(3, 4)), Vector2(-1, 5));
  CHECK(box.low == Vector2(-1, 4));
  CHECK(box.high == Vector2(3, 5));
  CHECK(holds(box, joined(Aabb<2>{}, Vector2(0, 4.5))));
  CHECK_FALSE(holds(box, joined(Aabb<2>{}, Vector2(0, 5.5))));
  CHECK_FALSE(meets(Aabb<2>{}, box));
}

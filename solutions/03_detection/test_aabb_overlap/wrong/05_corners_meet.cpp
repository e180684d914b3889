// Exercise 03.test_aabb_overlap: cases that tell a right aabbOverlap() from wrong ones.
// Check it with: ./course check 03.test_aabb_overlap

#include "carom/detection/aabb_overlap.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

// Given: the box with sides of 2 m around a point, and a beam: the same box with other sides.
Aabb<3> boxAt(const Vector3& center, const Vector3& sides = {2, 2, 2}) {
  return {center - sides / 2, center + sides / 2};
}

}  // namespace

TEST_CASE("a gap keeps two boxes apart, whichever axis it is on") {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 away = 5 * Vector3::Unit(axis);
    CHECK(aabbOverlap(boxAt({0, 0, 0}), boxAt(away)) == Verdict::separated);
    CHECK(aabbOverlap(boxAt(away), boxAt({0, 0, 0})) == Verdict::separated);
  }
}

TEST_CASE("a common coordinate on one axis is no contact") {
  CHECK(aabbOverlap(boxAt({0, 0, 0}), boxAt({2, 5, 0})) == Verdict::separated);
}

TEST_CASE("boxes that meet are touching") {
  for (const Vector3& step : {Vector3(2, 2, 2), Vector3(-2, 2, -2)}) {
    CHECK(aabbOverlap(boxAt({0, 0, 0}), boxAt(step)) == Verdict::touching);
  }
}

TEST_CASE("boxes overlap at a corner, one in the other, and as beams that cross") {
  CHECK(aabbOverlap(boxAt({0, 0, 0}), boxAt({1, 1, 1})) == Verdict::overlapping);
  CHECK(aabbOverlap(boxAt({0, 0, 0}), boxAt({0, 0, 0}, {1, 1, 1})) == Verdict::overlapping);
  CHECK(aabbOverlap(boxAt({0, 0, 0}, {9, 1, 1}), boxAt({0, 0, 0}, {1, 9, 1})) ==
        Verdict::overlapping);
}

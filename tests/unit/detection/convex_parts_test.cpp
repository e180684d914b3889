// Concave figures by convex parts: the source's Pacman.

#include <cmath>
#include <numbers>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/convex_parts.hpp"
#include "carom/detection/sat_polygons.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

using Corners = std::vector<Vector2>;

// One half of a Pacman of radius 1 at the origin that looks along x, its jaw open by 45 degrees up
// and down: from the mouth's corner out along the lip, then round the head.
Corners half(Real from, Real to) {
  Corners corners = {{0, 0}};
  for (int i = 0; i <= 12; ++i) {
    const Real angle = (from + (to - from) * i / 12) * std::numbers::pi;
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  return corners;
}

std::vector<Corners> pacman() {
  return {half(0.25, 1), half(1, 1.75)};
}

std::vector<Corners> square(const Vector2& center, Real halfSide) {
  const Real h = halfSide;
  return {{center + Vector2(-h, -h), center + Vector2(h, -h), center + Vector2(h, h),
           center + Vector2(-h, h)}};
}

}  // namespace

TEST_CASE("a morsel in Pacman's open mouth is not bitten, although it lies inside his outline") {
  CHECK(convexParts(pacman(), square({0.7, 0}, 0.1)) == Verdict::separated);
  // His outline without the mouth, as one convex polygon, does overlap it.
  CHECK(satPolygons(half(0.25, 1.75), square({0.7, 0}, 0.1)[0]).verdict == Verdict::overlapping);
}

TEST_CASE("a morsel in the upper jaw overlaps, also if the lower one is given first") {
  std::vector<Corners> parts = pacman();
  CHECK(convexParts(parts, square({0.2, 0.6}, 0.1)) == Verdict::overlapping);
  std::swap(parts[0], parts[1]);
  CHECK(convexParts(parts, square({0.2, 0.6}, 0.1)) == Verdict::overlapping);
  CHECK(convexParts(square({0.2, 0.6}, 0.1), parts) == Verdict::overlapping);
}

TEST_CASE("a morsel across the cut between the halves overlaps") {
  CHECK(convexParts(pacman(), square({-0.5, 0}, 0.1)) == Verdict::overlapping);
}

TEST_CASE("figures touch if two parts touch and none overlap") {
  const std::vector<Corners> staircase = {{{0, 0}, {2, 0}, {2, 1}, {0, 1}},
                                          {{0, 1}, {1, 1}, {1, 2}, {0, 2}}};
  CHECK(convexParts(staircase, square({1.5, 1.5}, 0.5)) == Verdict::touching);
  CHECK(convexParts(staircase, square({1.75, 1.75}, 0.5)) == Verdict::separated);
  CHECK(convexParts(staircase, square({1.25, 1.5}, 0.5)) == Verdict::overlapping);
}

TEST_CASE("a figure without parts is refused") {
  CHECK_THROWS_AS(convexParts({}, square({0, 0}, 1)), InvalidInput);
  CHECK_THROWS_AS(convexParts(square({0, 0}, 1), {}), InvalidInput);
}

#include "carom/core/length.hpp"

#include <limits>

#include "support/catch.hpp"

using namespace carom;

TEST_CASE("the length of (2, 3, 6) is 7, from the smallest doubles to the largest") {
  for (int e = -1074; e <= 1020; e += 3) {
    const Vector3 v(std::ldexp(2, e), std::ldexp(3, e), std::ldexp(-6, e));
    REQUIRE(length(v) == std::ldexp(7, e));
  }
}

TEST_CASE("the length is right where squares stop being safe") {
  // Two components of very different size: their squares leave the doubles one after the other.
  for (int e = -520; e <= 520; e += 2) {
    const Vector3 v(std::ldexp(3, e), std::ldexp(4, e), std::ldexp(1, e - 40));
    REQUIRE(length(v) == std::ldexp(5, e));
  }
}

TEST_CASE("zero has no length and infinity has an infinite one") {
  constexpr Real infinite = std::numeric_limits<Real>::infinity();
  CHECK(length(Vector3::Zero()) == 0);
  CHECK(length(Vector3(1, -infinite, 0)) == infinite);
  CHECK(std::isnan(length(Vector3(1, std::numeric_limits<Real>::quiet_NaN(), 0))));
  const Real largest = std::numeric_limits<Real>::max();
  CHECK(length(Vector3(largest, largest, 0)) == infinite);
  CHECK(length(Vector3(largest, 0, 0)) == largest);
}

TEST_CASE("scaling to one keeps the direction and tells the exponent") {
  int exponent = 0;
  const Vector3 scaled = scaledToOne({3e200, -4e200, 1e190}, &exponent);
  CHECK(scaled.cwiseAbs().maxCoeff() < 1);
  CHECK(scaled.cwiseAbs().maxCoeff() >= 0.5);
  CHECK(std::ldexp(scaled.y(), exponent) == -4e200);
  CHECK(std::ldexp(scaled.z(), exponent) == 1e190);
  CHECK(scaledToOne(Vector3::Zero()).isZero(0));
}

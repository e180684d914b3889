// Exercise 05.test_friction_impulse: cases that tell a right frictionImpulse() from wrong ones.
// Check it with: ./course check 05.test_friction_impulse

#include "carom/impulse/friction_impulse.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

// Given: B slides on the ground, which pushes it up; velocity in m/s, pressure in N s, mass in kg.
Vector3 frictionOnGround(const Vector3& velocity, Real pressure, Real mu, Real mass) {
  return frictionImpulse(velocity, {0, 0, 1}, pressure, mu, mass);
}

// Given: are two impulses equal but for rounding? Right versions round in different ways.
bool isNear(const Vector3& a, const Vector3& b) {
  return (a - b).norm() <= 1e-12 * (1 + b.norm());
}

}  // namespace

TEST_CASE("a fast body slides on: friction is mu times the pressure, against the slip") {
  CHECK(isNear(frictionOnGround({3, -4, 0}, 2, 0.5, 10), {-0.6, 0.8, 0}));
}

TEST_CASE("a slow body is stopped, and no more") {
  CHECK(isNear(frictionOnGround({0.03, -0.04, 0}, 2, 0.5, 10), {-0.3, 0.4, 0}));
}

TEST_CASE("a body that does not slip feels no friction") {
  CHECK(isNear(frictionOnGround({0, 0, 0}, 2, 0.5, 10), {0, 0, 0}));
}

TEST_CASE("what goes along the normal is none of its business") {
  for (const Real along : {-7.0, 7.0}) {
    CHECK(isNear(frictionOnGround({3, -4, along}, 2, 0.5, 10), {-0.6, 0.8, 0}));
  }
}

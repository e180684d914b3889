// Exercise 05.test_friction_impulse: cases that tell a right frictionImpulse() from wrong ones.
// Check it with: ./course check 05.test_friction_impulse

#include "carom/core/todo.hpp"
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

// One case for each thing that a wrong version could get wrong: a name that is a sentence, a
// call, and what it must answer.
TEST_CASE("what does a right version answer?") {
  todo<void>("this case");
  CHECK(isNear(frictionOnGround({0, 0, 0}, 2, 0.5, 10), {0, 0, 0}));
}

// Grader of 05.rolling_friction: balls that are worked out by hand, and any balls, whose axis of
// rolling is known from how the question has been put together.

#include "carom/impulse/rolling_friction.hpp"

#include <algorithm>

#include "graders/solids.hpp"
#include "grading/fields_impulse.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

void ask(const RollingContact& contact, const Vector3& expected, const char* what) {
  GRADE(rollingFriction(contact), expected, within(1e-14, kRounding),
        given("angularVelocity", contact.angularVelocity, "rad/s"), given("normal", contact.normal),
        given("inertia", contact.inertia, "kg m^2"),
        given("normalImpulse", contact.normalImpulse, "N s"), given("arm", contact.arm, "m"),
        unit("N m s"), about(what));
}

struct Drawn {
  RollingContact contact;
  Vector3 axis;  // of the rolling
  Real rate;     // [rad/s]
};

Drawn anyBall(Random& random) {
  const Matrix3 R = anyTurn(random, 0.3, 2.8);
  Drawn drawn;
  drawn.axis = R.col(1);
  drawn.rate = random.between(0.2, 8);
  const Real spin = random.between(-5, 5);
  drawn.contact.angularVelocity = drawn.rate * R.col(1) + spin * R.col(2);
  drawn.contact.normal = R.col(2);
  drawn.contact.inertia = random.between(0.05, 1);
  drawn.contact.normalImpulse = random.between(0.5, 5);
  drawn.contact.arm = random.between(0.05, 0.8);
  return drawn;
}

}  // namespace

TEST_CASE("rolling") {
  const Vector3 up = Vector3::UnitZ();
  ask({{0, 4, 0}, up, 0.5, 2, 0.25}, {0, -0.5, 0}, "a ball rolls along x");
  ask({{0, 8, 0}, up, 0.5, 2, 0.25}, {0, -0.5, 0}, "twice as fast: the same");
  ask({{-3, 4, 0}, up, 0.5, 2, 0.5}, {0.6, -0.8, 0}, "it rolls askew, on a softer table");
  ask({{0, 4, 0}, up, 0.5, 6, 0.25}, {0, -1.5, 0}, "a ball that is pressed on three times as hard");
}

TEST_CASE("stopping") {
  const Vector3 up = Vector3::UnitZ();
  ask({{0, 0.5, 0}, up, 0.5, 2, 0.25}, {0, -0.25, 0}, "half of what the table could do stops it");
  ask({{-0.3, 0.4, 0}, up, 0.5, 2, 0.25}, {0.15, -0.2, 0}, "slow and askew");
  ask({{0, 0, 0}, up, 0.5, 2, 0.25}, {0, 0, 0}, "a ball at rest");
}

TEST_CASE("spinning") {
  const Vector3 up = Vector3::UnitZ();
  ask({{0, 4, 7}, up, 0.5, 2, 0.25}, {0, -0.5, 0}, "it rolls, and spins about the upright axis");
  ask({{-9, 0.5, 0}, {-1, 0, 0}, 0.5, 2, 0.25}, {0, -0.25, 0}, "against a wall, and it stops");
  ask({{0, 0, 7}, up, 0.5, 2, 0.25}, {0, 0, 0}, "it only spins");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Drawn d = anyBall(random);
    const Real size = std::min(d.contact.inertia * d.rate, d.contact.arm * d.contact.normalImpulse);
    ask(d.contact, -size * d.axis, "any ball on any table");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(rollingFriction({{0, 4, 0}, {0, 0, 1}, 0.5, 2, -0.25}), given("arm", -0.25, "m"));
  GRADE_REFUSES(rollingFriction({{0, 4, 0}, {0, 0, 1}, 0, 2, 0.25}),
                given("inertia", 0.0, "kg m^2"));
}

PROBES() {
  Random random(510);
  for (int n = 0; n < 24; ++n) PROBE(rollingFriction(anyBall(random).contact));
}

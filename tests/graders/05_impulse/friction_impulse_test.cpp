// Grader of 05.friction_impulse: slips that are worked out by hand on both sides of the cone, and
// any slips, composed from a direction across the normal and a part along it.

#include "carom/impulse/friction_impulse.hpp"

#include <cmath>

#include "graders/solids.hpp"
#include "grading/fields_impulse.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

// One contact, as the function takes it.
struct Slide {
  Vector3 velocity = Vector3::Zero(), normal = Vector3::UnitZ();
  Real pressed = 0, mu = 0, mass = 1;
};

Vector3 frictionOf(const Slide& s) {
  return frictionImpulse(s.velocity, s.normal, s.pressed, s.mu, s.mass);
}

void ask(const Slide& s, const Vector3& expected, const char* what) {
  const Vector3 velocity = s.velocity, normal = s.normal;
  const Real pressed = s.pressed, mu = s.mu, mass = s.mass;
  GRADE(frictionImpulse(velocity, normal, pressed, mu, mass), expected, within(1e-14, kRounding),
        given("relativeVelocity", velocity, "m/s"), given("normal", normal),
        given("normalImpulse", pressed, "N s"), given("friction", mu),
        given("tangentialMass", mass, "kg"), unit("N s"), about(what));
}

struct Drawn {
  Slide slide;
  Vector3 direction;    // of the slip
  Real toStop, atMost;  // sizes of the impulse
};

// A slip whose direction across the normal is known from how it has been put together.
Drawn anySlide(Random& random) {
  const Matrix3 R = anyTurn(random, 0.3, 2.8);
  const Real speed = random.between(0.3, 3), along = random.between(-3, 3);
  Drawn drawn;
  drawn.direction = R.col(0);
  drawn.slide.normal = R.col(2);
  drawn.slide.velocity = speed * R.col(0) + along * R.col(2);
  drawn.slide.pressed = random.between(0.2, 4);
  drawn.slide.mu = random.between(0.1, 1.3);
  drawn.slide.mass = random.between(0.3, 3);
  drawn.toStop = drawn.slide.mass * speed;
  drawn.atMost = drawn.slide.mu * drawn.slide.pressed;
  return drawn;
}

}  // namespace

TEST_CASE("sliding") {
  const Vector3 up = Vector3::UnitZ();
  ask({{4, 0, 0}, up, 2, 0.25, 1}, {-0.5, 0, 0}, "1 kg at 4 m/s, pressed on with 2 N s");
  ask({{0, -2, 0}, up, 2, 0.25, 1}, {0, 0.5, 0}, "slower and along -y: friction is as large");
  ask({{4, 0, 0}, up, 4, 0.25, 1}, {-1, 0, 0}, "pressed on twice as hard");
  ask({{3, 4, 0}, up, 2, 0.5, 8}, {-0.6, -0.8, 0}, "a heavier body, askew");
  ask({{8, 0, 0}, up, 2, 1.5, 1}, {-3, 0, 0}, "rubber: mu above one");
  ask({{3, 0, 0}, up, 2, 0, 1}, {0, 0, 0}, "perfectly smooth");
}

TEST_CASE("sticking") {
  const Vector3 up = Vector3::UnitZ();
  ask({{0.25, 0, 0}, up, 2, 0.5, 2}, {-0.5, 0, 0},
      "slow: friction could be 1 N s, but half stops it");
  ask({{0, 0.125, 0}, up, 2, 0.5, 2}, {0, -0.25, 0}, "slower still");
  ask({{0.3, -0.4, 0}, up, 2, 1.2, 2}, {-0.6, 0.8, 0}, "rubber, with mu above one");
  ask({{0, 0, 0}, up, 2, 0.5, 2}, {0, 0, 0}, "no slip, no friction");
}

TEST_CASE("across") {
  ask({{4, 0, -3}, {0, 0, 1}, 2, 0.25, 1}, {-0.5, 0, 0}, "it slides, and falls on the floor too");
  ask({{-5, 0.25, 0}, {-1, 0, 0}, 4, 0.5, 2}, {0, -0.5, 0}, "it sticks at a wall");
  ask({{0, 0, -3}, {0, 0, 1}, 2, 0.5, 2}, {0, 0, 0}, "straight down: no slip");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Drawn d = anySlide(random);
    const bool sticks = d.toStop <= d.atMost;
    ask(d.slide, -(sticks ? d.toStop : d.atMost) * d.direction,
        sticks ? "friction is strong enough to stop the slip"
               : "friction is not strong enough to stop the slip");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(frictionOf({{1, 0, 0}, {0, 0, 1}, 1, -0.5, 1}), given("friction", -0.5));
  GRADE_REFUSES(frictionOf({{1, 0, 0}, {0, 0, 1}, 1, 0.5, 0}), given("tangentialMass", 0.0, "kg"));
}

PROBES() {
  Random random(509);
  for (int n = 0; n < 24; ++n) PROBE(frictionOf(anySlide(random).slide));
}

// Grader of 05.effective_mass: balls and rods whose masses can be worked out by hand, and bodies
// that are pushed apart along their own axes, one after the other.

#include "carom/impulse/effective_mass.hpp"

#include <limits>

#include "graders/05_impulse/bodies.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

BodyMass body(Real inverseMass, const Vector3& inverseMoments) {
  return {inverseMass, inverseMoments.asDiagonal()};
}

void ask(const BodyMass& a, const BodyMass& b, const Contact& contact, Real expected,
         const Within& within, const char* what) {
  GRADE(
      effectiveMass(a, b, contact), expected, within, given("a.inverseMass", a.inverseMass, "1/kg"),
      given("a.inverseInertia", a.inverseInertia, "1/(kg m^2)"),
      given("b.inverseMass", b.inverseMass, "1/kg"),
      given("b.inverseInertia", b.inverseInertia, "1/(kg m^2)"), given("normal", contact.normal),
      given("armA", contact.armA, "m"), given("armB", contact.armB, "m"), unit("kg"), about(what));
}

const Contact central{{1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};

}  // namespace

TEST_CASE("centres") {
  const BodyMass light = body(0.5, {2, 2, 2}), heavy = body(0.25, {4, 4, 4}), wall;
  ask(light, heavy, central, 4.0 / 3, within(1e-15, kRounding),
      "balls of 2 kg and 4 kg, hit through their centres");
  ask(wall, heavy, central, 4, within(1e-15, kRounding), "A is a wall");
  ask(heavy, light, central, 4.0 / 3, within(1e-15, kRounding), "the two exchanged");
}

TEST_CASE("rod") {
  // A rod of 3 kg and 2 m along x: I = 1 kg m^2 across, and next to nothing along.
  const BodyMass rod = body(1.0 / 3, {200, 1, 1}), ball = body(1, {2.5, 2.5, 2.5});
  const Contact side{{0, 1, 0}, {0, 0.25, 0}, {0.8, 0, 0}};
  ask(ball, rod, side, 1 / (1 + 1.0 / 3 + 0.64), within(1e-15, kRounding),
      "a rod along x, hit across at 0.8 m from its centre by a ball of 1 kg");
  ask({}, rod, {{0, 0, 1}, {0, 0, 0}, {1, 0, 0}}, 0.75, within(1e-15, kRounding),
      "a rod of 3 kg, pushed across at its end: a quarter of its mass");
  ask({}, rod, {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, 3, within(1e-15, kRounding),
      "the same rod, pushed at its end along its length");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    Solid a = anySolid(random), b = anySolid(random);
    const Contact contact = anyContact(random);
    a.velocity = b.velocity = Velocity{};  // at rest, so that what is left is the change
    const Real speed = partingSpeed(a.change(contact.armA, -contact.normal),
                                    b.change(contact.armB, contact.normal), contact);
    ask(a.moving().mass, b.moving().mass, contact, 1 / speed, withinRelative(1e-13, kRounding),
        "an impulse of 1 N s along the normal parts the points at 1 m/s over this mass");
  }
}

TEST_CASE("refuses") {
  const BodyMass ball = body(1, {2.5, 2.5, 2.5});
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(effectiveMass(ball, ball, {{0, 2, 0}, {0, 0, 0}, {0, 0, 0}}),
                given("normal", Vector3(0, 2, 0)));
  GRADE_REFUSES(effectiveMass(ball, ball, {{0, 1, 0}, {nan, 0, 0}, {0, 0, 0}}),
                given("armA", Vector3(nan, 0, 0), "m"));
}

PROBES() {
  Random random(502);
  for (int n = 0; n < 16; ++n) {
    const Solid a = anySolid(random), b = anySolid(random);
    const Contact contact = anyContact(random);
    PROBE(effectiveMass(a.moving().mass, b.moving().mass, contact));
  }
}

// Grader of 05.spinning_friction: coins that are worked out by hand, and any discs, cut into many
// rings.

#include "carom/impulse/spinning_friction.hpp"

#include <algorithm>
#include <cmath>

#include "grading/fields_impulse.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

void ask(const SpinningContact& contact, Real expected, const Within& within, const char* what) {
  GRADE(spinningFriction(contact), expected, within, given("spin", contact.spin, "rad/s"),
        given("inertia", contact.inertia, "kg m^2"),
        given("normalImpulse", contact.normalImpulse, "N s"), given("friction", contact.friction),
        given("radius", contact.radius, "m"), unit("N m s"), about(what));
}

SpinningContact anyDisc(Random& random) {
  SpinningContact contact;
  contact.spin = random.between(0.5, 30) * (random.integer(0, 1) == 0 ? 1 : -1);
  contact.inertia = random.between(0.01, 0.3);
  contact.normalImpulse = random.between(0.5, 5);
  contact.friction = random.between(0.1, 1.2);
  contact.radius = random.between(0.1, 1.5);
  return contact;
}

// The most that friction can do, ring by ring: the middle of each ring is its arm, its share of
// the pressure is its share of the area, and what is left out of a ring falls with the square of
// its width.
Real allRings(const SpinningContact& contact) {
  constexpr int kRings = 2000;
  Real sum = 0;
  for (int k = 0; k < kRings; ++k) {
    const Real inner = Real(k) / kRings, outer = Real(k + 1) / kRings;
    const Real share = outer * outer - inner * inner;
    sum += contact.friction * share * contact.normalImpulse * (inner + outer) / 2 * contact.radius;
  }
  return sum;
}

}  // namespace

TEST_CASE("fast") {
  ask({50, 1, 3, 0.5, 0.5}, -0.5, within(1e-15, kRounding), "a disc that spins fast");
  ask({20, 1, 3, 0.5, 0.5}, -0.5, within(1e-15, kRounding), "slower: friction is the same");
  ask({50, 1, 3, 0.5, 2}, -2, within(1e-15, kRounding), "a disc four times as large");
}

TEST_CASE("slow") {
  ask({2, 0.125, 3, 0.5, 0.5}, -0.25, within(1e-15, kRounding),
      "friction could be 0.5 N m s, but half of it stops the disc");
  ask({-1, 0.25, 3, 0.5, 0.5}, 0.25, within(1e-15, kRounding), "the same the other way round");
  ask({0, 0.25, 3, 0.5, 0.5}, 0, within(1e-15, kRounding), "a disc at rest");
}

TEST_CASE("any") {
  ask({-50, 1, 3, 0.5, 0.5}, 0.5, within(1e-15, kRounding), "it spins clockwise, and fast");
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const SpinningContact contact = anyDisc(random);
    const Real size = std::min(contact.inertia * std::abs(contact.spin), allRings(contact));
    ask(contact, contact.spin > 0 ? -size : size,
        withinRelative(1e-6, "the disc has been cut into 2000 rings"), "any disc");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(spinningFriction({2, 0.125, 3, 0.5, -0.5}), given("radius", -0.5, "m"));
  GRADE_REFUSES(spinningFriction({2, 0, 3, 0.5, 0.5}), given("inertia", 0.0, "kg m^2"));
}

PROBES() {
  Random random(511);
  for (int n = 0; n < 24; ++n) PROBE(spinningFriction(anyDisc(random)));
}

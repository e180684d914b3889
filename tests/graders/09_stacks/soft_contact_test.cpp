// Grader of 09.soft_contact: springs that are solved by themselves, and loads that hang on them.

#include "carom/solver/soft_contact.hpp"

#include <cmath>
#include <numbers>

#include "grading/fields_solver.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

// The speed after one visit to a row of one body, with no impulse before.
Real speedAfter(const SoftContact& soft, Real x, Real u) {
  return u - soft.massScale * (u + soft.biasRate * x);
}

// The overlap at which a visit gives nothing more, for a force and a mass.
Real sunkUnder(const SoftContact& soft, Real force, Real mass, Real dt) {
  return soft.impulseScale * force * dt / (soft.massScale * mass * soft.biasRate);
}

void askSpring(Real f, Real zeta, Real h, Real x, Real u, const char* what) {
  const Real w = 2 * std::numbers::pi * f;
  GRADE(speedAfter(softContact(f, zeta, h), x, u),
        (u - h * w * w * x) / (1 + 2 * zeta * w * h + h * h * w * w),
        within(1e-12, "a dozen operations"), given("frequency", f, "Hz"),
        given("dampingRatio", zeta), given("dt", h, "s"), given("x", x, "m"), given("u", u, "m/s"),
        unit("m/s"), about(what));
}

void askLoad(Real f, Real zeta, Real h, Real force, Real mass, const char* what) {
  const Real w = 2 * std::numbers::pi * f;
  GRADE(sunkUnder(softContact(f, zeta, h), force, mass, h), force / (mass * w * w),
        withinRelative(1e-10, "a dozen operations"), given("frequency", f, "Hz"),
        given("dampingRatio", zeta), given("dt", h, "s"), given("force", force, "N"),
        given("mass", mass, "kg"), unit("m"), about(what));
}

}  // namespace

TEST_CASE("spring") {
  askSpring(30, 1, 1.0 / 240, -0.01, -0.5, "speed after a step: 1 cm deep, and coming");
  askSpring(2, 0.5, 1.0 / 60, -0.05, 0, "speed after a step: 5 cm deep, and at rest");
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Real f = random.between(1, 60);
    const Real zeta = random.between(0.2, 3);
    const Real x = random.between(-0.05, -0.01);
    const Real u = random.between(-1, -0.1);
    askSpring(f, zeta, 1.0 / 120, x, u, "speed after a step");
  }
}

TEST_CASE("load") {
  askLoad(30, 1, 1.0 / 240, 9.81, 1, "how far a box of 1 kg sinks into the ground");
  Random random(seed() + 1);
  for (int n = 0; n < 3; ++n) {
    const Real f = random.between(5, 60);
    const Real zeta = random.between(0.5, 10);
    const Real force = random.between(10, 100);
    askLoad(f, zeta, 1.0 / 120, force, random.between(1, 5), "how far the load sinks");
  }
}

TEST_CASE("swings") {
  askSpring(10, 0, 1.0 / 60, -0.02, 0, "speed after a step, without a damper");
  GRADE(softContact(10, 0, 0.02).biasRate, 50, withinRelative(1e-12, "a division"),
        given("frequency", 10.0, "Hz"), given("dampingRatio", 0.0), given("dt", 0.02, "s"),
        unit("1/s"), about("without a damper biasRate takes away all overlap in one step"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(softContact(0, 1, 0.01), given("frequency", 0.0, "Hz"));
  GRADE_REFUSES(softContact(10, -1, 0.01), given("dampingRatio", -1.0));
  GRADE_REFUSES(softContact(10, 1, 0), given("dt", 0.0, "s"));
}

PROBES() {
  Random random(950);
  for (int n = 0; n < 20; ++n) {
    const Real f = random.between(1, 60);
    const Real zeta = n % 5 == 0 ? 0 : random.between(0.3, 8);
    PROBE(softContact(f, zeta, n % 2 == 0 ? 1.0 / 60 : 1.0 / 240));
  }
}

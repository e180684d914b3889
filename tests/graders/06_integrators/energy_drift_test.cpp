// Grader of 06.energy_drift: on a spring each of the four methods has an energy that can be written
// down.

#include "energy_drift.hpp"

#include <cmath>
#include <limits>

#include "energy_drift_fields.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Reals = std::vector<Real>;

// A row, or one of no numbers where there is none.
EnergyDrift row(const std::vector<EnergyDrift>& table, std::size_t k) {
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  return k < table.size() ? table[k] : EnergyDrift{none, none, none};
}

Reals lengthsIn(const std::vector<EnergyDrift>& table) {
  Reals all;
  for (const EnergyDrift& r : table) all.push_back(r.dt);
  return all;
}

// By what a step multiplies the energy of the spring.
Real factor(StepMethod method, Real h) {
  const Real h2 = h * h, h6 = h2 * h2 * h2;
  return method == StepMethod::kExplicitEuler ? 1 + h2 : 1 - h6 / 72 + h6 * h2 / 576;
}

// The drift of an energy that is multiplied by a factor in each step.
Real driftOf(Real factor, Real h, int steps) {
  Real energy = 1, early = 0, late = 0;
  for (int i = 0; i < steps; ++i) {
    energy *= factor;
    (i < steps / 2 ? early : late) += energy;
  }
  return (late - early) / (steps / 2) / (steps / 2 * h);
}

// The order from the first two rows, of which the second has half the step.
Real powerOfLargest(StepMethod method, Real h, int steps) {
  const std::vector<EnergyDrift> table = energyDrift(method, Reals{h, h / 2}, steps);
  return std::log2(row(table, 0).largest / row(table, 1).largest);
}
Real powerOfDrift(StepMethod method, Real h, int steps) {
  const std::vector<EnergyDrift> table = energyDrift(method, Reals{h, h / 2}, steps);
  return std::log2(row(table, 0).drift / row(table, 1).drift);
}

}  // namespace

TEST_CASE("table") {
  const Reals lengths = {0.05, 0.2, 0.1};
  GRADE(lengthsIn(energyDrift(StepMethod::kVelocityVerlet, lengths, 200)), lengths,
        within(0, "the lengths as they were given"), given("lengths", lengths, "s"),
        given("steps", 200), unit("s"), about("the column dt"));
  // Velocity Verlet's energy is lowest where the spring is slack, by h^2/4.
  GRADE(row(energyDrift(StepMethod::kVelocityVerlet, lengths, 200), 1).largest, 0.01,
        withinRelative(0.02, "no step ends just where the spring is slack"),
        given("lengths", lengths, "s"), given("steps", 200),
        about("velocity Verlet, the second row: largest error of the energy"));
}

TEST_CASE("largest") {
  Random random(seed());
  for (int n = 0; n < 3; ++n) {
    const Reals h = {random.between(0.05, 0.2)};
    GRADE(row(energyDrift(StepMethod::kVelocityVerlet, h, 4000), 0).largest, h[0] * h[0] / 4,
          withinRelative(0.01, "no step ends just where the spring is slack"),
          given("method", inWords(StepMethod::kVelocityVerlet)), given("lengths", h, "s"),
          given("steps", 4000), about("largest error of the energy: dt^2/4"));
    // Along x^2 + v^2 - h x v = 1 the energy is (1 + h x v)/2, and x v is at most 1/(2 - h).
    GRADE(row(energyDrift(StepMethod::kSemiImplicitEuler, h, 4000), 0).largest, h[0] / (2 - h[0]),
          withinRelative(0.01, "no step ends just where it is largest"),
          given("method", inWords(StepMethod::kSemiImplicitEuler)), given("lengths", h, "s"),
          given("steps", 4000), about("largest error of the energy: dt/(2 - dt)"));
    GRADE(row(energyDrift(StepMethod::kExplicitEuler, h, 100), 0).largest,
          std::pow(factor(StepMethod::kExplicitEuler, h[0]), 100) - 1,
          withinRelative(1e-9, "the roundings of the steps"),
          given("method", inWords(StepMethod::kExplicitEuler)), given("lengths", h, "s"),
          given("steps", 100), about("largest error of the energy: (1 + dt^2)^100 - 1"));
  }
}

TEST_CASE("drift") {
  Random random(seed() + 1);
  for (const StepMethod method : {StepMethod::kRk4, StepMethod::kExplicitEuler}) {
    const int steps = method == StepMethod::kRk4 ? 10000 : 100;
    const Reals h = {random.between(0.1, 0.2)};
    GRADE(row(energyDrift(method, h, steps), 0).drift, driftOf(factor(method, h[0]), h[0], steps),
          withinRelative(1e-3, "whether the start belongs to the first half"),
          given("method", inWords(method)), given("lengths", h, "s"), given("steps", steps),
          unit("1/s"), about("drift of the energy"));
  }
  const Reals h = {random.between(0.1, 0.2)};
  for (const StepMethod method : {StepMethod::kVelocityVerlet, StepMethod::kSemiImplicitEuler}) {
    GRADE(row(energyDrift(method, h, 20000), 0).drift, 0,
          within(2e-7, "what is left of a swing that is not over"),
          given("method", inWords(method)), given("lengths", h, "s"), given("steps", 20000),
          unit("1/s"), about("drift of the energy: it swings, and comes back"));
  }
}

TEST_CASE("orders") {
  GRADE(powerOfLargest(StepMethod::kVelocityVerlet, 0.1, 4000), 2, within(0.05, "other powers"),
        given("lengths", Reals{0.1, 0.05}, "s"), given("steps", 4000),
        about("velocity Verlet: the power of dt with which the largest error goes"));
  GRADE(powerOfLargest(StepMethod::kSemiImplicitEuler, 0.1, 4000), 1, within(0.1, "other powers"),
        given("lengths", Reals{0.1, 0.05}, "s"), given("steps", 4000),
        about("semi-implicit Euler: the power of dt with which the largest error goes"));
  GRADE(powerOfDrift(StepMethod::kRk4, 0.2, 1000), 5, within(0.02, "other powers"),
        given("lengths", Reals{0.2, 0.1}, "s"), given("steps", 1000),
        about("RK4: the power of dt with which the drift goes"));
}

TEST_CASE("refuses") {
  const Reals h = {0.1}, none = {0};
  GRADE_REFUSES(energyDrift(StepMethod::kRk4, h, 7), given("steps", 7));
  GRADE_REFUSES(energyDrift(StepMethod::kRk4, none, 8), given("lengths", none, "s"));
}

PROBES() {
  Random random(612);
  const StepMethod methods[] = {StepMethod::kExplicitEuler, StepMethod::kSemiImplicitEuler,
                                StepMethod::kVelocityVerlet, StepMethod::kRk4};
  for (int n = 0; n < 16; ++n) {
    const Reals lengths = {random.between(0.2, 0.4), random.between(0.5, 0.9)};
    PROBE(energyDrift(methods[n % 4], lengths, 2 * random.integer(20, 40)));
  }
}

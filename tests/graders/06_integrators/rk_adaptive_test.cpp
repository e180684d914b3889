// Grader of 06.rk_adaptive: motions whose end is known, a force that jumps, the same motion in
// other units, and how the number of steps goes with the tolerance.

#include "carom/motion/rk_adaptive.hpp"

#include "graders/06_integrators/motions.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const State kStretched = {column({1}), column({0})};

State spring(Real t) {
  return {column({std::cos(t)}), column({-std::sin(t)})};
}

// Nothing acts until 2 s, and 1 m/s^2 from then on.
Acceleration pushedFromTwo() {
  return forceOn(1, [](Real t, const Coordinates&, const Coordinates&) -> Coordinates {
    return column({t < 2 ? 0.0 : 1.0});
  });
}

int tries(const AdaptiveRun& run) {
  return run.accepted + run.rejected;
}

// A planet on an ellipse of eccentricity 0.9 with the sun at the origin, once round, from the end
// that is far from the sun.
AdaptiveRun comet(Real relative) {
  const Acceleration gravity =
      forceOn(2, [](Real, const Coordinates& x, const Coordinates&) -> Coordinates {
        return -x / std::pow(x.squaredNorm(), 1.5);
      });
  const Real e = 0.9;
  const State start = {column({-(1 + e), 0}), column({0, -std::sqrt((1 - e) / (1 + e))})};
  return rkAdaptive(start, 0, 2 * std::acos(-1.0), {relative, 1e-3 * relative, 3000}, gravity);
}

}  // namespace

TEST_CASE("end") {
  Random random(seed());
  for (const Real way : {1.0, -1.0}) {
    const Real start = random.between(-2, 2), end = start + way * random.between(5, 10);
    const Tolerance tolerance = {1e-9, 1e-9, 2000};
    GRADE(rkAdaptive(spring(start), start, end, tolerance, springs(1, 1)).time, end,
          within(0, "it ends at the end"), given("time", start, "s"), given("end", end, "s"),
          unit("s"), about("a spring: what the clock shows at the end"));
    GRADE(rkAdaptive(spring(start), start, end, tolerance, springs(1, 1)).state, spring(end),
          within(1e-6, "a few hundred times the tolerance"), given("time", start, "s"),
          given("end", end, "s"), about("a spring with a = -x: where it is at the end"));
  }
  const MadeUp motion(random, 2);
  GRADE(rkAdaptive(motion.at(1), 1, 4, {1e-9, 1e-9, 2000}, motion.force()).state, motion.at(4),
        within(1e-6, "a few hundred times the tolerance"), given("time", 1.0, "s"),
        given("end", 4.0, "s"), about("a force that depends on time, place and velocity"));
}

TEST_CASE("jump") {
  const State rest = {column({0}), column({0})};
  const Tolerance tolerance = {1e-6, 1e-6, 2000};
  GRADE(rkAdaptive(rest, 0, 5, tolerance, pushedFromTwo()).state,
        State({column({4.5}), column({3})}),
        within(2e-3, "what a last short step over the jump may miss"), given("time", 0.0, "s"),
        given("end", 5.0, "s"), given("tolerance", tolerance),
        about("no force until 2 s, and 1 m/s^2 from then on"));
  GRADE(rkAdaptive(rest, 0, 5, tolerance, pushedFromTwo()).rejected > 2, true,
        within(0, "the jump cannot be met with a long step"),
        about("more than two tries have been thrown away"));
}

TEST_CASE("scale") {
  // The same spring, 2^20 times as large: every number is that many times as large, to the bit.
  const Real size = 1 << 20;
  const State large = {column({size}), column({0})};
  const Tolerance small = {1e-8, 1e-10, 2000}, scaled = {1e-8, 1e-10 * size, 2000};
  const auto accepted = [&] { return rkAdaptive(kStretched, 0, 6, small, springs(1, 1)).accepted; };
  GRADE(rkAdaptive(large, 0, 6, scaled, springs(1, 1)).accepted, accepted(),
        within(0, "a change of the unit"), given("tolerance", scaled),
        about("a spring let go at 1048576 m: as many steps as one let go at 1 m, with an absolute "
              "tolerance as many times larger"));
  GRADE(rkAdaptive(large, 0, 6, small, springs(1, 1)).state.position,
        column({size * std::cos(6.0)}), withinRelative(1e-6, "a hundred times the tolerance"),
        given("tolerance", small), unit("m"),
        about("a spring with a = -x let go at 1048576 m: where it is after 6 s"));
  GRADE(Real(tries(rkAdaptive(large, 0, 6, small, springs(1, 1)))) / accepted(), 1,
        within(0.3, "the absolute tolerance hardly matters for so large a spring"),
        given("tolerance", small),
        about("its tries, divided by the good steps of a spring let go at 1 m"));
}

TEST_CASE("work") {
  // Ten thousand times less error for each step takes steps shorter by 10^(4/5).
  GRADE(Real(comet(1e-10).accepted) / comet(1e-6).accepted, std::pow(10, 0.8),
        within(1, "the fifth power holds for short steps"),
        about("a comet once round the sun: steps with a tolerance of 1e-10, divided by steps "
              "with 1e-6"));
  GRADE(tries(comet(1e-8)), 150, within(50, "the first steps, and nine tenths for safety"),
        about("the comet with a tolerance of 1e-8: tries, good and bad"));
}

TEST_CASE("gives_up") {
  GRADE(rkAdaptive(kStretched, 0, 100, {1e-9, 1e-9, 20}, springs(1, 1)).status ==
            AdaptiveStatus::kTooManySteps,
        true, within(0, "20 tries are not enough"), about("it may try twenty times"));
  GRADE(tries(rkAdaptive(kStretched, 0, 100, {1e-9, 1e-9, 20}, springs(1, 1))), 20,
        within(0, "not one more"), about("how often it has tried then"));
}

TEST_CASE("refuses") {
  const Tolerance none = {1e-9, 0, 100};
  GRADE_REFUSES(rkAdaptive(kStretched, 0, 1, none, springs(1, 1)), given("tolerance", none));
}

PROBES() {
  Random random(607);
  for (int n = 0; n < 16; ++n) {
    const MadeUp motion(random, 1);
    const Real start = random.between(0, 3), end = start + random.between(1, 3);
    PROBE(rkAdaptive(motion.at(start), start, end, {1e-4, 1e-6, 60}, motion.force()));
  }
}

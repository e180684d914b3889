// Grader of 09.sequential_impulses: columns and bars whose impulses follow from momentum.

#include "carom/solver/sequential_impulses.hpp"

#include <cmath>

#include "row_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few dozen operations";

Reals impulsesAfter(BoxColumn scene, int sweeps) {
  sequentialImpulses(scene.bodies, scene.rows, sweeps);
  return impulsesOf(scene);
}

Reals speedsAfter(BoxColumn scene, int sweeps) {
  sequentialImpulses(scene.bodies, scene.rows, sweeps);
  return speedsOf(scene);
}

// A column that has been given impulses already.
BoxColumn pushedBefore(BoxColumn column, const Reals& impulses) {
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    column.rows[i].impulse = impulses[i];
    pushRow(column.rows[i], impulses[i], column.bodies);
  }
  return column;
}

BoxColumn withTargets(BoxColumn column, const Reals& targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) column.rows[i].target = targets[i];
  return column;
}

}  // namespace

TEST_CASE("bar") {
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Real mass = random.between(1, 5);
    const Real speed = random.between(0.5, 2);
    const BoxColumn bar = barOnFeet(mass, {0, 0, -speed}, 0);
    GRADE(impulsesAfter(bar, 80), (Reals{mass * speed / 2, mass * speed / 2}),
          withinRelative(1e-9, kRounding), given("bodies", bar.bodies), given("rows", bar.rows),
          given("sweeps", 80), unit("N s"),
          about("a bar falls flat on two feet: the sums of the rows"));
    GRADE(speedsAfter(bar, 80), Reals{0}, within(1e-9, kRounding), given("bodies", bar.bodies),
          given("rows", bar.rows), given("sweeps", 80), unit("m/s"),
          about("a bar falls flat on two feet: its upward speed afterwards"));
  }
}

TEST_CASE("neighbours") {
  // From below: 1 stops box 1; then box 2 stands on a box at rest and shares its speed with it.
  const BoxColumn two = falling({1, 1});
  GRADE(impulsesAfter(two, 1), (Reals{1, 0.5}), within(1e-12, kRounding),
        given("bodies", two.bodies), given("rows", two.rows), given("sweeps", 1), unit("N s"),
        about("two boxes of 1 kg on the ground fall at 1 m/s: the sums after one sweep"));
  GRADE(speedsAfter(two, 1), (Reals{-0.5, -0.5}), within(1e-12, kRounding),
        given("bodies", two.bodies), given("rows", two.rows), given("sweeps", 1), unit("m/s"),
        about("the upward speeds of both boxes after one sweep"));
  GRADE(impulsesAfter(two, 2), (Reals{1.5, 0.75}), within(1e-12, kRounding),
        given("bodies", two.bodies), given("rows", two.rows), given("sweeps", 2), unit("N s"),
        about("the sums after two sweeps"));
  Random random(seed() + 1);
  for (int n = 0; n < 3; ++n) {
    const Real below = random.between(1, 2);
    const Real above = random.between(1, 2);
    const BoxColumn column = falling({below, above});
    // Of what is missing at the ground, each sweep leaves M / (M + m).
    const Real left = above * std::pow(above / (above + below), 9);
    GRADE(impulsesAfter(column, 10)[0], below + above - left, within(1e-10, kRounding),
          given("bodies", column.bodies), given("rows", column.rows), given("sweeps", 10),
          unit("N s"), about("two boxes: the sum of the row at the ground after ten sweeps"));
  }
}

TEST_CASE("limits") {
  const BoxColumn rising = falling({2, 3}, 1);
  BoxColumn mixed = falling({2, 3});
  mixed.bodies[2].velocity.linear.z() = 4;
  GRADE(impulsesAfter(mixed, 3), (Reals{2, 0}), within(1e-12, kRounding),
        given("bodies", mixed.bodies), given("rows", mixed.rows), given("sweeps", 3), unit("N s"),
        about("the upper box flies off at 4 m/s: only the ground has to push"));
  GRADE(speedsAfter(mixed, 3), (Reals{0, 4}), within(1e-12, kRounding),
        given("bodies", mixed.bodies), given("rows", mixed.rows), given("sweeps", 3), unit("m/s"),
        about("the same: the upward speeds"));
  const BoxColumn bounce = withTargets(falling({2}, -3), {1.5});
  GRADE(impulsesAfter(bounce, 1), Reals{9}, within(1e-12, kRounding),
        given("bodies", bounce.bodies), given("rows", bounce.rows), given("sweeps", 1), unit("N s"),
        about("2 kg at -3 m/s shall part at 1.5 m/s"));
  const BoxColumn gap = withTargets(falling({2}, -3), {-1});
  GRADE(speedsAfter(gap, 2), Reals{-1}, within(1e-12, kRounding), given("bodies", gap.bodies),
        given("rows", gap.rows), given("sweeps", 2), unit("m/s"),
        about("2 kg at -3 m/s above a gap may go on at -1 m/s"));
  const BoxColumn before = pushedBefore(falling({2}, -1), {5});
  GRADE(impulsesAfter(before, 1), Reals{2}, within(1e-12, kRounding),
        given("bodies", before.bodies), given("rows", before.rows), given("sweeps", 1), unit("N s"),
        about("a row that has given 5 N s already, where 2 are enough"));
  GRADE(speedsAfter(rising, 2), (Reals{1, 1}), within(1e-12, kRounding),
        given("bodies", rising.bodies), given("rows", rising.rows), given("sweeps", 2), unit("m/s"),
        about("all boxes rise: nothing has to be done"));
}

TEST_CASE("refuses") {
  const BoxColumn one = falling({1});
  GRADE_REFUSES(impulsesAfter(one, -1), given("sweeps", -1));
}

PROBES() {
  Random random(910);
  for (int n = 0; n < 16; ++n) {
    const Real mass = random.between(1, 3);
    const Real turning = random.between(-8, 8);
    BoxColumn bar = barOnFeet(mass, {0, 0, -random.between(0.5, 1.5)}, turning);
    if (n % 4 == 1) bar.rows[0].target = random.between(-0.5, 0.5);
    PROBE(impulsesAfter(bar, 1 + n % 3));
    PROBE(speedsAfter(bar, 1 + n % 3));
    const BoxColumn column =
        pushedBefore(falling({mass, 2, 1}, n % 2 == 0 ? -1 : -2), {1, mass, 3});
    PROBE(impulsesAfter(column, 1 + n % 2));
  }
}

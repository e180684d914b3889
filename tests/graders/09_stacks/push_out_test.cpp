// Grader of 09.push_out: columns and bars whose way out follows from geometry.

#include "push_out.hpp"

#include "row_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Within kClose = within(1e-9, "sweeps that have converged");

Reals heights(const BoxColumn& scene, Real share, int sweeps) {
  Reals all;
  for (const Velocity& move : pushOut(scene.bodies, scene.rows, share, sweeps)) {
    all.push_back(move.linear.z());
  }
  return all;
}

BoxColumn with(BoxColumn scene, const Reals& separations, const Reals& impulses) {
  for (std::size_t i = 0; i < scene.rows.size(); ++i) {
    scene.rows[i].separation = separations[i];
    scene.rows[i].impulse = impulses[i];
  }
  return scene;
}

void ask(const BoxColumn& scene, Real share, const Reals& expected, const char* what) {
  GRADE(heights(scene, share, 200), expected, kClose, given("bodies", scene.bodies),
        given("rows", scene.rows), given("share", share), given("sweeps", 200), unit("m"),
        about(what));
}

}  // namespace

TEST_CASE("moving") {
  ask(with(falling({2}, 1), {-0.1}, {0}), 0.2, {0, 0.02},
      "10 cm deep, rising at 1 m/s: how far ground and box are moved");
  ask(with(falling({2}, 0), {-0.1}, {3}), 0.2, {0, 0.02},
      "10 cm deep, and has been pushed by 3 N s");
  ask(with(falling({2}, 0), {0.5}, {3}), 0.2, {0, 0}, "free, and has been pushed by 3 N s");
  Random random(seed());
  for (int n = 0; n < 3; ++n) {
    const Real a = random.between(0.01, 0.1), b = random.between(0.01, 0.1);
    ask(with(falling({1, 1.5}, random.between(0.5, 1)), {-a, -b}, {1, 2}), 0.25,
        {0, a / 4, (a + b) / 4}, "two boxes, both overlaps, rising");
  }
}

TEST_CASE("share") {
  ask(with(falling({1, 2}, 0.3), {-0.04, -0.02}, {0, 0}), 0.5, {0, 0.02, 0.03},
      "4 and 2 cm deep, rising, half of it");
  ask(with(falling({1, 2}, 0.3), {-0.04, -0.02}, {0, 0}), 1, {0, 0.04, 0.06},
      "4 and 2 cm deep, rising, all of it");
}

TEST_CASE("gaps") {
  ask(with(falling({1, 2}, 0.3), {-0.04, 0.01}, {0, 0}), 0.5, {0, 0.02, 0.01},
      "1 cm of air between the boxes; the lower one is 4 cm deep, and both rise");
  ask(with(falling({1, 2}, 0.3), {-0.04, 0.03}, {0, 0}), 0.5, {0, 0.02, 0},
      "3 cm of air: the upper box need not be moved, and both rise");
}

TEST_CASE("refuses") {
  GRADE_REFUSES(heights(falling({1}), 2, 1), given("share", 2.0));
}

PROBES() {
  Random random(970);
  for (int n = 0; n < 16; ++n) {
    const Real a = random.between(-0.1, -0.05), b = random.between(-0.03, 0.03);
    const Real speed = n % 3 == 0 ? 0 : random.between(-0.04, 0.04);
    const Real pushed = n % 3 == 1 ? 0 : random.between(0.001, 0.03);
    PROBE(heights(with(falling({1, 2}, speed), {a, b}, {pushed, pushed}), 0.3, 2 + n % 3));
  }
}

// Grader of 09.substep: free fall, overlaps that shrink by a known factor, and towers in balance.

#include "carom/solver/substep.hpp"

#include <cmath>
#include <numbers>

#include "row_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Within kClose = within(1e-11, "some hundred operations");

// A spring of w radians per second with a damper, for parts of h seconds.
SoftContact spring(Real w, Real zeta, Real h) {
  const Real s = h * w * (2 * zeta + h * w);
  return {w / (2 * zeta + h * w), s / (1 + s), 1 / (1 + s)};
}

struct After {
  std::vector<Velocity> moved;
  BoxColumn scene;
};

After after(BoxColumn scene, const SubstepPlan& plan) {
  std::vector<Velocity> moved(scene.bodies.size());
  substep(scene.bodies, scene.rows, moved, plan);
  return {moved, scene};
}

Reals heights(const BoxColumn& scene, const SubstepPlan& plan) {
  Reals all;
  for (const Velocity& move : after(scene, plan).moved) all.push_back(move.linear.z());
  return all;
}

Reals speeds(const BoxColumn& scene, const SubstepPlan& plan) {
  return speedsOf(after(scene, plan).scene);
}

Reals impulses(const BoxColumn& scene, const SubstepPlan& plan) {
  return impulsesOf(after(scene, plan).scene);
}

Reals separations(const BoxColumn& scene, const SubstepPlan& plan) {
  Reals all;
  for (const ContactRow& row : after(scene, plan).scene.rows) all.push_back(row.separation);
  return all;
}

BoxColumn apart(BoxColumn scene, Real gap) {
  for (ContactRow& row : scene.rows) row.separation = gap;
  return scene;
}

// A tower that rests on its springs: each row carries what is above it.
BoxColumn balanced(int n, Real w, Real h) {
  BoxColumn tower = boxColumn(Reals(static_cast<std::size_t>(n), 1));
  for (ContactRow& row : tower.rows) {
    const Real load = 9.81 * (n - row.name);
    row.impulse = load * h;
    row.separation = -load / ((row.name == 0 ? 1 : 0.5) * w * w);
  }
  return tower;
}

}  // namespace

TEST_CASE("fall") {
  Random random(seed());
  for (const int count : {1, 3, 8}) {
    const Real dt = random.between(0.05, 0.2);
    const SubstepPlan plan{.dt = dt, .count = count};
    const BoxColumn box = apart(boxColumn(Reals{2}), 10);
    const Real way = -9.81 * dt * dt * (count + 1) / (2 * count);
    GRADE(heights(box, plan), (Reals{0, way}), kClose, given("plan", plan), unit("m"),
          about("a box falls 10 m above the ground: how far ground and box moved upwards"));
    GRADE(speeds(box, plan), Reals{-9.81 * dt}, kClose, given("plan", plan), unit("m/s"),
          about("a box falls 10 m above the ground: its upward speed"));
  }
}

TEST_CASE("rises") {
  // No gravity: each part leaves the same share of the overlap, and no speed.
  Random random(seed() + 1);
  for (const int count : {1, 4, 6}) {
    const Real h = 0.01;
    const SoftContact soft = spring(random.between(5, 30), 2, h);
    const SubstepPlan plan{
        .gravity = Vector3::Zero(), .dt = h * count, .count = count, .soft = soft};
    const Real deep = random.between(0.01, 0.04);
    const BoxColumn box = apart(boxColumn(Reals{3}), -deep);
    const Real left = deep * std::pow(1 - h * soft.massScale * soft.biasRate, count);
    GRADE(heights(box, plan), (Reals{0, deep - left}), kClose, given("overlap", deep, "m"),
          given("plan", plan), unit("m"), about("out of an overlap, no gravity: how far it moved"));
    GRADE(separations(box, plan), Reals{-left}, kClose, given("overlap", deep, "m"),
          given("plan", plan), unit("m"), about("the separation in the end"));
    GRADE(speeds(box, plan), Reals{0}, kClose, given("overlap", deep, "m"), given("plan", plan),
          unit("m/s"), about("its upward speed in the end"));
  }
}

TEST_CASE("tower") {
  Random random(seed() + 2);
  for (const int n : {2, 5}) {
    const Real h = 1.0 / 240, w = random.between(50, 150);
    const SubstepPlan plan{.dt = 4 * h, .count = 4, .soft = spring(w, 1, h)};
    // It glides as a whole, so that doing nothing is no answer.
    const Real speed = random.between(0.5, 2);
    BoxColumn tower = balanced(n, w, h);
    for (int i = 1; i <= n; ++i) tower.bodies[i].velocity.linear.x() = speed;
    Reals loads;
    for (const ContactRow& row : tower.rows) loads.push_back(row.impulse);
    GRADE(impulses(tower, plan), loads, kClose, given("rows", tower.rows), given("plan", plan),
          unit("N s"), about("a tower that rests on its springs: the impulses in the end"));
    GRADE(heights(tower, plan), Reals(static_cast<std::size_t>(n) + 1, 0), kClose,
          given("rows", tower.rows), given("plan", plan), unit("m"),
          about("a tower that rests on its springs: how far ground and boxes moved upwards"));
    GRADE(after(tower, plan).moved.back().linear, Vector3(speed * plan.dt, 0, 0), kClose,
          given("speed", speed, "m/s"), given("rows", tower.rows), given("plan", plan), unit("m"),
          about("a tower that rests on its springs and glides along x as a whole, at the given "
                "speed: how far the top box moved"));
  }
}

TEST_CASE("turns") {
  BoxColumn bar = apart(barOnFeet(2, {1, 0, 0}, 0.3), 5);
  bar.bodies[0].velocity = {};
  const SubstepPlan plan{.dt = 0.1, .count = 5};
  GRADE(after(bar, plan).moved[1].angular, Vector3(0, 0.03, 0), kClose, given("bodies", bar.bodies),
        given("plan", plan), unit("rad"),
        about("a bar in free flight turns at 0.3 rad/s for 0.1 s"));
  GRADE(after(bar, plan).moved[1].linear.x(), 0.1, kClose, given("bodies", bar.bodies),
        given("plan", plan), unit("m"), about("and flies at 1 m/s along x"));
  GRADE(after(bar, plan).scene.bodies[0].velocity.linear, Vector3(0, 0, 0), kClose,
        given("bodies", bar.bodies), given("plan", plan), unit("m/s"),
        about("the velocity of the ground"));
  GRADE(after(bar, plan).moved[0].linear, Vector3(0, 0, 0), kClose, given("bodies", bar.bodies),
        given("plan", plan), unit("m"), about("how far the ground moved"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(heights(boxColumn(Reals{1}), {.dt = 0}), given("dt", 0.0, "s"));
  GRADE_REFUSES(heights(boxColumn(Reals{1}), {.count = 0}), given("count", 0));
}

PROBES() {
  Random random(960);
  for (int n = 0; n < 8; ++n) {
    const Real h = 1.0 / 240, w = random.between(40, 120);
    const SubstepPlan plan{.dt = 4 * h, .count = 4, .soft = spring(w, 1, h)};
    BoxColumn tower = balanced(3, w, h);
    tower.rows[1].separation -= random.between(0.001, 0.003);
    tower.bodies[2].velocity.linear.x() = random.between(0.1, 1);
    PROBE(heights(tower, plan));
    PROBE(speeds(tower, plan));
    BoxColumn bar = apart(barOnFeet(1, {0, 0, -0.2}, random.between(-1, 1)), -0.01);
    PROBE(after(bar, plan).moved[1].angular);
    PROBE(separations(bar, plan));
  }
}

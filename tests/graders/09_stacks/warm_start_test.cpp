// Grader of 09.warm_start: columns whose weights say what each row must have given.

#include "carom/solver/warm_start.hpp"

#include "row_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Kept = std::vector<KeptImpulse>;

constexpr const char* kRounding = "a handful of operations";

Reals impulsesAfter(BoxColumn scene, const Kept& kept, Real ratio) {
  warmStart(scene.bodies, scene.rows, kept, ratio);
  return impulsesOf(scene);
}

Reals speedsAfter(BoxColumn scene, const Kept& kept, Real ratio) {
  warmStart(scene.bodies, scene.rows, kept, ratio);
  return speedsOf(scene);
}

void ask(const BoxColumn& scene, const Kept& kept, Real ratio, const Reals& impulses,
         const Reals& speeds, const char* what) {
  GRADE(impulsesAfter(scene, kept, ratio), impulses, within(1e-12, kRounding),
        given("rows", scene.rows), given("kept", kept, "N s"), given("ratio", ratio), unit("N s"),
        about((std::string(what) + ": the impulses of the rows").c_str()));
  GRADE(speedsAfter(scene, kept, ratio), speeds, within(1e-12, kRounding),
        given("bodies", scene.bodies), given("rows", scene.rows), given("kept", kept, "N s"),
        given("ratio", ratio), unit("m/s"),
        about((std::string(what) + ": the upward speeds of the boxes").c_str()));
}

BoxColumn withNumbersInIt(BoxColumn column) {
  for (ContactRow& row : column.rows) row.impulse = 7;
  return column;
}

}  // namespace

TEST_CASE("answer") {
  Random random(seed());
  for (int n = 0; n < 3; ++n) {
    const Real below = random.between(1, 3);
    const Real above = random.between(1, 3);
    const Real speed = random.between(0.5, 2);
    const BoxColumn column = falling({below, above}, -speed);
    ask(column, {{0, (below + above) * speed}, {1, above * speed}}, 1,
        {(below + above) * speed, above * speed}, {0, 0},
        "two boxes that rested, and were pulled by gravity");
  }
}

TEST_CASE("names") {
  const BoxColumn column = falling({1, 2, 4});
  ask(column, {{2, 4}, {0, 7}, {1, 6}}, 1, {7, 6, 4}, {0, 0, 0},
      "three boxes; what was kept is in another order");
  ask(column, {{9, 100}, {0, 7}, {1, 6}, {2, 4}}, 1, {7, 6, 4}, {0, 0, 0},
      "a contact that has ended stands first");
}

TEST_CASE("new") {
  // From below: 3 - 0, 0 - 1.5 and 1.5 over the masses.
  const BoxColumn column = withNumbersInIt(boxColumn(Reals{1, 1, 1}));
  ask(column, {{0, 3}, {2, 1.5}}, 1, {3, 0, 1.5}, {3, -1.5, 1.5}, "the row in the middle is new");
}

TEST_CASE("ratio") {
  const BoxColumn column = falling({1, 2}, -0.5);
  ask(column, {{0, 3}, {1, 2}}, 0.5, {1.5, 1}, {0, 0}, "a step half as long");
  const BoxColumn longer = falling({1, 2}, -3);
  ask(longer, {{0, 3}, {1, 2}}, 3, {9, 6}, {0, 0}, "a step three times as long");
}

TEST_CASE("refuses") {
  GRADE_REFUSES(impulsesAfter(falling({1}), {}, -1), given("ratio", -1.0));
}

PROBES() {
  Random random(920);
  for (int n = 0; n < 10; ++n) {
    const Real mass = random.between(1, 3);
    BoxColumn column = falling({mass, 2, 1}, n % 2 == 0 ? -1 : -2);
    for (ContactRow& row : column.rows) row.impulse = random.between(0, 2);
    Kept kept;
    for (int k = 2; k >= 0; --k) {
      if (n % 3 != k) kept.push_back({k, random.between(1, 4)});
    }
    const Real ratio = n < 5 ? 1 : random.between(0.4, 1.8);
    PROBE(impulsesAfter(column, kept, ratio));
    PROBE(speedsAfter(column, kept, ratio));
  }
}

// Grader of 04.carry_impulses: lists of names that are shuffled, shortened and lengthened, so that
// it is known which impulse belongs to which name.

#include "carry_impulses.hpp"

#include <algorithm>

#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kCopied = "impulses are copied";

using Ids = std::vector<std::uint32_t>;
using Reals = std::vector<Real>;

// The impulse that belongs to a name in the random questions: a number that no other name has.
Real impulseOf(std::uint32_t id) {
  return 0.25 + id * 0.001;
}

struct Step {
  Ids before, after;
  Reals impulses, expected;
};

// Some names stay, some go, some are new; both lists in any order.
Step anyStep(Random& random) {
  Step step;
  Ids all;
  for (std::uint32_t k = 0; k < 7; ++k) {
    all.push_back(100 * (k + 1) + static_cast<std::uint32_t>(random.integer(0, 99)));
  }
  const auto shuffle = [&](Ids& ids) {
    for (std::size_t i = ids.size() - 1; i > 0; --i) {
      std::swap(ids[i], ids[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    }
  };
  shuffle(all);
  step.before.assign(all.begin(), all.begin() + 4);
  const auto end = all.end() - random.integer(0, 2);
  step.after.assign(all.begin() + random.integer(1, 2), end);
  shuffle(step.after);
  for (const std::uint32_t id : step.before) step.impulses.push_back(impulseOf(id));
  for (const std::uint32_t id : step.after) {
    const bool known = std::find(step.before.begin(), step.before.end(), id) != step.before.end();
    step.expected.push_back(known ? impulseOf(id) : 0);
  }
  return step;
}

void ask(const Ids& before, const Reals& impulses, const Ids& after, const Reals& expected,
         const char* what) {
  GRADE(carryImpulses(before, impulses, after), expected, within(0, kCopied),
        given("names before", before), given("impulses before", impulses, "N s"),
        given("names now", after), unit("N s"), about(what));
}

}  // namespace

TEST_CASE("shuffled") {
  ask({11, 12, 13, 14}, {3, 1, 1.5, 2.5}, {12, 13, 14, 11}, {1, 1.5, 2.5, 3},
      "the same four points, but the list begins with another one");
  ask({11, 12}, {3, 1}, {12, 11}, {1, 3}, "two points that have changed places in the list");
}

TEST_CASE("gone") {
  ask({11, 12, 13, 14}, {3, 1, 1.5, 2.5}, {13, 14}, {1.5, 2.5}, "the first two points have gone");
  ask({11, 12, 13}, {3, 1, 1.5}, {11, 13}, {3, 1.5}, "a point in the middle has gone");
}

TEST_CASE("new") {
  ask({11, 12}, {3, 1}, {21, 11, 22, 12}, {0, 3, 0, 1}, "two new points, which start from zero");
  ask({11, 12}, {3, 1}, {31, 32}, {0, 0}, "all points are new");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Step step = anyStep(random);
    ask(step.before, step.impulses, step.after, step.expected,
        "some points stay, some go, some come");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(carryImpulses(Ids{11, 12}, Reals{3}, Ids{11}), about("two names and one impulse"));
}

PROBES() {
  Random random(410);
  for (int n = 0; n < 20; ++n) {
    const Step step = anyStep(random);
    PROBE(carryImpulses(step.before, step.impulses, step.after));
  }
}

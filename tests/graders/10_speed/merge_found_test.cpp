// Grader of 10.merge_found: lists whose outcome is written down, and the same impacts dealt anew.

#include "merge_found.hpp"

#include <limits>
#include <set>
#include <tuple>
#include <vector>

#include "grading/grade.hpp"
#include "speed_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Reals = std::vector<Real>;
using Found = std::vector<FoundImpact>;
using Lists = std::vector<Found>;

constexpr const char* kExact = "nothing is computed";

// Time, first body, second body of each, one after the other.
Reals numbersOf(const Found& impacts) {
  Reals all;
  for (const FoundImpact& one : impacts) {
    all.insert(all.end(), {one.time, static_cast<Real>(one.bodyA), static_cast<Real>(one.bodyB)});
  }
  return all;
}

// Different impacts, many of one time, in a random order.
Found someImpacts(Random& random, int count) {
  std::set<std::tuple<int, int, int>> known;
  Found impacts;
  while (static_cast<int>(impacts.size()) < count) {
    const int time = random.integer(1, 3), a = random.integer(0, 4), b = random.integer(5, 9);
    if (!known.insert({time, a, b}).second) continue;
    impacts.push_back({Real(0.25) * time, a, b});
  }
  return impacts;
}

// Deals impacts to lists; some go to two of them, once from each side.
Lists dealt(Random& random, const Found& impacts, int lists) {
  Lists all(static_cast<std::size_t>(lists));
  for (const FoundImpact& one : impacts) {
    const FoundImpact turned = {one.time, one.bodyB, one.bodyA};
    const int kind = random.integer(0, 2);
    const std::size_t first = static_cast<std::size_t>(random.integer(0, lists - 1));
    const std::size_t second = static_cast<std::size_t>(random.integer(0, lists - 1));
    all[first].push_back(kind == 0 ? turned : one);
    if (kind == 2) all[second].push_back(turned);
  }
  return all;
}

// By time and bodies, counted out: no sort.
Reals inOrder(const Found& impacts) {
  Found sorted;
  for (int time = 1; time <= 3; ++time) {
    for (int a = 0; a < 5; ++a) {
      for (int b = 5; b < 10; ++b) {
        for (const FoundImpact& one : impacts) {
          if (one.time == Real(0.25) * time && one.bodyA == a && one.bodyB == b) {
            sorted.push_back(one);
          }
        }
      }
    }
  }
  return numbersOf(sorted);
}

}  // namespace

TEST_CASE("ties") {
  const Lists lists = {{{0.5, 5, 6}}, {{0.5, 1, 2}, {0.25, 7, 8}, {0.5, 1, 3}}};
  GRADE(numbersOf(mergeFound(lists)), (Reals{0.25, 7, 8, 0.5, 1, 2, 0.5, 1, 3, 0.5, 5, 6}),
        within(0, kExact), given("lists", lists),
        about("three impacts at 0.5 s and one before: time and bodies of each, in order"));
}

TEST_CASE("twice") {
  const Lists lists = {{{0.5, 3, 7}, {0.75, 1, 2}}, {{0.25, 0, 1}, {0.5, 3, 7}}};
  GRADE(numbersOf(mergeFound(lists)), (Reals{0.25, 0, 1, 0.5, 3, 7, 0.75, 1, 2}), within(0, kExact),
        given("lists", lists),
        about("two threads have found impact 3-7: time and bodies of each, in order"));
}

TEST_CASE("deal") {
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Found impacts = someImpacts(random, 24);
    const int threads = random.integer(2, 5);
    const Lists lists = dealt(random, impacts, threads);
    GRADE(numbersOf(mergeFound(lists)), inOrder(impacts), within(0, kExact), given("lists", lists),
          about("24 impacts of three times, some found from both sides, in the lists of several "
                "threads: time and bodies of each, in order"));
  }
}

TEST_CASE("refuses") {
  const Lists self = {{{0.5, 3, 3}}};
  const Lists never = {{{std::numeric_limits<Real>::infinity(), 3, 4}}};
  GRADE_REFUSES(numbersOf(mergeFound(self)), given("lists", self));
  GRADE_REFUSES(numbersOf(mergeFound(never)), given("lists", never));
}

PROBES() {
  Random random(1040);
  for (int n = 0; n < 16; ++n) {
    const Found impacts = someImpacts(random, 8 + n);
    PROBE(numbersOf(mergeFound(dealt(random, impacts, 1 + n % 4))));
  }
}

// Grader of 08.wake: towers made by hand, and crowds judged by who can be reached from whom.

#include "carom/world/wake.hpp"

#include "contact_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kWhole = "numbers of bodies are whole numbers";

// The numbers of those that are not asleep after the push.
Numbers awakeAfter(std::int32_t first, const Contacts& contacts, const Flags& movable,
                   Flags asleep) {
  world::wake(first, contacts, movable, asleep);
  Numbers awake;
  for (std::size_t i = 0; i < asleep.size(); ++i) {
    if (asleep[i] == 0) awake.push_back(static_cast<std::int32_t>(i));
  }
  return awake;
}

void ask(std::int32_t first, const Contacts& contacts, const Flags& movable, const Flags& asleep,
         const Numbers& expected, const char* what) {
  GRADE(awakeAfter(first, contacts, movable, asleep), expected, within(0, kWhole),
        given("first", first), given("contacts", contacts), given("movable", movable),
        given("asleep", asleep), about(what));
}

// Those who are awake already are joined with the pushed one, or touch nobody who sleeps.
Numbers byReach(std::int32_t first, const ContactScene& scene) {
  const std::vector<Flags> reached = reachable(scene.contacts, scene.movable);
  Numbers awake;
  for (std::size_t i = 0; i < scene.movable.size(); ++i) {
    if (reached[first][i] != 0) awake.push_back(static_cast<std::int32_t>(i));
  }
  return awake;
}

}  // namespace

TEST_CASE("tower") {
  const Contacts tower = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  const Flags movable = {0, 1, 1, 1, 1}, asleep = {1, 1, 1, 1, 1};
  ask(1, tower, movable, asleep, {1, 2, 3, 4}, "a tower of four on a floor: the lowest is hit");
  ask(4, tower, movable, asleep, {1, 2, 3, 4}, "the same: the one on top is hit");
  ask(2, {{3, 4}, {2, 3}, {1, 2}, {0, 1}}, movable, asleep, {1, 2, 3, 4},
      "the same, contacts from above: the second one is hit");
}

TEST_CASE("ground") {
  const Contacts towers = {{0, 1}, {1, 2}, {0, 3}, {3, 4}};
  const Flags movable = {0, 1, 1, 1, 1}, asleep = {1, 1, 1, 1, 1};
  ask(2, towers, movable, asleep, {1, 2}, "two towers of two on one floor: the first is hit");
  ask(3, towers, movable, asleep, {3, 4}, "the same: the second is hit");
  ask(0, towers, movable, asleep, {}, "the same: the floor is hit");
  ask(1, {{0, 1}, {0, 2}, {1, 3}}, {0, 1, 1, 1, 1}, {0, 1, 1, 1, 1}, {0, 1, 3},
      "a floor whose entry says that it is awake");
}

TEST_CASE("awake") {
  const Contacts chain = {{0, 1}, {1, 2}, {2, 3}};
  const Flags movable(5, 1);
  ask(0, chain, movable, {0, 1, 1, 1, 1}, {0, 1, 2, 3}, "a ball that is awake hits three boxes");
  ask(0, chain, movable, {1, 1, 0, 1, 1}, {0, 1, 2, 3}, "the third of four is awake already");
  ask(3, chain, movable, {0, 0, 0, 0, 1}, {0, 1, 2, 3}, "all that are joined are awake already");
}

TEST_CASE("crowd") {
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    ContactScene scene = anyContacts(random, 30, 24 + 3 * n, 6);
    const int first = random.integer(0, 29);
    scene.movable[first] = 1;
    ask(first, scene.contacts, scene.movable, Flags(30, 1), byReach(first, scene),
        "thirty bodies that sleep; one in six is moved by nothing");
  }
  Contacts backwards;
  Numbers all = {0};
  for (std::int32_t i = 29; i > 0; --i) backwards.push_back({i - 1, i});
  for (std::int32_t i = 1; i < 30; ++i) all.push_back(i);
  ask(0, backwards, Flags(30, 1), Flags(30, 1), all, "a chain of thirty, contacts from its end");
}

PROBES() {
  Random random(880);
  for (int n = 0; n < 24; ++n) {
    ContactScene scene = anyContacts(random, 12, 9 + n % 4, 4);
    const int first = random.integer(0, 11);
    scene.movable[first] = n % 8 == 7 ? 0 : 1;
    Flags asleep(12, 1);
    // Somebody who is joined with the pushed one is awake already.
    const Numbers joined = byReach(first, scene);
    if (n % 3 == 1 && !joined.empty()) asleep[joined[joined.size() / 2]] = 0;
    if (n % 3 == 2 && scene.movable[first] != 0) asleep[first] = 0;
    PROBE(awakeAfter(first, scene.contacts, scene.movable, asleep));
  }
}

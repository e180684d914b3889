// Grader of 08.find_islands: scenes made by hand, and crowds judged by who can be reached from whom.

#include "carom/world/find_islands.hpp"

#include "contact_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kWhole = "numbers of bodies are whole numbers";

// What stood in the list before must not matter.
Numbers islandsOf(const Contacts& contacts, const Flags& movable) {
  Numbers island(movable.size(), 77);
  world::findIslands(contacts, movable, island);
  return island;
}

Numbers byReach(const Contacts& contacts, const Flags& movable) {
  const std::vector<Flags> reached = reachable(contacts, movable);
  Numbers island;
  for (std::size_t i = 0; i < movable.size(); ++i) {
    std::int32_t first = 0;
    while (movable[i] != 0 && reached[i][first] == 0) ++first;
    island.push_back(movable[i] == 0 ? kNone : first);
  }
  return island;
}

void ask(const Contacts& contacts, const Flags& movable, const Numbers& expected,
         const char* what) {
  GRADE(islandsOf(contacts, movable), expected, within(0, kWhole), given("contacts", contacts),
        given("movable", movable), about(what));
}

}  // namespace

TEST_CASE("order") {
  const Flags five(5, 1);
  ask({{0, 1}, {1, 2}, {2, 3}, {3, 4}}, five, {0, 0, 0, 0, 0}, "a chain, from its beginning");
  ask({{3, 4}, {2, 3}, {1, 2}, {0, 1}}, five, {0, 0, 0, 0, 0}, "a chain, from its end");
  ask({{0, 4}, {1, 4}, {2, 3}}, five, {0, 0, 2, 2, 0}, "one body with two neighbours");
  ask({{2, 3}, {0, 1}, {4, 5}, {1, 2}, {2, 3}}, Flags(6, 1), {0, 0, 0, 0, 4, 4},
      "two islands that a late contact joins, and one contact twice");
  ask({{0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {3, 5}}, Flags(7, 1), {0, 0, 0, 0, 0, 0, 6},
      "three bodies on a ring of three");
}

TEST_CASE("ground") {
  ask({{0, 1}, {1, 2}, {0, 3}, {3, 4}}, {0, 1, 1, 1, 1}, {kNone, 1, 1, 3, 3},
      "two towers on one floor, which has the number 0");
  ask({{0, 4}, {1, 4}, {2, 4}, {1, 2}}, {1, 1, 1, 1, 0}, {0, 1, 1, 3, kNone},
      "three boxes on a floor with the number 4; two of them touch");
  ask({{0, 2}, {1, 2}, {1, 3}, {2, 3}}, {1, 0, 1, 0}, {0, kNone, 0, kNone},
      "a corner of two walls that touch");
}

TEST_CASE("names") {
  ask({{2, 5}, {3, 5}, {1, 4}}, Flags(6, 1), {0, 1, 2, 2, 1, 2},
      "two islands, and one body that touches nobody");
  ask({{3, 4}}, {0, 1, 1, 1, 1}, {kNone, 1, 2, 3, 3}, "two that touch among four");
}

TEST_CASE("crowd") {
  Random random(seed());
  for (const int contacts : {20, 30, 40}) {
    const ContactScene scene = anyContacts(random, 40, contacts, 6);
    ask(scene.contacts, scene.movable, byReach(scene.contacts, scene.movable),
        "forty bodies; one in six is moved by nothing");
  }
  Contacts backwards;
  for (std::int32_t i = 39; i > 0; --i) backwards.push_back({i - 1, i});
  ask(backwards, Flags(40, 1), Numbers(40, 0), "a chain of forty, from its end");
}

TEST_CASE("empty") {
  ask({}, {}, {}, "no bodies");
  ask({}, {1, 0, 1}, {0, kNone, 2}, "three bodies that touch nobody");
}

PROBES() {
  Random random(860);
  for (int n = 0; n < 20; ++n) {
    const ContactScene scene = anyContacts(random, 14, 9 + n % 4, 5);
    PROBE(islandsOf(scene.contacts, scene.movable));
  }
}

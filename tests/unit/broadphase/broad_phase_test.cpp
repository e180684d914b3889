// Are the pairs of the broad phase those of trying all pairs, whatever moves, comes and goes?

#include "carom/broadphase/broad_phase.hpp"

#include <array>

#include "boxes.hpp"
#include "carom/broadphase/all_pairs.hpp"
#include "carom/core/errors.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

// The pairs of the boxes with their room, by trying all; immovable ones are no pairs.
std::vector<IndexPair> expectedPairs(const BroadPhase& phase, std::int32_t bodies,
                                     const std::vector<bool>& immovable) {
  std::vector<Aabb<3>> boxes;
  std::vector<std::int32_t> names;
  for (std::int32_t body = 0; body < bodies; ++body) {
    if (!phase.contains(body)) continue;
    boxes.push_back(phase.box(body));
    names.push_back(body);
  }
  std::vector<IndexPair> pairs;
  for (const IndexPair& pair : allPairs(boxes)) {
    if (immovable[names[pair.first]] && immovable[names[pair.second]]) continue;
    pairs.push_back({names[pair.first], names[pair.second]});
  }
  return pairs;
}

}  // namespace

TEST_CASE("the pairs are those of all pairs while bodies move, come and go") {
  const std::uint64_t seed = GENERATE(1, 2);
  const PairSearch search =
      GENERATE(PairSearch::chosen, PairSearch::trees, PairSearch::sweep, PairSearch::grid);
  INFO("seed " << seed << ", search " << static_cast<int>(search));
  Random random(seed);
  const int bodies = 120;
  BroadPhase phase({.search = search});
  std::vector<bool> immovable(bodies);
  std::vector<Vector3> centers(bodies), halves(bodies);
  std::vector<IndexPair> known;
  for (int step = 0; step < 150; ++step) {
    for (int body = 0; body < bodies; ++body) {
      if (!phase.contains(body)) {
        if (random.integer(0, 3) != 0) continue;
        immovable[body] = random.integer(0, 4) == 0;
        centers[body] = random.vector(5);
        halves[body] = random.vector(0.5).cwiseAbs() + Vector3::Constant(0.1);
        phase.add(body, {centers[body] - halves[body], centers[body] + halves[body]},
                  immovable[body] ? Mobility::immovable : Mobility::moving);
      } else if (random.integer(0, 60) == 0) {
        phase.remove(body);
      } else if (!immovable[body] || random.integer(0, 40) == 0) {
        // In some steps all move, in some few.
        if (step % 3 == 1 && body % 20 != 0) continue;
        const Vector3 way = random.vector(step % 5 == 0 ? 1 : 0.1);
        centers[body] += way;
        phase.move(body, {centers[body] - halves[body], centers[body] + halves[body]}, way);
      }
    }
    phase.update();
    // The same pairs, and the events lead from the old ones to the new ones.
    const std::vector<IndexPair> expected = expectedPairs(phase, bodies, immovable);
    REQUIRE(phase.pairs().sorted() == expected);
    for (const BroadPhase::Event& event : phase.ended()) {
      const auto at = std::find(known.begin(), known.end(), event.pair);
      REQUIRE(at != known.end());
      known.erase(at);
    }
    for (const BroadPhase::Event& event : phase.begun()) {
      CHECK(phase.pairs().pair(event.slot) == event.pair);
      known.push_back(event.pair);
    }
    std::sort(known.begin(), known.end());
    REQUIRE(known == expected);
    CHECK(std::is_sorted(phase.begun().begin(), phase.begun().end()));
    CHECK(std::is_sorted(phase.ended().begin(), phase.ended().end()));
    for (int body = 0; body < bodies; ++body) {
      if (!phase.contains(body)) continue;
      CHECK(holds(phase.box(body),
                  Aabb<3>{centers[body] - halves[body], centers[body] + halves[body]}));
    }
  }
}

TEST_CASE("pairs get the same slots for any number of threads") {
  const PairSearch search = GENERATE(PairSearch::chosen, PairSearch::trees, PairSearch::grid);
  INFO("search " << static_cast<int>(search));
  Random random(7);
  KeptThreads threads(3);
  BroadPhase alone({.search = search}), shared({.search = search});
  const auto randomBox = [&] {
    const Vector3 center = random.vector(6);
    return Aabb<3>{center - Vector3::Constant(0.5), center + Vector3::Constant(0.5)};
  };
  const auto accept = [](std::int32_t a, std::int32_t b) { return (a + b) % 7 != 0; };
  for (int step = 0; step < 20; ++step) {
    for (int body = 0; body < 700; ++body) {
      if (step > 0 && step % 4 != 0 && body % 3 != 0) continue;
      const Aabb<3> box = randomBox();
      for (BroadPhase* phase : {&alone, &shared}) {
        if (step == 0) phase->add(body, box, Mobility::moving);
        phase->move(body, box);
      }
    }
    alone.update(accept);
    shared.update(accept, &threads);
    REQUIRE(alone.begun().size() == shared.begun().size());
    for (std::size_t i = 0; i < alone.begun().size(); ++i) {
      REQUIRE(alone.begun()[i].pair == shared.begun()[i].pair);
      REQUIRE(alone.begun()[i].slot == shared.begun()[i].slot);
    }
    REQUIRE(alone.pairs().sorted() == shared.pairs().sorted());
    CHECK(alone.counters().tested == shared.counters().tested);
  }
}

TEST_CASE("bodies of one family are no pairs, and strangers do not look for each other") {
  Random random(5);
  const int bodies = 60;
  BroadPhase phase;
  std::vector<bool> immovable(bodies);
  std::vector<std::uint32_t> families(bodies);
  const auto randomBox = [&] {
    const Vector3 center = random.vector(3);
    return Aabb<3>{center - Vector3::Constant(0.5), center + Vector3::Constant(0.5)};
  };
  for (int step = 0; step < 60; ++step) {
    // Up to step 20 and from 40 on all that move are of family 7; between there are others.
    for (int body = 0; body < bodies; ++body) {
      const bool isOther = body % 10 == 0;
      if (!phase.contains(body)) {
        if (isOther && (step < 20 || step >= 40)) continue;
        immovable[body] = body % 5 == 1;
        families[body] = immovable[body] ? 0u : isOther ? 3u * (body % 20 == 0) : 7u;
        phase.add(body, randomBox(), immovable[body] ? Mobility::immovable : Mobility::moving,
                  families[body]);
      } else if ((isOther && step == 40) || random.integer(0, 50) == 0) {
        phase.remove(body);
      } else if (!immovable[body] || random.integer(0, 20) == 0) {
        phase.move(body, randomBox());
      }
    }
    phase.update();
    std::vector<IndexPair> expected;
    for (const IndexPair& pair : expectedPairs(phase, bodies, immovable)) {
      const std::uint32_t one = families[pair.first], other = families[pair.second];
      if (one == 0 || one != other) expected.push_back(pair);
    }
    REQUIRE(phase.pairs().sorted() == expected);
  }

  // A thousand in one place, all of one family: each is compared with the ground alone.
  BroadPhase crowd;
  crowd.add(0, unitBoxAt(0, 0, 0), Mobility::immovable);
  for (int body = 1; body <= 1000; ++body) {
    crowd.add(body, unitBoxAt(0, 0, 0), Mobility::moving, 1);
  }
  crowd.update();
  const std::int64_t before = crowd.counters().tested;
  for (int body = 1; body <= 1000; ++body) crowd.move(body, unitBoxAt(0.5, 0, 0));
  crowd.update();
  CHECK(crowd.pairs().size() == 1000);
  CHECK(crowd.counters().tested - before <= 2000);  // old pairs, and the search
}

TEST_CASE("few that move right after all have moved do not bring the tree up to date") {
  const int bodies = 100;
  BroadPhase phase;
  for (int body = 0; body < bodies; ++body) {
    phase.add(body, unitBoxAt(2 * body, 0, 0), Mobility::moving);
  }
  phase.update();
  for (int body = 0; body < bodies; ++body) phase.move(body, unitBoxAt(2 * body, 3, 0));
  phase.update();
  const BroadPhaseCounters before = phase.counters();
  phase.move(7, unitBoxAt(12.5, 3, 0));
  phase.update();
  CHECK(phase.counters().byScan == before.byScan + 1);
  CHECK(phase.counters().byTrees == before.byTrees);
  CHECK(phase.counters().visited == before.visited);
  CHECK(phase.counters().tested <= before.tested + bodies + 1);
  CHECK(phase.pairs().sorted() == std::vector<IndexPair>{IndexPair{6, 7}});
  // Who goes on so has the tree.
  for (int k = 0; k < 3; ++k) {
    phase.move(9, unitBoxAt(18, 6 + 3 * k, 0));
    phase.update();
  }
  CHECK(phase.counters().byTrees > before.byTrees);
}

TEST_CASE("the search is chosen by how many bodies move, and how many there are") {
  const auto searches = [](int count, int every) {
    std::vector<Aabb<3>> boxes = gasBoxes(count, 17);
    BroadPhase phase;
    for (int i = 0; i < count; ++i) phase.add(i, boxes[i], Mobility::moving);
    phase.update();
    const BroadPhaseCounters before = phase.counters();
    for (int step = 0; step < 10; ++step) {
      for (int i = 0; i < count; i += every) {
        boxes[i] = {boxes[i].low + Vector3::Ones(), boxes[i].high + Vector3::Ones()};
        phase.move(i, boxes[i]);
      }
      phase.update();
    }
    const BroadPhaseCounters& now = phase.counters();
    return std::array{now.byTrees - before.byTrees, now.bySweep - before.bySweep,
                      now.byGrid - before.byGrid};
  };
  CHECK(searches(300, 1) == std::array<std::int64_t, 3>{0, 10, 0});
  CHECK(searches(2000, 1) == std::array<std::int64_t, 3>{0, 0, 10});
  CHECK(searches(2000, 100) == std::array<std::int64_t, 3>{10, 0, 0});
}

TEST_CASE("the tree of moving bodies is up to date when it is asked for") {
  std::vector<Aabb<3>> boxes = gasBoxes(200, 18);
  BroadPhase phase({.search = PairSearch::sweep});
  for (int i = 0; i < 200; ++i) phase.add(i, boxes[i], Mobility::moving);
  phase.update();
  for (int i = 0; i < 200; ++i) {
    const Vector3 way(0, 0, 100 + i);
    boxes[i] = {boxes[i].low + way, boxes[i].high + way};
    phase.move(i, boxes[i]);
  }
  phase.update();
  for (int i = 0; i < 200; ++i) {
    bool isFound = false;
    phase.overlapMoving(boxes[i], [&](std::int32_t body) { isFound |= body == i; });
    CHECK(isFound);
  }
}

TEST_CASE("what rests costs nothing") {
  BroadPhase phase;
  const std::vector<Aabb<3>> boxes = gasBoxes(2000, 7);
  for (int i = 0; i < 2000; ++i) {
    phase.add(i, boxes[i], i % 2 == 0 ? Mobility::immovable : Mobility::moving);
  }
  phase.update();
  const BroadPhaseCounters before = phase.counters();
  // All say where they are, and two hundred times nothing is looked at.
  for (int step = 0; step < 200; ++step) {
    for (int i = 0; i < 2000; ++i) {
      if (i % 2 == 1) phase.move(i, boxes[i]);
    }
    phase.update();
  }
  CHECK(phase.counters().visited == before.visited);
  CHECK(phase.counters().tested == before.tested);
  CHECK(phase.counters().left == before.left);
  CHECK(phase.counters().updates == before.updates + 200);
}

TEST_CASE("a pair that is not accepted is none, until its bodies are touched") {
  BroadPhase phase;
  phase.add(3, unitBoxAt(0, 0, 0), Mobility::moving);
  phase.add(1, unitBoxAt(0.5, 0, 0), Mobility::moving);
  bool accepted = false;
  const auto accept = [&](std::int32_t a, std::int32_t b) {
    CHECK(a == 1);
    CHECK(b == 3);
    return accepted;
  };
  phase.update(accept);
  CHECK(phase.pairs().size() == 0);
  accepted = true;
  phase.update(accept);
  CHECK(phase.pairs().size() == 0);
  phase.touch(3);
  phase.update(accept);
  CHECK(phase.begun().size() == 1);
  accepted = false;
  phase.touch(1);
  phase.update(accept);
  CHECK(phase.ended().size() == 1);
  CHECK(phase.pairs().size() == 0);
}

TEST_CASE("the ground that reaches to infinity meets all that come near it") {
  BroadPhase phase;
  const Real infinity = std::numeric_limits<Real>::infinity();
  phase.add(0, {Vector3::Constant(-infinity), Vector3(infinity, infinity, 0)}, Mobility::immovable);
  for (int i = 1; i < 50; ++i) phase.add(i, unitBoxAt(3 * i, 0, 1.5 * i - 0.95), Mobility::moving);
  phase.update();
  // Only the first has its lower side within its room of the ground.
  CHECK(phase.pairs().sorted() == std::vector<IndexPair>{IndexPair{0, 1}});
}

TEST_CASE("the broad phase refuses what it cannot work with, and stays as it was") {
  BroadPhase phase;
  phase.add(0, unitBoxAt(0, 0, 0), Mobility::moving);
  Aabb<3> broken = unitBoxAt(0, 0, 0);
  broken.high.y() = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(phase.add(1, broken, Mobility::moving), InvalidInput);
  CHECK_THROWS_AS(phase.move(0, broken), InvalidInput);
  CHECK_THROWS_AS(phase.move(0, Aabb<3>()), InvalidInput);
  CHECK_THROWS_AS(phase.add(0, unitBoxAt(0, 0, 0), Mobility::moving), InvalidInput);
  CHECK_THROWS_AS(phase.add(-1, unitBoxAt(0, 0, 0), Mobility::moving), InvalidInput);
  CHECK_THROWS_AS(phase.remove(5), InvalidInput);
  CHECK_THROWS_AS(phase.touch(5), InvalidInput);
  CHECK_THROWS_AS(BroadPhase({.margin = -1}), InvalidInput);
  phase.update();
  CHECK(phase.pairs().size() == 0);
  CHECK(phase.contains(0));
  CHECK_FALSE(phase.contains(1));
}

// Does a step take memory?

#include "boxes.hpp"
#include "carom/broadphase/broad_phase.hpp"
#include "support/catch.hpp"
#include "support/counted_memory.hpp"

using namespace carom;
using namespace carom_test;

TEST_CASE("a motion that has been seen before takes no memory") {
  const PairSearch search = GENERATE(PairSearch::trees, PairSearch::sweep, PairSearch::grid);
  const std::vector<Aabb<3>> start = gasBoxes(300, 41);
  Random random(42);
  std::vector<Vector3> ways;
  for (int i = 0; i < 300; ++i) ways.push_back(random.vector(0.3));
  BroadPhase phase({.search = search});
  for (int i = 0; i < 300; ++i) phase.add(i, start[i], Mobility::moving);
  const auto swing = [&] {
    // To and fro, in steps of which each leaves the room of many.
    for (int step = 0; step <= 40; ++step) {
      const Real share = step <= 20 ? step : 40 - step;
      for (int i = 0; i < 300; ++i) {
        phase.move(i, {start[i].low + share * ways[i], start[i].high + share * ways[i]});
      }
      phase.update();
    }
  };
  swing();
  swing();
  const std::size_t before = allocations;
  const std::int64_t left = phase.counters().left;
  swing();
  CHECK(allocations == before);
  CHECK(phase.counters().left > left + 1000);
}

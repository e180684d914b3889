// Does a step take memory?

#include <cstdlib>
#include <new>

#include "boxes.hpp"
#include "carom/broadphase/broad_phase.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

std::size_t allocations = 0;

}  // namespace

// Counts who asks for memory. Not inlined: g++ 12 would take them for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

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

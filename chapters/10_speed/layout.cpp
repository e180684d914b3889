// What does it cost to move bodies that lie in memory in one way or the other?
//
// The same bodies, whole and in blocks of four, fall for a while. The table counts the lines of
// memory that each way has to read; the picture shows the times of this machine.

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <vector>

#include "carom/core/lanes.hpp"
#include "carom/core/random.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "soa_layout.hpp"

using carom::BodyBlock;
using carom::Real;
using carom::WholeBody;
using Two = carom::Lanes<Real, 2>;
using Four = carom::Lanes<Real, 4>;

constexpr Real kStep = 1.0 / 60, kGravity = -9.81;
constexpr std::size_t kLine = 64;  // bytes that come from memory at once

std::vector<WholeBody> someBodies(std::size_t count) {
  carom::Random random(10);
  std::vector<WholeBody> bodies(count);
  for (WholeBody& body : bodies) {
    body.position = random.vector(10);
    body.velocity = random.vector();
    body.inverseMass = random.integer(0, 9) == 0 ? 0 : 1;  // one in ten does not move
  }
  return bodies;
}

//! [whole]
void moveWhole(std::vector<WholeBody>& bodies) {
  for (WholeBody& body : bodies) {
    if (!(body.inverseMass > 0)) continue;
    body.velocity[2] += kStep * kGravity;
    for (int k = 0; k < 3; ++k) {
      body.position[k] += kStep * body.velocity[k];
    }
  }
}
//! [whole]

//! [blocks]
// S is a number, or lanes of them.
template <class S>
void moveBlocks(std::vector<BodyBlock>& blocks) {
  using carom::everywhere, carom::loaded, carom::select, carom::store;
  const S zero = everywhere<S>(0), step = everywhere<S>(kStep);
  const S pull = everywhere<S>(kStep * kGravity);
  constexpr std::size_t kLanes = carom::LaneTraits<S>::kCount;
  for (BodyBlock& block : blocks) {
    for (std::size_t i = 0; i < carom::kBlockLanes; i += kLanes) {
      const auto moves = loaded<S>(&block.inverseMass.x[i]) > zero;
      Real* down = &block.velocity[2].x[i];
      const S slow = loaded<S>(down);
      store(select(moves, slow + pull, slow), down);
      for (std::size_t k = 0; k < 3; ++k) {
        Real* at = &block.position[k].x[i];
        const S old = loaded<S>(at);
        const S next = old + step * loaded<S>(&block.velocity[k].x[i]);
        store(select(moves, next, old), at);
      }
    }
  }
}
//! [blocks]

// Lines that a pass reads, if the first body begins a line: those of what it asks for.
std::size_t linesWhole(std::size_t count) {
  const std::size_t from = offsetof(WholeBody, position), mass = offsetof(WholeBody, inverseMass);
  std::size_t lines = 0, next = 0;  // all lines before this one are counted
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * sizeof(WholeBody);
    for (const auto& [begin, end] : {std::pair(at + from, at + from + 6 * sizeof(Real)),
                                     std::pair(at + mass, at + mass + sizeof(Real))}) {
      const std::size_t first = std::max(next, begin / kLine), last = (end - 1) / kLine;
      if (last >= first) lines += last - first + 1;
      next = std::max(next, last + 1);
    }
  }
  return lines;
}

// Nanoseconds per body of the best of a few passes.
Real best(std::size_t bodies, const std::function<void()>& pass) {
  Real least = std::numeric_limits<Real>::infinity();
  const int passes = static_cast<int>(std::max<std::size_t>(1, 20'000 / bodies));
  for (int n = 0; n < 7; ++n) {
    const std::clock_t before = std::clock();
    for (int i = 0; i < passes; ++i) pass();
    const Real seconds = static_cast<Real>(std::clock() - before) / CLOCKS_PER_SEC;
    least = std::min(least, 1e9 * seconds / (passes * static_cast<Real>(bodies)));
  }
  return std::max(least, 0.01);
}

std::size_t differing(const std::vector<WholeBody>& a, const std::vector<WholeBody>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    count += a[i].position != b[i].position || a[i].velocity != b[i].velocity ? 1 : 0;
  }
  return count;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  using Move = void (*)(std::vector<BodyBlock>&);
  const std::pair<const char*, Move> ways[] = {{"blocks, one at a time", moveBlocks<Real>},
                                               {"blocks, two lanes", moveBlocks<Two>},
                                               {"blocks, four lanes", moveBlocks<Four>}};
  constexpr std::size_t kCount = 10'001;
  std::vector<WholeBody> whole = someBodies(kCount);
  for (int n = 0; n < 60; ++n) moveWhole(whole);
  carom::io::Table table;
  table.column("10,001 bodies").column("bytes of one").column("used").column("lines read");
  table.column("other bits");
  table.row({"whole", sizeof(WholeBody), 7 * sizeof(Real), linesWhole(kCount), 0});
  for (const auto& [name, move] : ways) {
    std::vector<WholeBody> back = someBodies(kCount);
    std::vector<BodyBlock> blocks = carom::soaLayout(back);
    for (int n = 0; n < 60; ++n) move(blocks);
    carom::aosLayout(blocks, back);
    const std::size_t lines = (blocks.size() * sizeof(BodyBlock) + kLine - 1) / kLine;
    table.row({name, sizeof(BodyBlock) / carom::kBlockLanes, 7 * sizeof(Real), lines,
               differing(whole, back)});
  }
  std::cout << table;

  std::vector<Real> counts, times[4];
  for (std::size_t count = 100; count <= 300'000; count *= 3) {
    std::vector<WholeBody> some = someBodies(count);
    std::vector<BodyBlock> blocks = carom::soaLayout(some);
    counts.push_back(static_cast<Real>(count));
    times[0].push_back(best(count, [&] { moveWhole(some); }));
    for (std::size_t w = 0; w < 3; ++w) {
      times[w + 1].push_back(best(count, [&] { ways[w].second(blocks); }));
    }
  }
  carom::io::Plot plot("Moving a body, on the machine that made this page");
  plot.describe(
      "Time per body over the number of bodies: level for bodies in blocks, and rising "
      "for whole bodies as they leave one cache after the other.");
  plot.xAxis("bodies", carom::io::Scale::Logarithmic);
  plot.yAxis("time per body [ns]", carom::io::Scale::Logarithmic);
  plot.curve("whole", counts, times[0], {.marks = true});
  for (std::size_t w = 0; w < 3; ++w) {
    plot.curve(ways[w].first, counts, times[w + 1], {.marks = true});
  }
  plot.writeSvg(folder / "layout.svg");
}

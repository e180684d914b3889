// What comes of it if the order in which threads are done is the order of what they found?
//
// The same impacts, many of them at one time, as one thread would list them and as several would
// that share the bodies; an impact between bodies of two threads is found by both. Then the lists
// are put one after the other, or merged.

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom_io/table.hpp"
#include "merge_found.hpp"

using carom::FoundImpact;

using Lists = std::vector<std::vector<FoundImpact>>;

// Body i belongs to thread i modulo `threads`, which finds all impacts of its bodies.
Lists foundBy(int threads, const std::vector<FoundImpact>& impacts) {
  Lists lists(static_cast<std::size_t>(threads));
  for (int thread = 0; thread < threads; ++thread) {
    auto& list = lists[static_cast<std::size_t>(thread)];
    for (const FoundImpact& one : impacts) {
      if (one.bodyA % threads == thread) {
        list.push_back(one);
      } else if (one.bodyB % threads == thread) {
        list.push_back({one.time, one.bodyB, one.bodyA});
      }
    }
  }
  return lists;
}

std::vector<FoundImpact> oneAfterTheOther(const Lists& lists) {
  std::vector<FoundImpact> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

int differing(const std::vector<FoundImpact>& a, const std::vector<FoundImpact>& b) {
  int count = 0;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const bool same = i < a.size() && i < b.size() && a[i].time == b[i].time &&
                      a[i].bodyA == b[i].bodyA && a[i].bodyB == b[i].bodyB;
    count += same ? 0 : 1;
  }
  return count;
}

int main() {
  carom::Random random(2);
  std::vector<FoundImpact> impacts;
  for (int n = 0; n < 100; ++n) {
    const int tick = random.integer(1, 20), a = random.integer(0, 29);
    impacts.push_back({tick / 64.0, a, a + random.integer(1, 9)});
  }
  const auto one = foundBy(1, impacts);
  carom::io::Table table;
  table.column("100 impacts").column("listed").column("elsewhere").column("merged");
  table.column("elsewhere");
  for (const int threads : {1, 2, 3, 5}) {
    const Lists lists = foundBy(threads, impacts);
    const auto listed = oneAfterTheOther(lists), merged = carom::mergeFound(lists);
    table.row({std::to_string(threads) + (threads == 1 ? " thread" : " threads"), listed.size(),
               differing(listed, oneAfterTheOther(one)), merged.size(),
               differing(merged, carom::mergeFound(one))});
  }
  std::cout << table;
}

// Does the cache keep its pairs, each in its slot?

#include "carom/broadphase/pair_cache.hpp"

#include <map>

#include "boxes.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

TEST_CASE("the cache remembers what a map remembers") {
  Random random(31);
  PairCache cache;
  std::map<IndexPair, std::int32_t> known;
  for (int turn = 0; turn < 20000; ++turn) {
    const int a = random.integer(0, 30);
    const int b = random.integer(0, 30);
    if (a == b) continue;
    const auto at = known.find(pairOf(a, b));
    const std::int32_t slot = cache.find(a, b);
    REQUIRE(slot == (at == known.end() ? kNone : at->second));
    if (slot == kNone) {
      known[pairOf(a, b)] = cache.add(a, b);
    } else if (random.integer(0, 1) == 0) {
      cache.remove(slot);
      known.erase(at);
    }
    REQUIRE(cache.size() == static_cast<int>(known.size()));
  }
  std::vector<IndexPair> expected;
  std::vector<int> counts(31);
  for (const auto& [pair, slot] : known) {
    expected.push_back(pair);
    CHECK(cache.pair(slot) == pair);
    ++counts[pair.first];
    ++counts[pair.second];
  }
  CHECK(cache.sorted() == expected);
  for (int item = 0; item < 31; ++item) {
    int count = 0;
    cache.forEachOf(item, [&](std::int32_t slot, std::int32_t other) {
      CHECK(cache.pair(slot) == pairOf(item, other));
      ++count;
    });
    CHECK(count == counts[item]);
    CHECK(cache.count(item) == counts[item]);
  }
  // No more slots than there ever were pairs.
  CHECK(cache.slots() <= 31 * 30 / 2);
}

TEST_CASE("pairs may end while they are visited, and all else stays") {
  PairCache cache;
  for (int other = 1; other <= 10; ++other) cache.add(0, other);
  cache.add(3, 4);
  cache.forEachOf(0, [&](std::int32_t slot, std::int32_t other) {
    if (other % 2 == 0) cache.remove(slot);
  });
  CHECK(cache.sorted() == std::vector<IndexPair>{{0, 1}, {0, 3}, {0, 5}, {0, 7}, {0, 9}, {3, 4}});
  CHECK(cache.find(4, 0) == kNone);
  CHECK(cache.find(4, 3) != kNone);
  CHECK(cache.find(4, 99) == kNone);
}

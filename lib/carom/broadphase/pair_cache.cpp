#include "carom/broadphase/pair_cache.hpp"

#include <algorithm>

#include "carom/core/expect.hpp"

namespace carom {

void PairCache::reserve(std::int32_t items, std::int32_t pairs) {
  if (items > 0) heads_.reserve(items);
  if (pairs > 0) entries_.reserve(pairs);
  if (pairs > 0) free_.reserve(pairs);
}

std::int32_t PairCache::find(std::int32_t a, std::int32_t b) const {
  if (!known(a) || !known(b)) return kNone;
  const std::int32_t item = heads_[a].count <= heads_[b].count ? a : b;
  const IndexPair pair = pairOf(a, b);
  for (Link link = heads_[item].first; link.slot != kNone;) {
    const Entry& entry = entries_[link.slot];
    if (entry.pair == pair) return link.slot;
    link = entry.next[link.side];
  }
  return kNone;
}

void PairCache::link(std::int32_t item, Link link) {
  Head& head = heads_[item];
  Entry& entry = entries_[link.slot];
  entry.next[link.side] = head.first;
  entry.previous[link.side] = Link();
  if (head.first.slot != kNone) entries_[head.first.slot].previous[head.first.side] = link;
  head.first = link;
  ++head.count;
}

void PairCache::unlink(std::int32_t item, Link link) {
  const Entry& entry = entries_[link.slot];
  const Link next = entry.next[link.side], previous = entry.previous[link.side];
  if (next.slot != kNone) entries_[next.slot].previous[next.side] = previous;
  if (previous.slot == kNone) {
    heads_[item].first = next;
  } else {
    entries_[previous.slot].next[previous.side] = next;
  }
  --heads_[item].count;
}

std::int32_t PairCache::add(std::int32_t a, std::int32_t b) {
  CAROM_EXPECT(a >= 0 && b >= 0 && a != b, "a pair needs two different items, numbers from 0");
  const IndexPair pair = pairOf(a, b);
  if (!known(pair.second)) heads_.resize(pair.second + 1);
  std::int32_t slot = static_cast<std::int32_t>(entries_.size());
  if (free_.empty()) {
    entries_.emplace_back();
    // Room to give every slot back, so that remove() takes no memory.
    free_.reserve(entries_.capacity());
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  entries_[slot].pair = pair;
  link(pair.first, {slot, 0});
  link(pair.second, {slot, 1});
  ++size_;
  return slot;
}

void PairCache::remove(std::int32_t slot) {
  const IndexPair pair = entries_[slot].pair;
  CAROM_EXPECT(pair.first != kNone, "only a pair can be removed");
  unlink(pair.first, {slot, 0});
  unlink(pair.second, {slot, 1});
  entries_[slot] = Entry();
  free_.push_back(slot);
  --size_;
}

std::vector<IndexPair> PairCache::sorted() const {
  std::vector<IndexPair> pairs;
  pairs.reserve(size_);
  for (const Entry& entry : entries_) {
    if (entry.pair.first != kNone) pairs.push_back(entry.pair);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace carom

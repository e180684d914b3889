#pragma once
// Where do islands that come and go get the memory for their lists?
//
// Method: lists that are no longer needed are kept, sorted by the power of two of their room. A
// list that is full goes over to one of at least twice the room, and leaves its own behind.
// Why: an island that comes apart leaves one long list, and its parts need several short ones; the
// next step may join them again. Vectors of their own would ask for memory each time.
// Not handled: giving memory back before the world ends.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace carom::world {

/// Spare lists of numbers. \ingroup world
class ListPool {
 public:
  /// A list of numbers.
  using List = std::vector<std::int32_t>;

  /// Makes spare lists of the least size. \param count so many there are, those in use included
  void provide(std::size_t count) {
    const std::size_t size = sizeOfLeast();
    spare_[size].reserve(count);
    for (; made_[size] < count; ++made_[size]) spare_[size].emplace_back().reserve(kLeast);
  }

  /// Makes spare lists, so that few calls ask for memory as long as all lists together are no
  /// longer than this. \param numbers in all lists
  void reserve(std::size_t numbers) {
    for (std::size_t size = sizeOfLeast(); (numbers >> size) > 0; ++size) {
      // A list is longer than half of its room when it is made, and shrinks.
      const std::size_t wanted = 4 * numbers >> size;
      spare_[size].reserve(wanted);
      for (; made_[size] < wanted; ++made_[size]) {
        spare_[size].emplace_back().reserve(std::size_t{1} << size);
      }
    }
  }

  /// Appends to a list, without asking for memory if a spare one has enough room.
  /// \param list gets one number more \param value the number
  void append(List& list, std::int32_t value) {
    if (list.size() == list.capacity()) grow(list);
    list.push_back(value);
  }

  /// Takes the memory of a list back. \param list is empty afterwards, and has no room
  void giveBack(List& list) {
    list.clear();
    if (list.capacity() >= kLeast) spare_[sizeOf(list)].push_back(std::move(list));
    list = List();
  }

 private:
  static constexpr std::size_t kLeast = 8;
  // The power of two that the room of a list reaches.
  static std::size_t sizeOf(const List& list) {
    return static_cast<std::size_t>(std::bit_width(list.capacity()) - 1);
  }

  void grow(List& list) {
    const std::size_t size = list.capacity() < kLeast ? sizeOfLeast() : sizeOf(list) + 1;
    List larger;
    if (spare_[size].empty()) {
      // Room to take each of them back.
      if (spare_[size].capacity() < ++made_[size]) spare_[size].reserve(2 * made_[size]);
    } else {
      larger = std::move(spare_[size].back());
      spare_[size].pop_back();
    }
    larger.reserve(std::size_t{1} << size);
    larger.assign(list.begin(), list.end());
    std::swap(list, larger);
    giveBack(larger);
  }
  static constexpr std::size_t sizeOfLeast() {
    return static_cast<std::size_t>(std::bit_width(kLeast) - 1);
  }

  std::array<std::vector<List>, 8 * sizeof(std::size_t)> spare_;
  std::array<std::size_t, 8 * sizeof(std::size_t)> made_ = {};
};

}  // namespace carom::world

#pragma once
// How is a pair of bodies written down?
//
// The smaller number first, so that a pair has one name only, and ordered by that name, so that
// lists of pairs can be sorted and compared. Numbers of items are indices that the caller chose.

#include <compare>
#include <cstdint>

/// \defgroup broadphase Broad phase: which pairs are worth a look
/// Finds, among many boxes, the pairs that meet, without trying all of them.

namespace carom {

/// Stands where there is no item, node or pair. \ingroup broadphase
inline constexpr std::int32_t kNone = -1;

/// Two different items. \ingroup broadphase
struct IndexPair {
  std::int32_t first = 0;   ///< the smaller number
  std::int32_t second = 0;  ///< the larger number

  /// Compares the first numbers, then the second. \param self one pair \param other another
  /// \return their order
  friend constexpr auto operator<=>(const IndexPair& self, const IndexPair& other) = default;
};

/// Writes two items as a pair.
/// \param a one item \param b another \return the pair, the smaller number first
/// \ingroup broadphase
constexpr IndexPair pairOf(std::int32_t a, std::int32_t b) {
  return a < b ? IndexPair{a, b} : IndexPair{b, a};
}

}  // namespace carom

#pragma once
// How is a double added to a number that is kept without rounding?
//
// Such a number is a list of doubles that do not overlap, smallest first: an expansion. A new term
// is passed up the list; at each entry it takes with it what fits into one double and leaves the
// rounding error behind (grow-expansion: Shewchuk, Discrete & Computational Geometry 18, 1997).
// Entries that become zero are dropped. What it does not handle: sums that overflow.

#include <vector>

#include "carom/core/real.hpp"
#include "carom/core/two_sum.hpp"

namespace carom {

/// Adds a term to an expansion, exactly.
/// \param parts entries that do not overlap, increasing in size, none zero; stays so
/// \param term any finite number
/// \ingroup precision
inline void growExpansion(std::vector<Real>& parts, Real term) {
  std::size_t kept = 0;
  for (const Real part : parts) {
    const TwoSum s = twoSum(term, part);
    if (s.error != 0) parts[kept++] = s.error;  // never ahead of the entry just read
    term = s.sum;
  }
  parts.resize(kept);
  if (term != 0) parts.push_back(term);
}

}  // namespace carom

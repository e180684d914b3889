#pragma once
// Four ways to add, for float and for double.
//
// Plain: one after the other; the error grows with the number of terms. Pairwise: halves are added
// first, so that a term takes part in log2 n additions instead of n. Kahan: what an addition lost
// is taken off the next term. Neumaier: what the additions lost is collected and added at the end,
// which also serves when terms are larger than the sum so far. For doubles whose sum matters take
// compensatedSum() or compensatedSumInLanes(); these are here to be compared (Higham, Accuracy and
// Stability of Numerical Algorithms, 2002, chapter 4).

#include <cmath>
#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// The sum by a plain loop, in the order given. Error up to n ulp of the sum of absolute values.
/// \tparam Number float or double
/// \param terms any numbers \return their sum
/// \ingroup precision
template <class Number>
Number plainSum(std::span<const Number> terms) {
  Number sum = 0;
  for (const Number term : terms) sum += term;
  return sum;
}

/// The sum of the sums of both halves, down to `kPlain` terms, which are added by a plain loop.
/// Error up to (log2 n + kPlain) ulp of the sum of absolute values.
/// \tparam Number float or double
/// \param terms any numbers \return their sum
/// \ingroup precision
template <class Number>
Number pairwiseSum(std::span<const Number> terms) {
  constexpr std::size_t kPlain = 64;  // below it, calls would cost more than the additions
  if (terms.size() <= kPlain) return plainSum(terms);
  const std::size_t half = terms.size() / 2;
  return pairwiseSum(terms.first(half)) + pairwiseSum(terms.subspan(half));
}

/// Kahan's sum. Error of 2 ulp of the sum of absolute values, whatever n.
/// \tparam Number float or double
/// \param terms any numbers \return their sum
/// \ingroup precision
template <class Number>
Number kahanSum(std::span<const Number> terms) {
  Number sum = 0, surplus = 0;
  for (const Number term : terms) {
    const Number corrected = term - surplus;
    const Number next = sum + corrected;
    surplus = (next - sum) - corrected;  // what has been added beyond what should have been
    sum = next;
  }
  return sum;
}

/// Neumaier's sum: as if added with twice the digits, then rounded. Error of 1 ulp of the sum, plus
/// n^2 ulp^2 of the sum of absolute values: for floats that is no longer small from 10^4 terms on.
/// \tparam Number float or double
/// \param terms any numbers \return their sum
/// \ingroup precision
template <class Number>
Number neumaierSum(std::span<const Number> terms) {
  Number sum = 0, lost = 0;
  for (const Number term : terms) {
    const Number next = sum + term;
    lost += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return sum + lost;
}

}  // namespace carom

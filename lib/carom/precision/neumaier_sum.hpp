#pragma once
// How does a running sum keep the digits that it would lose?
//
// Each addition loses the low digits of the smaller term. Their loss is computed exactly (twoSum)
// and collected beside the sum; it is added once, at the end. Neumaier (ZAMM 54, 1974) improved
// Kahan's method (1965), which fails when a term is larger than the sum so far: 1 + 1e100 + 1 -
// 1e100 is 0 with Kahan, 2 with this. The result is as if summed with twice the digits and then
// rounded, after Ogita, Rump and Oishi (SIAM J. Sci. Comput. 26, 2005). What it does not handle:
// sums whose terms cancel to less than 1e-32 of their size (exact_sum.hpp), and infinite terms.

#include "carom/core/two_sum.hpp"

/// \defgroup precision Precision: chapter 7
/// Numbers more exact than a double: compensated sums, error-free products, exact signs.

namespace carom {

/// A sum that is added to term by term. Its error is at most 1 ulp of the result plus
/// n^2 2^-106 times the sum of the absolute values of n terms.
/// \ingroup precision
class NeumaierSum {
 public:
  /// Adds a term. \param term any finite number
  constexpr void add(Real term) {
    const TwoSum next = twoSum(sum_, term);
    sum_ = next.sum;
    lost_ += next.error;
  }

  /// Adds a product of two numbers without rounding it first.
  /// \param a first factor \param b second factor; the range of twoProduct() applies
  constexpr void addProduct(Real a, Real b) {
    const TwoProduct product = twoProduct(a, b);
    add(product.product);
    lost_ += product.error;
  }

  /// Adds another sum, for sums that were made in parts. \param other sum of other terms
  constexpr void add(const NeumaierSum& other) {
    add(other.sum_);
    lost_ += other.lost_;
  }

  /// The sum so far. \return all terms added, rounded once
  constexpr Real value() const {
    return sum_ + lost_;
  }

 private:
  Real sum_ = 0;
  Real lost_ = 0;
};

}  // namespace carom

#include "carom/precision/exact_sum.hpp"

#include "carom/core/two_sum.hpp"
#include "carom/precision/grow_expansion.hpp"

namespace carom {

void ExactSum::add(Real term) {
  growExpansion(parts_, term);
}

void ExactSum::addProduct(Real a, Real b, Real c) {
  const TwoProduct ab = twoProduct(a, b);
  const TwoProduct large = twoProduct(ab.product, c);
  const TwoProduct small = twoProduct(ab.error, c);
  add(small.error);
  add(small.product);
  add(large.error);
  add(large.product);
}

void ExactSum::addProduct(Real a, Real b, Real c, Real d) {
  const TwoProduct cd = twoProduct(c, d);
  addProduct(a, b, cd.error);
  addProduct(a, b, cd.product);
}

int ExactSum::sign() const {
  if (parts_.empty()) return 0;
  return parts_.back() > 0 ? 1 : -1;
}

Real ExactSum::value() const {
  // From the largest down, until a rounding error appears: the parts below it cannot change the
  // sum, unless the error is exactly half an ulp, a tie, which the sign of the next part decides.
  if (parts_.empty()) return 0;
  std::size_t i = parts_.size() - 1;
  Real sum = parts_[i];
  Real error = 0;
  while (i > 0 && error == 0) {
    const TwoSum s = fastTwoSum(sum, parts_[--i]);
    sum = s.sum;
    error = s.error;
  }
  if (i > 0 && (error < 0) == (parts_[i - 1] < 0)) {
    const Real doubled = 2 * error;
    const Real other = sum + doubled;
    if (other - sum == doubled) return other;  // it was a tie
  }
  return sum;
}

}  // namespace carom

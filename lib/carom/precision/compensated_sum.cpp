#include "carom/precision/compensated_sum.hpp"

#include <cmath>

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  Real sum = 0, lost = 0;
  for (const Real term : terms) {
    const Real next = sum + term;
    // The larger of the two has kept all its digits; what is missing are digits of the smaller.
    if (std::abs(sum) >= std::abs(term)) {
      lost += (sum - next) + term;
    } else {
      lost += (term - next) + sum;
    }
    sum = next;
  }
  return sum + lost;
}

}  // namespace carom

#include "carom/precision/compensated_sum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  Real sum = 0, lost = 0;
  for (const Real term : terms) {
    const Real next = sum + term;
    lost += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return sum - lost;
}

}  // namespace carom

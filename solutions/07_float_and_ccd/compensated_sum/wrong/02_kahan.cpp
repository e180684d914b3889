#include "carom/precision/compensated_sum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  Real sum = 0, surplus = 0;
  for (const Real term : terms) {
    const Real corrected = term - surplus;
    const Real next = sum + corrected;
    surplus = (next - sum) - corrected;
    sum = next;
  }
  return sum;
}

}  // namespace carom

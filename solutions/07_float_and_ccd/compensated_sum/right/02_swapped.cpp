#include "carom/precision/compensated_sum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  Real sum = 0, lost = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    Real large = sum, small = terms[i];
    if (std::abs(large) < std::abs(small)) std::swap(large, small);
    sum = large + small;
    lost = lost + (small - (sum - large));
  }
  return sum + lost;
}

}  // namespace carom

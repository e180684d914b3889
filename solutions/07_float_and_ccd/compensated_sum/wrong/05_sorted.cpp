#include "carom/precision/compensated_sum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  std::vector<Real> sorted(terms.begin(), terms.end());
  std::sort(sorted.begin(), sorted.end(), [](Real a, Real b) { return std::abs(a) < std::abs(b); });
  Real sum = 0;
  for (const Real term : sorted) sum += term;
  return sum;
}

}  // namespace carom

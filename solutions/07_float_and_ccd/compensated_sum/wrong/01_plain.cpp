#include "carom/precision/compensated_sum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  Real sum = 0;
  for (const Real term : terms) sum += term;
  return sum;
}

}  // namespace carom

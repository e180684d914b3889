#include "carom/precision/compensated_sum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  Real sum = 0, lost = 0;
  for (const Real term : terms) {
    // Without asking which is larger (Knuth).
    const Real next = sum + term;
    const Real ofTerm = next - sum;
    const Real ofSum = next - ofTerm;
    lost += (sum - ofSum) + (term - ofTerm);
    sum = next;
  }
  return sum + lost;
}

}  // namespace carom

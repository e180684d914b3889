#include "carom/precision/scaled_quadratic.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

ScaledQuadratic scaledQuadratic(Real a, Real b, Real c) {
  int k = 0;
  if (a != 0 && c != 0) k = (std::ilogb(c) - std::ilogb(a)) / 2;
  int largest = -100000;  // below every exponent
  if (a != 0) largest = std::max(largest, std::ilogb(a) + 2 * k);
  if (b != 0) largest = std::max(largest, std::ilogb(b) + k);
  if (c != 0) largest = std::max(largest, std::ilogb(c));
  if (largest == -100000) return {};
  return {std::scalbn(a, 2 * k - largest - 1), std::scalbn(b, k - largest - 1),
          std::scalbn(c, -largest - 1), k};
}

}  // namespace carom

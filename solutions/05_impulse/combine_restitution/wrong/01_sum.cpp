// Exercise 05.combine_restitution: how bouncy is a pair?
// Check it with: ./course check 05.combine_restitution

#include "carom/impulse/combine_restitution.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real combineRestitution(Real a, Real b, RestitutionRule rule) {
  // Given: what no body can have is refused.
  for (const Real e : {a, b}) {
    if (!(e >= 0 && e <= 1)) reject("restitution", toText(e), "must be from 0 to 1");
  }
  switch (rule) {
    case RestitutionRule::average:
      return a + b;
    case RestitutionRule::product:
      return a * b;
    case RestitutionRule::minimum:
      return std::min(a, b);
    case RestitutionRule::maximum:
      return std::max(a, b);
    case RestitutionRule::geometricMean:
      return std::sqrt(a * b);
  }
  return 0;
}

}  // namespace carom

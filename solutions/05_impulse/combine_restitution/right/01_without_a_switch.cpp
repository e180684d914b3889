// Question by question, and the smaller of the two always first.
#include <cmath>
#include <utility>

#include "carom/core/errors.hpp"
#include "carom/impulse/combine_restitution.hpp"

namespace carom {

Real combineRestitution(Real a, Real b, RestitutionRule rule) {
  if (!(a >= 0 && a <= 1 && b >= 0 && b <= 1)) throw InvalidInput("restitution is from 0 to 1");
  if (a > b) std::swap(a, b);
  if (rule == RestitutionRule::minimum) return a;
  if (rule == RestitutionRule::maximum) return b;
  if (rule == RestitutionRule::average) return a + (b - a) / 2;
  if (rule == RestitutionRule::product) return b * a;
  return std::sqrt(a) * std::sqrt(b);
}

}  // namespace carom

// Exercise 07.conservative_advancement: find the first contact without ever stepping past it.
// Check it with: ./course check 07.conservative_advancement

#include "carom/toi/conservative_advancement.hpp"

#include <algorithm>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

TimeOfImpact conservativeAdvancement(const std::function<Real(Real time)>& gap, Real fastest,
                                     Real duration, Real tolerance, int maxSteps) {
  // Given: what cannot be worked with is refused.
  if (!gap) reject("gap", "an empty function", "must be callable");
  requirePositive(fastest, "fastest");
  requireNonNegative(duration, "duration");
  requirePositive(tolerance, "tolerance");
  if (maxSteps < 1) reject("maxSteps", std::to_string(maxSteps), "must be positive");
  TimeOfImpact result;
  //# solution
  const auto look = [&] { result.gap = gap(result.time); };
  look();
  if (result.gap < -tolerance) {
    result.status = ImpactStatus::kOverlapping;
    return result;
  }
  while (result.gap > tolerance) {
    if (result.time == duration) {
      result.status = ImpactStatus::kNoHit;
      return result;
    }
    if (result.steps == maxSteps) {
      result.status = ImpactStatus::kLimit;
      return result;
    }
    result.time = std::min(result.time + result.gap / fastest, duration);
    ++result.steps;
    look();
  }
  result.status = ImpactStatus::kHit;
  return result;
  //# stub
  // gap(t) looks at the gap at a time; result.time, result.gap and result.steps begin at 0.
  // std::min(a, b) is the smaller one. A loop that counts its steps ends.
  //#| return todo<TimeOfImpact>("conservativeAdvancement");
  //# end
}

}  // namespace carom

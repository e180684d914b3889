// Counts the looks in a for loop.
#include "carom/toi/conservative_advancement.hpp"

#include "carom/core/checks.hpp"

namespace carom {

TimeOfImpact conservativeAdvancement(const std::function<Real(Real time)>& gap, Real fastest,
                                     Real duration, Real tolerance, int maxSteps) {
  if (!gap) throw InvalidInput("no gap");
  requirePositive(fastest, "fastest");
  requireNonNegative(duration, "duration");
  requirePositive(tolerance, "tolerance");
  if (maxSteps < 1) throw InvalidInput("no steps");
  TimeOfImpact r;
  Real t = 0;
  for (int looks = 0; looks <= maxSteps; ++looks) {
    const Real s = gap(t);
    r.time = t;
    r.gap = s;
    r.steps = looks;
    if (looks == 0 && s < -tolerance) {
      r.status = ImpactStatus::kOverlapping;
      return r;
    }
    if (s <= tolerance) {
      r.status = ImpactStatus::kHit;
      return r;
    }
    if (t >= duration) return r;
    t += s / fastest;
    if (t > duration) t = duration;
  }
  r.status = ImpactStatus::kLimit;
  return r;
}

}  // namespace carom

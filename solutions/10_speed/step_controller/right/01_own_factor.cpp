// Per time on both sides, a factor of its own, and the end told by how many steps are left.
#include "carom/motion/step_controller.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

StepChoice stepController(const StepTry& done) {
  requireUsable(done);
  const Real used = done.error / done.length, allowed = done.tolerance / done.duration;
  const bool good = used <= allowed;
  Real factor = 5;
  if (std::isnan(used)) {
    factor = 0.2;
  } else if (used > 0) {
    factor = std::clamp(0.9 * std::pow(allowed / used, 1.0 / done.order), 0.2, 5.0);
  }
  if (good && done.refusedBefore && factor > 1) factor = 1;
  const Real wanted = done.length * factor;
  const Real left = good ? done.left - done.length : done.left;
  const Real steps = std::ceil(left / wanted);
  return {good, wanted, steps > 2 ? wanted : steps > 1 ? left / 2 : left};
}

}  // namespace carom

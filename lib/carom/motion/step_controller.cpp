#include "carom/motion/step_controller.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

StepChoice stepController(const StepTry& done) {
  requireUsable(done);
  const Real allowed = done.tolerance * (done.length / done.duration);
  const Real ratio = done.error / allowed;

  StepChoice choice;
  // Whatever is not known to be small enough is too large.
  choice.accepted = ratio <= 1;
  Real factor = std::isnan(ratio) ? 0.2 : stepFactor(ratio, done.order);
  // What has just been too long is not tried again at once.
  if (choice.accepted && done.refusedBefore) factor = std::min(factor, Real(1));
  choice.wanted = factor * done.length;

  const Real left = choice.accepted ? done.left - done.length : done.left;
  choice.next = choice.wanted >= left ? left : 2 * choice.wanted >= left ? left / 2 : choice.wanted;
  return choice;
}

}  // namespace carom

#include "carom/motion/step_controller.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

StepChoice stepController(const StepTry& done) {
  requireUsable(done);
  const Real share = done.tolerance * done.length / done.duration;
  const Real ratio = std::max(0.0, done.error / share);
  StepChoice choice;
  choice.accepted = ratio <= 1;
  Real factor = stepFactor(ratio, done.order);
  if (choice.accepted && done.refusedBefore) factor = std::min(factor, 1.0);
  choice.wanted = factor * done.length;
  const Real left = choice.accepted ? done.left - done.length : done.left;
  choice.next = choice.wanted;
  if (2 * choice.wanted >= left) choice.next = left / 2;
  if (choice.wanted >= left) choice.next = left;
  return choice;
}

}  // namespace carom

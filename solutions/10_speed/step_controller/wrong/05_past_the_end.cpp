#include "carom/motion/step_controller.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

StepChoice stepController(const StepTry& done) {
  requireUsable(done);
  const Real ratio = done.error / (done.tolerance * done.length / done.duration);
  StepChoice choice;
  choice.accepted = ratio <= 1;
  Real factor = std::isnan(ratio) ? 0.2 : stepFactor(ratio, done.order);
  if (choice.accepted && done.refusedBefore) factor = std::min(factor, 1.0);
  choice.wanted = factor * done.length;
  choice.next = choice.wanted;
  return choice;
}

}  // namespace carom

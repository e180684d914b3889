// Exercise 10.step_controller: was the step good, and how long may the next one be?
// Check it with: ./course check 10.step_controller

#include "carom/motion/step_controller.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/todo.hpp"

namespace carom {

StepChoice stepController(const StepTry& done) {
  // Given: what cannot be worked with is refused.
  requireUsable(done);
  //# solution
  const Real ratio = done.error / (done.tolerance * done.length / done.duration);
  StepChoice choice;
  choice.accepted = ratio <= 1;
  Real factor = std::isnan(ratio) ? 0.2 : stepFactor(ratio, done.order);
  if (choice.accepted && done.refusedBefore) factor = std::min(factor, 1.0);
  choice.wanted = factor * done.length;
  const Real left = choice.accepted ? done.left - done.length : done.left;
  choice.next = choice.wanted;
  if (2 * choice.wanted >= left) choice.next = left / 2;
  if (choice.wanted >= left) choice.next = left;
  return choice;
  //# stub
  // done has length, left, duration, error, tolerance, order and refusedBefore.
  // The answer has accepted, wanted and next. Given is stepFactor(ratio, order) of chapter 6.
  //#| return todo<StepChoice>("stepController");
  //# end
}

}  // namespace carom

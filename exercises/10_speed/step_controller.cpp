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
  // done has length, left, duration, error, tolerance, order and refusedBefore.
  // The answer has accepted, wanted and next. Given is stepFactor(ratio, order) of chapter 6.
  return todo<StepChoice>("stepController");
}

}  // namespace carom

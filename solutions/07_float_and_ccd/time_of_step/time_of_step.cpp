// Exercise 07.time_of_step: what time is it after n steps?
// Check it with: ./course check 07.time_of_step

#include "carom/precision/time_of_step.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Real timeOfStep(std::int64_t step, Real dt, Real start) {
  // Given: what cannot be worked with is refused. A double counts to 2^53 without a gap.
  requireFinite(dt, "dt");
  requireFinite(start, "start");
  constexpr std::int64_t kLast = std::int64_t{1} << 53;
  if (step > kLast || step < -kLast) reject("step", std::to_string(step), "must be within 2^53");
  //# solution
  return start + static_cast<Real>(step) * dt;
  //# stub
  // static_cast<Real>(step) is the count as a number that can be multiplied.
  //#| return todo<Real>("timeOfStep");
  //# end
}

}  // namespace carom

// Exercise 09.soft_contact: a contact that gives way like a spring
// Check it with: ./course check 09.soft_contact

#include "carom/solver/soft_contact.hpp"

#include <numbers>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

SoftContact softContact(Real frequency, Real dampingRatio, Real dt) {
  requirePositive(frequency, "frequency");
  requireNonNegative(dampingRatio, "dampingRatio");
  requirePositive(dt, "dt");
  //# solution
  const Real w = 2 * std::numbers::pi * frequency;
  const Real denominator = 2 * dampingRatio + dt * w;
  const Real stiff = dt * w * denominator;
  return {w / denominator, stiff / (1 + stiff), 1 / (1 + stiff)};
  //# stub
  // Answer {biasRate, massScale, impulseScale}: a rate in 1/s, and two shares that add up to one.
  // std::numbers::pi is there.
  //#| return todo<SoftContact>("softContact");
  //# end
}

}  // namespace carom

#include "carom/motion/adaptive.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

void requireUsable(const Tolerance& tolerance) {
  requirePositive(tolerance.absolute, "absolute");
  requireNonNegative(tolerance.relative, "relative");
  if (tolerance.maxSteps < 1) {
    reject("maxSteps", std::to_string(tolerance.maxSteps), "must be positive");
  }
}

void requireUsable(const StepTry& done) {
  requirePositive(done.length, "length");
  requirePositive(done.duration, "duration");
  requirePositive(done.left, "left");
  requirePositive(done.tolerance, "tolerance");
  if (done.left < done.length)
    reject("left", toText(done.left), "must be at least the step's length");
  if (done.error < 0) reject("error", toText(done.error), "must not be negative");
  if (done.order < 1) reject("order", std::to_string(done.order), "must be positive");
}

Real stepFactor(Real ratio, int order) {
  if (order < 1) reject("order", std::to_string(order), "must be positive");
  constexpr Real kSafety = 0.9, kSmallest = 0.2, kLargest = 5;
  const auto power = [&order](Real x) {
    Real p = 1;
    for (int i = 0; i < order; ++i) p *= x;
    return p;
  };
  // Where the limits rule, no root is needed.
  if (ratio * power(kLargest) <= power(kSafety)) return kLargest;
  if (ratio * power(kSmallest) >= power(kSafety)) return kSmallest;

  // Square roots are rounded alike everywhere, and three of them make an eighth root.
  while (order % 2 == 0) {
    ratio = std::sqrt(ratio);
    order /= 2;
  }
  if (order == 1) return kSafety / ratio;

  // Other roots by Newton's method, which falls towards the root from anywhere above it, and stops
  // where doubles do: C libraries round std::pow differently, and other steps would follow.
  const Real wanted = power(kSafety) / ratio;
  Real x = wanted <= 1 ? 1 : std::sqrt(order > 4 ? std::sqrt(wanted) : wanted);
  while (true) {
    const Real next = x - (x - wanted / (power(x) / x)) / order;
    if (!(next < x)) return x;
    x = next;
  }
}

}  // namespace carom

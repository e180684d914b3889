// Case by case: no number, too much, good.
#include "carom/motion/step_controller.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

Real cut(Real wanted, Real left) {
  if (wanted >= left) return left;
  return std::min(wanted, std::max(left / 2, 2 * wanted < left ? wanted : left / 2));
}

}  // namespace

StepChoice stepController(const StepTry& done) {
  requireUsable(done);
  if (std::isnan(done.error)) {
    return {false, done.length / 5, cut(done.length / 5, done.left)};
  }
  const Real share = done.length / done.duration * done.tolerance;
  const Real wanted = stepFactor(done.error / share, done.order) * done.length;
  if (done.error > share) return {false, wanted, cut(wanted, done.left)};
  const Real kept = done.refusedBefore ? std::min(wanted, done.length) : wanted;
  return {true, kept, cut(kept, done.left - done.length)};
}

}  // namespace carom

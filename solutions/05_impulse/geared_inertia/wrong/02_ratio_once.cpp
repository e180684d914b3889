// Exercise 05.geared_inertia: how heavy a train of gears is to turn, which somebody got wrong.
// Check it with: ./course check 05.geared_inertia

#include "geared_inertia.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/errors.hpp"

namespace carom {

Real gearedInertia(std::span<const GearWheel> train) {
  if (train.empty()) throw InvalidInput("gearedInertia: a train has at least one gear");
  for (const GearWheel& gear : train) {
    requirePositive(gear.teeth, "teeth");
    requireNonNegative(gear.inertia, "inertia");
  }
  Real felt = 0;
  for (const GearWheel& gear : train) {
    const Real ratio = static_cast<Real>(train.front().teeth) / gear.teeth;
    felt += gear.inertia * ratio;
  }
  return felt;
}

}  // namespace carom

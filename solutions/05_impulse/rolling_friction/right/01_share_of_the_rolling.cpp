// Takes off a share of the rolling, the whole at most.
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/impulse/rolling_friction.hpp"

namespace carom {

Vector3 rollingFriction(const RollingContact& contact) {
  const auto& [w, n, inertia, pressed, arm] = contact;
  if (!w.allFinite() || !n.allFinite() || !(inertia > 0) || !(pressed >= 0) || !(arm >= 0)) {
    throw InvalidInput("rollingFriction: no such contact");
  }
  const Vector3 angularMomentum = inertia * cross(n, cross(w, n));
  const Real size = angularMomentum.norm();
  const Real taken = arm * pressed;
  return taken >= size ? Vector3(-angularMomentum) : Vector3(-(taken / size) * angularMomentum);
}

}  // namespace carom

#include "carom/impulse/point_velocity.hpp"

#include "carom/core/cross.hpp"

namespace carom {

Vector3 pointVelocity(const Velocity& body, const Vector3& arm) {
  return body.linear + cross(body.angular, arm);
}

}  // namespace carom

// Component by component, without the cross product of the library.
#include "carom/impulse/point_velocity.hpp"

namespace carom {

Vector3 pointVelocity(const Velocity& body, const Vector3& arm) {
  const Vector3& w = body.angular;
  Vector3 v = body.linear;
  v[0] += w[1] * arm[2] - w[2] * arm[1];
  v[1] += w[2] * arm[0] - w[0] * arm[2];
  v[2] += w[0] * arm[1] - w[1] * arm[0];
  return v;
}

}  // namespace carom

// Exercise 05.point_velocity: how fast does a point of a body move?
// Check it with: ./course check 05.point_velocity

#include "carom/impulse/point_velocity.hpp"

#include "carom/core/cross.hpp"

namespace carom {

Vector3 pointVelocity(const Velocity& body, const Vector3& arm) {
  return body.linear + body.angular.cwiseProduct(arm);
}

}  // namespace carom

// Exercise 05.point_velocity: how fast does a point of a body move?
// Check it with: ./course check 05.point_velocity

#include "carom/impulse/point_velocity.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Vector3 pointVelocity(const Velocity& body, const Vector3& arm) {
  //# solution
  return body.linear + cross(body.angular, arm);
  //# stub
  // cross(a, b) is the vector product a x b.
  //#| return todo<Vector3>("pointVelocity");
  //# end
}

}  // namespace carom

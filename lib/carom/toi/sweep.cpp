#include "carom/toi/sweep.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"

namespace carom {

Pose poseAt(const Sweep& sweep, Real time) {
  Pose pose = sweep.start;
  const Vector3 way = travelled(sweep, time);
  const Real rate = sweep.angularVelocity.norm();
  if (rate == 0 || time == 0) {
    pose.p_WB += way;
    return pose;
  }
  // Rodrigues: turn every column of the rotation about the axis. The origin goes round the centre.
  const Vector3 axis = sweep.angularVelocity / rate;
  const SineCosine angle = sineCosine(rate * time);
  const Real halfSine = sine(rate * time / 2), versine = 2 * halfSine * halfSine;
  const auto turned = [&](const Vector3& v) -> Vector3 {
    const Vector3 across = cross(axis, v);
    return v + angle.sine * across + versine * cross(axis, across);
  };
  for (int k = 0; k < 3; ++k) pose.R_WB.col(k) = turned(sweep.start.R_WB.col(k));
  const Vector3 arm = sweep.start.R_WB * sweep.centre;
  pose.p_WB += way + (arm - pose.R_WB * sweep.centre);
  return pose;
}

Vector3 velocityAt(const Sweep& sweep, Real time, const Vector3& point) {
  const Vector3 centre = pointToWorld(sweep.start, sweep.centre) + travelled(sweep, time);
  return sweep.velocity + time * sweep.acceleration +
         cross(sweep.angularVelocity, Vector3(point - centre));
}

void requireUsable(const Sweep& sweep, const char* name) {
  requireUsable(sweep.start, name);
  // A search asks this each time: names, which take memory, are made only for what is wrong.
  const auto require = [&](const Vector3& value, const char* part) {
    if (!value.allFinite()) requireFinite(value, (std::string(name) + part).c_str());
  };
  require(sweep.velocity, ".velocity");
  require(sweep.angularVelocity, ".angularVelocity");
  require(sweep.acceleration, ".acceleration");
  require(sweep.centre, ".centre");
}

}  // namespace carom

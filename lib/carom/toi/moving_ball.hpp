#pragma once
// A ball in straight motion.

#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/real.hpp"
#include "carom/detection/limits.hpp"

namespace carom {

/// A ball that moves in a straight line. \ingroup toi
struct MovingBall {
  Real radius = 1;                     ///< zero or positive [m]
  Vector3 centre = Vector3::Zero();    ///< at time zero [m, world]
  Vector3 velocity = Vector3::Zero();  ///< [m/s, world]
};

/// Refuses a ball that cannot be worked with.
/// \param ball any ball \param what it is called, for the message
/// \throws InvalidInput if a number is not finite or above 1e40 in size, or the radius negative
/// \ingroup toi
inline void requireUsable(const MovingBall& ball, const char* what) {
  // Almost every ball can be used, and names take longer than a look.
  const auto fits = [](const auto& x) { return (x.array().abs() <= kLargestLength).all(); };
  if (ball.radius >= 0 && ball.radius <= kLargestLength && fits(ball.centre) &&
      fits(ball.velocity)) {
    return;
  }
  const std::string name = what;
  requireNonNegative(ball.radius, (name + ".radius").c_str());
  requireCoordinate(ball.radius, (name + ".radius").c_str());
  requireCoordinates(ball.centre, (name + ".centre").c_str());
  requireFinite(ball.velocity, (name + ".velocity").c_str());
  if (!(ball.velocity.cwiseAbs().maxCoeff() <= kLargestLength)) {
    reject(name + ".velocity", toText(ball.velocity), "must have no coordinate above 1e40 m/s");
  }
}

}  // namespace carom

// With Eigen: both one-sided gaps, cut off at zero.
#include "box_distance.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Real boxDistance(const Aabb<3>& a, const Aabb<3>& b) {
  if (!(a.low + a.high + b.low + b.high).allFinite()) throw InvalidInput("a corner is no number");
  const Vector3 ahead = (b.low - a.high).cwiseMax(Vector3::Zero());
  const Vector3 behind = (a.low - b.high).cwiseMax(Vector3::Zero());
  return (ahead + behind).norm();
}

}  // namespace carom

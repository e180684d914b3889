// The common part of two boxes runs from the larger low corner to the smaller high corner.
#include "carom/core/errors.hpp"
#include "carom/detection/aabb_overlap.hpp"

namespace carom {

Verdict aabbOverlap(const Aabb<3>& a, const Aabb<3>& b) {
  if (!(a.low + a.high + b.low + b.high).allFinite()) throw InvalidInput("a corner is no number");
  const Vector3 size = a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low);
  const Real smallest = size.minCoeff();
  if (smallest > 0) return Verdict::overlapping;
  return smallest < 0 ? Verdict::separated : Verdict::touching;
}

}  // namespace carom

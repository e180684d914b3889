#include "carom/detection/parallel_axes.hpp"

#include <algorithm>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/detection/closest_point.hpp"

namespace carom::detail {

bool separateParallel(const CoreShape& a, const Matrix3& R_WA, const CoreShape& b,
                      const Matrix3& R_WB, const Vector3& p_AB, Separation& result) {
  const auto hasAxis = [](const CoreShape& core) {
    return core.kind == CoreKind::cylinder || core.kind == CoreKind::segment;
  };
  if (!hasAxis(a) || !hasAxis(b)) return false;
  // The entries of a rotation are right to half an ulp; what is more parallel than that is parallel.
  constexpr Real kParallel = 4 * std::numeric_limits<Real>::epsilon();
  if (cross(R_WA.col(2), R_WB.col(2)).squaredNorm() > kParallel * kParallel) return false;

  // Everything in A's frame. B's centre is so far from the surface of the sum of both.
  const Real radiusA = a.extents.x(), heightA = a.extents.z();
  const Real radiusB = b.extents.x(), heightB = b.extents.z();
  const Vector3 p = R_WA.transpose() * p_AB;
  const SurfacePoint found = closestInBody(Cylinder{radiusA + radiusB, heightA + heightB}, p);
  const Vector3& n = found.normal;

  // Where the two meet, or nearly do: along the axis and along the line between the axes, each in
  // the middle of what they have in common, or at the ends that face each other.
  const auto between = [](Real lowA, Real highA, Real lowB, Real highB) {
    const Real low = std::max(lowA, lowB), high = std::min(highA, highB);
    return low <= high ? (low + high) / 2 : (highA < lowB ? highA : lowA);
  };
  const Vector3 sideways(p.x(), p.y(), 0);
  const Real far = sideways.norm();
  const Vector3 way = far > 0 ? Vector3(sideways / far) : Vector3(Vector3::UnitX());
  const bool round = n.x() != 0 || n.y() != 0, flat = n.z() != 0;
  const Real across = round ? radiusA : between(-radiusA, radiusA, far - radiusB, far + radiusB);
  const Real along = flat ? (n.z() > 0 ? heightA : -heightA)
                          : between(-heightA, heightA, p.z() - heightB, p.z() + heightB);
  const Vector3 onA = across * way + along * Vector3::UnitZ();

  result.separation = found.distance;
  result.normal = R_WA * n;
  result.pointA = R_WA * onA;
  result.pointB = result.pointA + result.separation * result.normal;
  result.status = SeparationStatus::exact;
  return true;
}

}  // namespace carom::detail

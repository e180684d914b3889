#include "carom/manifold/collide_half_space.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/manifold/facing_feature.hpp"
#include "carom/manifold/loop_manifold.hpp"

namespace carom {

Manifold detail::collideHalfSpaceWith(const HalfSpace& a, const Pose& A, const ShapeView& b,
                                      const Pose& B, Real margin) {
  Manifold manifold;
  const Vector3 normal = A.R_WB * a.normal;
  // Everything relative to B's origin, whose height over the plane is the only large number.
  const Real height = normal.dot(B.p_WB - A.p_WB) - a.offset;
  const Vector3 lowest = B.R_WB * supportOfView(b, -(B.R_WB.transpose() * normal));
  const Real separation = height + normal.dot(lowest);
  if (separation > margin) return manifold;

  detail::FacingFeature feature;
  detail::facingFeature(b, B.R_WB, Vector3::Zero(), -normal, feature);
  // Two directions in the plane; which ones is of no account.
  const Vector3 axis = std::abs(normal.z()) < 0.5 ? Vector3::UnitZ() : Vector3::UnitX();
  const Vector3 u = cross(axis, normal).normalized();
  const Vector3 v = cross(normal, u);

  constexpr std::uint32_t kFloor = (static_cast<std::uint32_t>(FeatureKind::face) << 14) << 16;
  detail::ClipCorner loop[detail::FacingFeature::kMost];
  for (int k = 0; k < feature.count; ++k) {
    const Vector3& corner = feature.corners[k];
    loop[k] = {corner.dot(u), corner.dot(v), height + normal.dot(corner), k};
  }
  const Real reach = std::abs(height) + lowest.cwiseAbs().sum();
  const Real limit = std::max(margin, separation + kAxisTie * reach);
  const detail::ReferencePlane plane{B.p_WB - height * normal, u, v, normal};
  const auto name = [&](std::int32_t, std::int32_t corner) {
    return kFloor | feature.cornerNames[corner];
  };
  manifold.normal = normal;
  detail::fillFromLoop(plane, loop, feature.count, limit, name, manifold);
  const std::uint32_t id = kFloor | (static_cast<std::uint32_t>(FeatureKind::surface) << 14);
  detail::keepDeepest(B.p_WB + lowest - separation / 2 * normal, separation, reach, id, manifold);
  return manifold;
}

Manifold collideHalfSpace(const HalfSpace& a, const Pose& A, const ConvexShape& b, const Pose& B,
                          Real margin) {
  return detail::collideHalfSpaceWith(a, A, detail::viewOfShape(b), B, margin);
}

}  // namespace carom

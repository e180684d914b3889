#include "carom/manifold/collide_half_space.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/manifold/facing_feature.hpp"
#include "carom/manifold/feature_name.hpp"
#include "carom/manifold/loop_manifold.hpp"

namespace carom {

namespace {

// Whether the plane takes a good part of a body's height.
bool isDeep(const detail::ShapeView& b, const Matrix3& R, const Vector3& normal, Real separation,
            Real reach) {
  constexpr Real kDeep = 0.25, kLittle = 1e-6;
  if (!(-separation > kLittle * reach) || std::holds_alternative<const Ball*>(b)) return false;
  const auto extent = [&](const Vector3& direction) {
    return direction.dot(R * detail::supportOfView(b, R.transpose() * direction));
  };
  return -separation > kDeep * (extent(normal) + extent(-normal));
}

// The points of a body that lies deep in the plane: it is there with more than with what faces it,
// and, held at one corner only, would go on falling about that. Four supports, askew in all four
// directions. They have names that no corner has.
void deepPoints(const detail::ShapeView& b, const Matrix3& R, const Vector3 (&frame)[3],
                detail::FacingFeature& feature) {
  constexpr std::int32_t kName = 0x3ff0;
  feature.count = 0;
  for (const int k : {0, 1, 2, 3}) {
    const Vector3 aside = (k < 2 ? 1 : -1) * frame[k % 2];
    const Vector3 down = (aside - frame[2]).normalized();
    const Vector3 point = R * detail::supportOfView(b, R.transpose() * down);
    bool known = false;
    for (int i = 0; i < feature.count; ++i) known = known || feature.corners[i] == point;
    if (known) continue;
    feature.corners[feature.count] = point;
    feature.cornerNames[feature.count++] = detail::nameOf(FeatureKind::vertex, kName + k);
  }
}

}  // namespace

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

  const Real reach = std::abs(height) + lowest.cwiseAbs().sum();
  if (isDeep(b, B.R_WB, normal, separation, reach)) {
    deepPoints(b, B.R_WB, {u, v, normal}, feature);
  }

  constexpr std::uint32_t kFloor = (static_cast<std::uint32_t>(FeatureKind::face) << 14) << 16;
  detail::ClipCorner loop[detail::FacingFeature::kMost];
  for (int k = 0; k < feature.count; ++k) {
    const Vector3& corner = feature.corners[k];
    loop[k] = {corner.dot(u), corner.dot(v), height + normal.dot(corner), k};
  }
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

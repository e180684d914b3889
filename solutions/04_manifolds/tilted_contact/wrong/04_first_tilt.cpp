// Exercise 04.tilted_contact: how much a contact changes when the body tilts by next to nothing.
// Check it with: ./course check 04.tilted_contact

#include "tilted_contact.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/manifold/face_contact.hpp"

namespace carom {
namespace {

// side. The points come in the order of the bottom's corners, whatever the tilt.
[[maybe_unused]] std::vector<FacePoint> contactAt(Real halfWidth, Real depth, Real tilt) {
  const Real far = 10 * halfWidth;
  const std::vector<Vector3> floor = {
      {-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}};
  std::vector<Vector3> bottom;
  for (const int corner : {0, 1, 2, 3}) {
    const Real x = corner < 2 ? -halfWidth : halfWidth;
    const Real y = corner == 1 || corner == 2 ? halfWidth : -halfWidth;
    bottom.push_back({std::cos(tilt) * x, y, -std::sin(tilt) * x - depth});
  }
  return faceContact(floor, Vector3::UnitZ(), bottom);
}

[[maybe_unused]] const FacePoint& lowest(const std::vector<FacePoint>& contact) {
  return *std::min_element(
      contact.begin(), contact.end(),
      [](const FacePoint& p, const FacePoint& q) { return p.separation < q.separation; });
}

}  // namespace

std::vector<TiltedContact> tiltedContact(Real halfWidth, Real depth, std::span<const Real> tilts) {
  requirePositive(halfWidth, "half width");
  requirePositive(depth, "depth");
  for (const Real tilt : tilts) {
    requirePositive(tilt, "tilt");
    requirePositive(depth - std::sin(tilt) * halfWidth, "depth of the higher side");
  }
  std::vector<TiltedContact> table;
  for (std::size_t k = 0; k < tilts.size(); ++k) {
    const Real tilt = tilts[0];
    const std::vector<FacePoint> right = contactAt(halfWidth, depth, tilt);
    const std::vector<FacePoint> left = contactAt(halfWidth, depth, -tilt);

    TiltedContact row;
    row.tilt = tilt;
    row.jump = std::abs(lowest(right).position.x() - lowest(left).position.x());
    for (std::size_t i = 0; i < right.size(); ++i) {
      const Real change = std::abs(right[i].separation - left[i].separation);
      row.depthChange = std::max(row.depthChange, change);
    }
    table.push_back(row);
  }
  return table;
}

}  // namespace carom

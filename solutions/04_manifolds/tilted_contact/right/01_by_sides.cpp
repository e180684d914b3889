// The extremes found by hand, and the contacts kept as pairs.
#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/manifold/face_contact.hpp"
#include "tilted_contact.hpp"

namespace carom {
namespace {

std::vector<FacePoint> contactOf(Real w, Real depth, Real tilt) {
  const std::vector<Vector3> floor = {
      {-9 * w, -9 * w, 0}, {9 * w, -9 * w, 0}, {9 * w, 9 * w, 0}, {-9 * w, 9 * w, 0}};
  const Real c = std::cos(tilt), s = std::sin(tilt);
  const std::vector<Vector3> bottom = {{-c * w, -w, s * w - depth},
                                       {-c * w, w, s * w - depth},
                                       {c * w, w, -s * w - depth},
                                       {c * w, -w, -s * w - depth}};
  return faceContact(floor, Vector3::UnitZ(), bottom);
}

}  // namespace

std::vector<TiltedContact> tiltedContact(Real halfWidth, Real depth, std::span<const Real> tilts) {
  std::vector<TiltedContact> table(tilts.size());
  requirePositive(halfWidth, "half width");
  for (std::size_t k = 0; k < tilts.size(); ++k) {
    requirePositive(tilts[k], "tilt");
    requirePositive(depth - halfWidth * std::sin(tilts[k]), "depth");
    const auto one = contactOf(halfWidth, depth, tilts[k]);
    const auto two = contactOf(halfWidth, depth, -tilts[k]);
    std::size_t lowestOne = 0, lowestTwo = 0;
    table[k].tilt = tilts[k];
    for (std::size_t i = 0; i < one.size(); ++i) {
      if (one[i].separation < one[lowestOne].separation) lowestOne = i;
      if (two[i].separation < two[lowestTwo].separation) lowestTwo = i;
      const Real change = one[i].separation - two[i].separation;
      if (std::abs(change) > table[k].depthChange) table[k].depthChange = std::abs(change);
    }
    table[k].jump = std::abs((one[lowestOne].position - two[lowestTwo].position).x());
  }
  return table;
}

}  // namespace carom

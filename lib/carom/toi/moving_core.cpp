#include "carom/toi/moving_core.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/limits.hpp"

namespace carom::detail {
namespace {

// Calls visit(corner) for points of the body's frame whose hull holds the core.
template <class Visit>
void forEachCorner(const CoreShape& core, const Visit& visit) {
  if (core.kind == CoreKind::hull) {
    for (const Vector3& v : core.hull->vertices) visit(v);
    return;
  }
  for (int i = 0; i < 8; ++i) {
    const Vector3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    visit(Vector3(signs.cwiseProduct(core.extents)));
  }
}

}  // namespace

MovingCore movingCore(const CoreShape& core, const Sweep& sweep) {
  MovingCore moving = {core, sweep};
  const Real rate = length(sweep.angularVelocity);
  const Vector3 axis = rate > 0 ? Vector3(sweep.angularVelocity / rate) : Vector3::Zero();
  forEachCorner(core, [&](const Vector3& corner) {
    const Vector3 arm = sweep.start.R_WB * (corner - sweep.centre);
    moving.reach = std::max(moving.reach, length(arm));
    moving.fromAxis = std::max(moving.fromAxis, length(cross(axis, arm)));
  });
  return moving;
}

std::vector<MovingCore> movingCores(const Shape& shape, const Sweep& sweep) {
  std::vector<MovingCore> parts;
  forEachCore(shape, sweep, [&](const MovingCore& part) { parts.push_back(part); });
  return parts;
}

void requireSearchable(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B,
                       Real duration) {
  requireUsable(A, "A");
  requireUsable(B, "B");
  requireNonNegative(duration, "duration");
  const auto requireReachable = [&](const Sweep& sweep, const char* name) {
    const Real travelled =
        duration * (length(sweep.velocity) + duration / 2 * length(sweep.acceleration));
    if (!(travelled <= kLargestLength)) {
      reject(std::string("the way of ") + name, toText(travelled), "must be at most 1e40 m");
    }
    if (!(length(sweep.angularVelocity) <= kLargestLength)) {
      reject(std::string(name) + ".angularVelocity", toText(sweep.angularVelocity),
             "must be at most 1e40 rad/s");
    }
  };
  requireReachable(A, "A");
  requireReachable(B, "B");
  const bool planeA = std::holds_alternative<HalfSpace>(a);
  const bool planeB = std::holds_alternative<HalfSpace>(b);
  if (planeA && planeB) reject("shapes", "two half-spaces", "must not both be without end");
  for (const Sweep* plane : {planeA ? &A : nullptr, planeB ? &B : nullptr}) {
    if (plane && !plane->angularVelocity.isZero(0)) {
      reject("angularVelocity of a half-space", toText(plane->angularVelocity), "must be zero");
    }
  }
}

}  // namespace carom::detail

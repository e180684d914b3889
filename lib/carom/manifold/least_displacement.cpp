#include "carom/manifold/least_displacement.hpp"

#include <algorithm>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

LeastDisplacement leastDisplacement(std::span<const Vector3> axes, std::span<const Vector3> a,
                                    std::span<const Vector3> b) {
  if (axes.empty() || a.empty() || b.empty()) {
    throw InvalidInput("leastDisplacement: there must be an axis and a corner of each body");
  }
  LeastDisplacement best;
  best.separation = -std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Real axisLength = length(axes[i]);
    if (!(axisLength > 0) || !axes[i].allFinite()) {
      reject("leastDisplacement: axis", toText(axes[i]), "must be finite and not zero");
    }
    const Vector3 unit = axes[i] / axisLength;

    // What each body covers on the axis.
    constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
    Real lowA = kInfinity, highA = -kInfinity, lowB = kInfinity, highB = -kInfinity;
    for (const Vector3& corner : a) {
      lowA = std::min(lowA, unit.dot(corner));
      highA = std::max(highA, unit.dot(corner));
    }
    for (const Vector3& corner : b) {
      lowB = std::min(lowB, unit.dot(corner));
      highB = std::max(highB, unit.dot(corner));
    }

    // B leaves A forwards or backwards, whichever is shorter.
    const Real forwards = lowB - highA;
    const Real backwards = lowA - highB;
    const Real separation = std::max(forwards, backwards);
    if (separation <= best.separation) continue;
    best.separation = separation;
    best.normal = forwards >= backwards ? unit : Vector3(-unit);
    best.axis = static_cast<int>(i);
  }
  return best;
}

}  // namespace carom

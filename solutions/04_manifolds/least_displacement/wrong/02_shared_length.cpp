// Exercise 04.least_displacement: the shortest way out of an overlap.
// Check it with: ./course check 04.least_displacement

#include "carom/manifold/least_displacement.hpp"

#include <limits>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/project.hpp"

namespace carom {

LeastDisplacement leastDisplacement(std::span<const Vector3> axes, std::span<const Vector3> a,
                                    std::span<const Vector3> b) {
  if (axes.empty() || a.empty() || b.empty()) {
    throw InvalidInput("leastDisplacement: there must be an axis and a corner of each body");
  }
  for (const Vector3& axis : axes) requirePositive(length(axis), "length of an axis");
  LeastDisplacement best;
  best.separation = -std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Vector3 unit = axes[i] / length(axes[i]);
    const Interval onA = project(a, unit);
    const Interval onB = project(b, unit);

    // B leaves A forwards or backwards, whichever is shorter.
    const Real forwards = onB.low - onA.high;
    const Real backwards = onA.low - onB.high;
    const Real separation = std::max(onA.low, onB.low) - std::min(onA.high, onB.high);
    if (separation <= best.separation) continue;
    best.separation = separation;
    best.normal = forwards >= backwards ? unit : Vector3(-unit);
    best.axis = static_cast<int>(i);
  }
  return best;
}

}  // namespace carom

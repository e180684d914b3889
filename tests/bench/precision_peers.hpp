#pragma once
// Sums and predicates of other libraries, each behind one function, in shared libraries of their
// own, as in peers.hpp.

#include <functional>
#include <span>
#include <vector>

#include "carom/core/real.hpp"

#define CAROM_PEER __attribute__((visibility("default")))

namespace carom::bench {

/// std::reduce in sequence. \return the sum
CAROM_PEER Real reduceSum(std::span<const Real> terms);
/// The same for floats. \return the sum
CAROM_PEER float reduceSum(std::span<const float> terms);
/// Eigen's sum(), with vectors of the processor. \return the sum
CAROM_PEER Real eigenSum(std::span<const Real> terms);
/// The same for floats. \return the sum
CAROM_PEER float eigenSum(std::span<const float> terms);

/// CGAL's orientation of every three points with Epick. \return a call that adds the signs up
CAROM_PEER std::function<int()> cgalSides(const std::vector<Vector2>& points);
/// CGAL's side_of_oriented_circle of every four points with Epick. \return as cgalSides()
CAROM_PEER std::function<int()> cgalCircles(const std::vector<Vector2>& points);
/// CGAL's orientation of every four points in space with Epick. \return as cgalSides()
CAROM_PEER std::function<int()> cgalPlanes(const std::vector<Vector3>& points);

}  // namespace carom::bench

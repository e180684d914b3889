#pragma once
// What the tests of manifolds share: reference values of tests/cases/manifold.json, random bodies,
// and what every manifold must be.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../detection/sat_reference.hpp"
#include "carom/detection/closest_point.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/swap_manifold.hpp"
#include "support/catch.hpp"

namespace carom_test {

inline json manifoldCase(const std::string& id) {
  std::ifstream file(std::string(CAROM_CASES_DIR) + "/manifold.json");
  return json::parse(file).at(id);
}

inline carom::Vector3 flat(const json& value) {
  return {readNumber(value[0]), readNumber(value[1]), 0};
}

inline std::vector<carom::Vector3> flatCorners(const json& corners) {
  std::vector<carom::Vector3> points;
  for (const json& corner : corners) points.push_back(flat(corner));
  return points;
}

// Bit for bit the same manifold.
inline bool same(const carom::Manifold& x, const carom::Manifold& y) {
  bool equal = x.count == y.count;
  if (!equal || x.count == 0) return equal;
  equal = x.normal == y.normal && x.area == y.area && x.areaCentroid == y.areaCentroid;
  for (int k = 0; equal && k < x.count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    equal = x.points[i].position == y.points[i].position &&
            x.points[i].separation == y.points[i].separation && x.points[i].id == y.points[i].id;
  }
  return equal;
}

inline carom::Manifold mirrored(carom::Manifold manifold) {
  carom::detail::swapBodies(manifold);
  return manifold;
}

// How far the points of a manifold are from the surfaces that they should lie on, and from the
// bodies: a point on a side plane of a face may lie on the plane of that face only.
inline double worstOffSurface(const carom::Manifold& manifold, const carom::ConvexShape& a,
                              const carom::Pose& A, const carom::ConvexShape& b,
                              const carom::Pose& B) {
  double worst = 0;
  for (int k = 0; k < manifold.count; ++k) {
    const carom::ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
    const carom::Vector3 onA = pointOnA(manifold.normal, point);
    const carom::Vector3 onB = pointOnB(manifold.normal, point);
    worst = std::max(worst, std::abs(carom::closestPoint(a, A, onA).distance));
    worst = std::max(worst, std::abs(carom::closestPoint(b, B, onB).distance));
  }
  return worst;
}

// The names of the points of one manifold differ.
inline bool namesDiffer(const carom::Manifold& manifold) {
  for (int i = 0; i < manifold.count; ++i) {
    for (int k = 0; k < i; ++k) {
      if (manifold.points[static_cast<std::size_t>(i)].id ==
          manifold.points[static_cast<std::size_t>(k)].id) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace carom_test

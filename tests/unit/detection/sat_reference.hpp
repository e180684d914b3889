#pragma once
// What the tests of separating axes share: reference values of tests/cases/sat.json and random
// pairs.

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/detection/shapes.hpp"
#include "detection_reference.hpp"

namespace carom_test {

inline json satCase(const std::string& id) {
  std::ifstream file(std::string(CAROM_CASES_DIR) + "/sat.json");
  return json::parse(file).at(id);
}

inline std::string nameOf(carom::Verdict verdict) {
  switch (verdict) {
    case carom::Verdict::separated:
      return "separated";
    case carom::Verdict::touching:
      return "touching";
    case carom::Verdict::overlapping:
      return "overlapping";
  }
  return "";
}

inline carom::Box randomBox(carom::Random& random) {
  const double x = random.between(0.3, 1), y = random.between(0.3, 1), z = random.between(0.3, 1);
  return carom::Box{{x, y, z}};
}

inline carom::Pose randomPose(carom::Random& random, double reach) {
  while (true) {
    const double w = random.between(-1, 1), x = random.between(-1, 1), y = random.between(-1, 1),
                 z = random.between(-1, 1);
    const double squared = w * w + x * x + y * y + z * z;
    if (squared > 1 || squared < 0.01) continue;
    const double px = random.between(-reach, reach), py = random.between(-reach, reach),
                 pz = random.between(-reach, reach);
    return carom::poseOf({w, x, y, z}, {px, py, pz});
  }
}

inline carom::Vector3 randomDirection(carom::Random& random) {
  while (true) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    const carom::Vector3 v(x, y, z);
    if (v.squaredNorm() < 1 && v.squaredNorm() > 0.01) return v.normalized();
  }
}

// Points on an ellipsoid with half axes between 0.3 and 1.
inline carom::ConvexHull randomHull(carom::Random& random, int points) {
  const carom::Vector3 axes = randomBox(random).halfExtents;
  std::vector<carom::Vector3> cloud;
  for (int i = 0; i < points; ++i) {
    cloud.push_back(axes.cwiseProduct(randomDirection(random)));
  }
  return carom::hullOfPoints(cloud);
}

}  // namespace carom_test

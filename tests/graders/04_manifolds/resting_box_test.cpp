// Grader of 04.resting_box: the library lays the tilted bottom of the box on the floor; the forces
// follow from the places of the contact points by moments.

#include <algorithm>
#include <cmath>

#include "carom/manifold/face_contact.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kMargin = "a prediction may be 5% off";
constexpr Real kDepth = 1e-6;  // of the box in the floor, when it is level [m]
constexpr Real kTilt = 1e-9;   // [rad]
constexpr Real kWeight = 1;    // [N]
constexpr Real kLoad = 1;      // [N]
constexpr Real kLoadAt = 0.3;  // to the right of the middle [m]

// The bottom of the box, 2 m wide, turned about y so that its right side sinks, on a wide floor.
std::vector<FacePoint> contactAt(Real tilt) {
  const std::vector<Vector3> floor = {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
  const Real c = std::cos(tilt), s = std::sin(tilt);
  std::vector<Vector3> bottom;
  for (const Vector3& p :
       {Vector3(-1, -1, 0), Vector3(-1, 1, 0), Vector3(1, 1, 0), Vector3(1, -1, 0)}) {
    bottom.push_back({c * p.x(), p.y(), -s * p.x() - kDepth});
  }
  return faceContact(floor, Vector3::UnitZ(), bottom);
}

FacePoint lowest(const std::vector<FacePoint>& contact) {
  return *std::min_element(
      contact.begin(), contact.end(),
      [](const FacePoint& p, const FacePoint& q) { return p.separation < q.separation; });
}

// The depth at the left edge.
Real depthLeft(const std::vector<FacePoint>& contact) {
  for (const FacePoint& p : contact) {
    if (p.position.x() < 0) return -p.separation;
  }
  return 0;
}

// What one edge carries, from the moments about the other.
Real forceAt(Real edge, Real other) {
  return (kWeight * (0 - other) + kLoad * (kLoadAt - other)) / (edge - other);
}

}  // namespace

TEST_CASE("jump") {
  GRADE(predicted("jump_of_the_lowest_corner", "m"),
        std::abs(lowest(contactAt(kTilt)).position.x() - lowest(contactAt(-kTilt)).position.x()),
        withinRelative(0.05, kMargin), unit("m"), about("how far the lowest corner jumps"));
}

TEST_CASE("depth") {
  GRADE(predicted("change_of_depth", "m"),
        std::abs(depthLeft(contactAt(kTilt)) - depthLeft(contactAt(-kTilt))),
        withinRelative(0.05, kMargin), unit("m"),
        about("by how much the depth of a corner on the left changes"));
}

TEST_CASE("forces") {
  const std::vector<FacePoint> contact = contactAt(0);
  Real left = 0, right = 0;
  for (const FacePoint& p : contact) {
    left = std::min(left, p.position.x());
    right = std::max(right, p.position.x());
  }
  GRADE(predicted("force_left", "N"), forceAt(left, right), withinRelative(0.05, kMargin),
        unit("N"), about("force of the floor on the left edge"));
  GRADE(predicted("force_right", "N"), forceAt(right, left), withinRelative(0.05, kMargin),
        unit("N"), about("force of the floor on the right edge"));
}

PROBES() {
  PROBE(predicted("jump_of_the_lowest_corner", "m"));
  PROBE(1e9 * predicted("change_of_depth", "m"));
  PROBE(predicted("force_left", "N"));
  PROBE(predicted("force_right", "N"));
}

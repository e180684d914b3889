// Grader of 03.crossed_roofs: the library parts the boxes by their fifteen axes, and projects their
// corners on the face.

#include <cmath>

#include "carom/detection/interval.hpp"
#include "carom/detection/project.hpp"
#include "carom/detection/sat_boxes.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kHeight = 2.7;  // of B's centre over A's [m]
constexpr const char* kMargin = "a prediction may be 5% off";

const Real kRoot = std::sqrt(0.5);

// Turned by 45 degrees about y, and about x.
Pose crossedA() {
  Pose pose;
  pose.R_WB << kRoot, 0, kRoot, 0, 1, 0, -kRoot, 0, kRoot;
  return pose;
}
Pose crossedB() {
  Pose pose;
  pose.R_WB << 1, 0, 0, 0, kRoot, -kRoot, 0, kRoot, kRoot;
  pose.p_WB = {0, 0, kHeight};
  return pose;
}

std::vector<Vector3> cornersOfCube(const Pose& pose) {
  std::vector<Vector3> all;
  for (int n = 0; n < 8; ++n) {
    all.push_back(pointToWorld(pose, {n & 1 ? 1.0 : -1.0, n & 2 ? 1.0 : -1.0, n & 4 ? 1.0 : -1.0}));
  }
  return all;
}

Box cube(Real edge) {
  return {Vector3::Constant(edge / 2)};
}

}  // namespace

TEST_CASE("crossed") {
  GRADE(predicted("crossed_push", "m"),
        -satBoxes(cube(2), crossedA(), cube(2), crossedB()).separation,
        withinRelative(0.05, kMargin), unit("m"),
        about("shortest push that parts the crossed cubes"));
}

TEST_CASE("face") {
  const Vector3 normal(kRoot, 0, kRoot);
  GRADE(predicted("seen_on_a_face", "m"),
        -gapBetween(project(cornersOfCube(crossedA()), normal),
                    project(cornersOfCube(crossedB()), normal)),
        withinRelative(0.05, kMargin), unit("m"),
        about("overlap of the crossed cubes on the normal of A's face"));
}

TEST_CASE("inside") {
  GRADE(predicted("push_of_the_small_cube", "m"),
        -satBoxes(cube(2), Pose{}, cube(0.2), Pose{}).separation, withinRelative(0.05, kMargin),
        unit("m"), about("shortest push that frees the small cube"));
}

PROBES() {
  PROBE(predicted("crossed_push", "m"));
  PROBE(predicted("seen_on_a_face", "m"));
  PROBE(predicted("push_of_the_small_cube", "m"));
}

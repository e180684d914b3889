// Bodies that move and turn for a step.

#include <limits>
#include <numbers>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/toi/sweep.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

Sweep thrown() {
  Sweep s;
  s.start.p_WB = {1, 2, 3};
  s.velocity = {4, 0, 1};
  s.acceleration = {0, 0, -10};
  s.angularVelocity = {0, 0, 2};
  s.centre = {0.5, 0, 0};
  return s;
}

}  // namespace

TEST_CASE("a body that moves and turns is where it should be") {
  const Sweep s = thrown();
  const Pose start = poseAt(s, 0);
  CHECK(start.p_WB == s.start.p_WB);
  CHECK(start.R_WB == s.start.R_WB);
  // Half a turn later: the centre, at (1.5, 2, 3), has flown on; the origin is on its other side.
  const Real t = std::numbers::pi / 2;
  const Pose half = poseAt(s, t);
  CHECK((half.p_WB - Vector3(2 + 4 * t, 2, 3 + t - 5 * t * t)).norm() < 1e-14);
  CHECK((half.R_WB * Vector3(1, 0, 0) - Vector3(-1, 0, 0)).norm() < 1e-15);
  CHECK((half.R_WB.transpose() * half.R_WB - Matrix3::Identity()).norm() < 1e-15);
}

TEST_CASE("velocities are the slopes of positions") {
  const Sweep s = thrown();
  const Vector3 inBody(0.3, -0.8, 0.2);
  const Real t = 0.37, h = 1e-5;
  const Vector3 slope =
      (pointToWorld(poseAt(s, t + h), inBody) - pointToWorld(poseAt(s, t - h), inBody)) / (2 * h);
  const Vector3 velocity = velocityAt(s, t, pointToWorld(poseAt(s, t), inBody));
  CHECK((slope - velocity).norm() < 1e-8);
}

TEST_CASE("a sweep that does not turn keeps its rotation to the last bit") {
  Sweep s = thrown();
  s.angularVelocity = Vector3::Zero();
  CHECK(poseAt(s, 0.7).R_WB == s.start.R_WB);
  CHECK(poseAt(s, 0.5).p_WB == Vector3(3, 2, 2.25));
}

TEST_CASE("sweeps that cannot be are refused") {
  Sweep s = thrown();
  s.acceleration.y() = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_WITH(requireUsable(s, "A"), ContainsSubstring("A.acceleration"));
  s = thrown();
  s.start.R_WB *= 2;
  CHECK_THROWS_AS(requireUsable(s, "A"), InvalidInput);
}

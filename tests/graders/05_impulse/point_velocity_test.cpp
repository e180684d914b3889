// Grader of 05.point_velocity: a rolling wheel, and points on circles about an axis whose velocity
// is known without a cross product.

#include "carom/impulse/point_velocity.hpp"

#include <cmath>

#include "graders/solids.hpp"
#include "grading/fields_impulse.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "whole numbers and halves: nothing is rounded";
constexpr const char* kRounding = "a few roundings of numbers of this size";

void ask(const Velocity& body, const Vector3& arm, const Vector3& expected, const Within& within,
         const char* what) {
  GRADE(pointVelocity(body, arm), expected, within, given("body.linear", body.linear, "m/s"),
        given("body.angular", body.angular, "rad/s"), given("arm", arm, "m"), unit("m/s"),
        about(what));
}

Velocity anyVelocity(Random& random) {
  Velocity v;
  v.linear = random.vector(4);
  v.angular = random.vector(4);
  return v;
}

}  // namespace

TEST_CASE("wheel") {
  // The road is along x, up is z: a wheel of 0.5 m that rolls at 2 m/s turns about +y at 4 rad/s.
  const Velocity wheel{{2, 0, 0}, {0, 4, 0}};
  ask(wheel, {0, 0, 0.5}, {4, 0, 0}, within(0, kExact), "the highest point of a rolling wheel");
  ask(wheel, {0, 0, -0.5}, {0, 0, 0}, within(0, kExact), "the lowest point of a rolling wheel");
  ask(wheel, {0.5, 0, 0}, {2, 0, -2}, within(0, kExact), "the foremost point of a rolling wheel");
}

TEST_CASE("circle") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    // An axis along the third of three directions at right angles. A point that lies a along the
    // first of them goes round towards the second.
    const Matrix3 R = anyTurn(random, 0.2, 3);
    const Real rate = random.between(0.3, 5), away = random.between(0.2, 2);
    const Real along = random.between(-2, 2);
    Velocity body;
    body.linear = random.vector(3);
    body.angular = rate * R.col(2);
    const Vector3 arm = away * R.col(0) + along * R.col(2);
    ask(body, arm, body.linear + rate * away * R.col(1), within(2e-14, kRounding),
        "a point that goes round an axis, which flies along");
  }
}

PROBES() {
  Random random(501);
  for (int n = 0; n < 16; ++n) {
    const Velocity body = anyVelocity(random);
    const Vector3 arm = random.vector(2);
    PROBE(pointVelocity(body, arm));
  }
}

// Grader of 05.slide_and_roll: the library's friction brakes a crate and a ball in small steps of
// time.

#include "carom/core/cross.hpp"
#include "carom/impulse/friction_impulse.hpp"
#include "carom/impulse/point_velocity.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kMargin = "a prediction may be 5% off";
constexpr Real kGravity = 9.81;  // [m/s^2]
constexpr Real kStep = 1e-3;     // [s]: a distance is wrong by half a step's way, 4 mm at most
constexpr Real kLaneTime = 3;    // [s], longer than any of the balls slides
const Vector3 up = Vector3::UnitZ();

Real slidingDistance(Real mass, Real speed, Real friction) {
  Vector3 v(speed, 0, 0);
  Real x = 0;
  while (v.x() > 0) {
    v += frictionImpulse(v, up, mass * kGravity * kStep, friction, mass) / mass;
    x += kStep * v.x();
  }
  return x;
}

// A solid ball of 1 kg and 1 m, thrown without spin.
Real rollingSpeed(Real speed, Real friction) {
  constexpr Real kInertia = 0.4;
  const Vector3 arm(0, 0, -1);
  Velocity ball;
  ball.linear = {speed, 0, 0};
  for (int n = 0; n * kStep < kLaneTime; ++n) {
    // Pushed at its lowest point, the ball also turns: 1/m + R^2/I is 7/2.
    const Vector3 impulse =
        frictionImpulse(pointVelocity(ball, arm), up, kGravity * kStep, friction, 2.0 / 7);
    ball.linear += impulse;
    ball.angular += cross(arm, impulse) / kInertia;
  }
  return ball.linear.x();
}

}  // namespace

TEST_CASE("distance") {
  GRADE(predicted("distance", "m"), slidingDistance(10, 4, 0.3), withinRelative(0.05, kMargin),
        unit("m"), about("10 kg at 4 m/s: how far it slides"));
}

TEST_CASE("faster") {
  GRADE(predicted("distance_at_8_m_per_s", "m"), slidingDistance(10, 8, 0.3),
        withinRelative(0.05, kMargin), unit("m"), about("10 kg at 8 m/s: how far it slides"));
}

TEST_CASE("heavier") {
  GRADE(predicted("distance_of_20_kg", "m"), slidingDistance(20, 4, 0.3),
        withinRelative(0.05, kMargin), unit("m"), about("20 kg at 4 m/s: how far it slides"));
}

TEST_CASE("rolling") {
  GRADE(predicted("rolling_speed", "m/s"), rollingSpeed(7, 0.2), withinRelative(0.05, kMargin),
        unit("m/s"), about("mu = 0.2: the speed at which the ball rolls"));
  GRADE(predicted("rolling_speed_on_rough_lane", "m/s"), rollingSpeed(7, 0.4),
        withinRelative(0.05, kMargin), unit("m/s"),
        about("mu = 0.4: the speed at which the ball rolls"));
}

PROBES() {
  PROBE(predicted("distance", "m"));
  PROBE(predicted("distance_at_8_m_per_s", "m"));
  PROBE(predicted("distance_of_20_kg", "m"));
  PROBE(predicted("rolling_speed", "m/s"));
  PROBE(predicted("rolling_speed_on_rough_lane", "m/s"));
}

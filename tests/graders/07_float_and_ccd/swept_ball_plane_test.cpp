// Grader of 07.swept_ball_plane: the contact is chosen first, and the ball is flown back from it.

#include "carom/toi/swept_ball_plane.hpp"

#include <cmath>

#include "grading/fields_toi.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

struct Throw {
  MovingBall ball;
  Vector3 acceleration;
  HalfSpace plane;
  Real time;
  Vector3 point;
};

// Touches the plane after a time, with a speed into it, while something pulls along the normal by
// so much. Its height was positive before if it has not turned: speed > -pull time / 2.
Throw thrown(Random& random, Real time, Real speed, Real pull) {
  Throw t;
  t.plane.normal = random.direction();
  const auto along = [&] {
    const Vector3 v = random.vector(4);
    return Vector3(v - v.dot(t.plane.normal) * t.plane.normal);
  };
  t.time = time;
  t.point = random.vector(5);
  t.plane.offset = t.plane.normal.dot(t.point);
  t.ball.radius = random.between(0.1, 1.5);
  t.acceleration = pull * t.plane.normal + along();
  const Vector3 atEnd = along() - speed * t.plane.normal;
  t.ball.velocity = atEnd - time * t.acceleration;
  t.ball.centre =
      t.point + t.ball.radius * t.plane.normal - time * atEnd + time * time / 2 * t.acceleration;
  return t;
}

// Something that falls all the way, or that was thrown up first.
Throw falling(Random& random) {
  const Real time = random.between(0.5, 2), pull = -random.between(2, 10);
  return thrown(random, time, -pull * time * random.between(1.1, 2), pull);
}
Throw rising(Random& random) {
  const Real time = random.between(0.5, 2), pull = -random.between(2, 10);
  return thrown(random, time, -pull * time * random.between(0.55, 0.9), pull);
}
// Driven against the pull, which brakes it.
Throw braked(Random& random) {
  return thrown(random, random.between(0.5, 2), random.between(1, 4), random.between(1, 5));
}

// A ball just above the floor that flies up or down: height, speed and pull are short numbers.
Throw justAbove(Random& random, Real speed) {
  const Real height = random.integer(1, 15) * 0x1p-40, pull = random.integer(16, 160) / 16.0;
  Throw t;
  t.ball = {0.5, {0, 0, 0.5 + height}, {1, 2, speed}};
  t.acceleration = {0, 0, -pull};
  const Real root = std::sqrt(speed * speed + 2 * pull * height);
  t.time = speed > 0 ? (speed + root) / pull : 2 * height / (root - speed);
  t.point = {t.time, 2 * t.time, 0};
  return t;
}

ImpactStatus status(const Throw& t, Real duration) {
  return sweptBallPlane(t.ball, t.acceleration, t.plane, duration).status;
}
Real time(const Throw& t, Real duration) {
  return sweptBallPlane(t.ball, t.acceleration, t.plane, duration).time;
}

void askStatus(const Throw& t, Real duration, ImpactStatus expected, const char* what) {
  const MovingBall& ball = t.ball;
  const Vector3& acceleration = t.acceleration;
  const HalfSpace& plane = t.plane;
  GRADE(sweptBallPlane(ball, acceleration, plane, duration).status, expected,
        within(0, "the status is one of four"), given("ball", t.ball),
        given("acceleration", t.acceleration, "m/s^2"), given("plane", t.plane),
        given("duration", duration, "s"), about(what));
}
void askTime(const Throw& t, Real tolerance, const char* why, const char* what) {
  askStatus(t, t.time + 10, ImpactStatus::kHit, what);
  const Real duration = t.time + 10;
  const MovingBall& ball = t.ball;
  const Vector3& acceleration = t.acceleration;
  const HalfSpace& plane = t.plane;
  GRADE(sweptBallPlane(ball, acceleration, plane, duration).time, t.time,
        withinRelative(tolerance, why), given("ball", t.ball),
        given("acceleration", t.acceleration, "m/s^2"), given("plane", t.plane),
        given("duration", t.time + 10, "s"), unit("s"), about(what));
}

constexpr const char* kPlaces = "the roundings of the places";
constexpr const char* kLast = "a few units in the last place";

}  // namespace

TEST_CASE("falls") {
  Throw t;
  t.ball = {0.5, {0, 0, 5.5}, {3, 0, 0}};
  t.acceleration = {0, 0, -10};
  t.time = 1;
  askTime(t, 1e-15, "a rounding", "a ball of 0.5 m falls 5 m at 10 m/s^2");
  Random random(seed());
  for (int n = 0; n < 5; ++n) askTime(falling(random), 1e-12, kPlaces, "it comes down all the way");
  for (int n = 0; n < 3; ++n) {
    askTime(justAbove(random, -random.integer(1, 80) / 16.0), 1e-14, kLast,
            "it comes down from a few millionths of a micrometre");
  }
}

TEST_CASE("rises") {
  Random random(seed() + 1);
  for (int n = 0; n < 4; ++n) askTime(rising(random), 1e-12, kPlaces, "it rises, and comes back");
  for (int n = 0; n < 4; ++n) {
    askTime(justAbove(random, random.integer(1, 80) / 16.0), 1e-14, kLast,
            "it rises from a few millionths of a micrometre above, and comes back");
  }
}

TEST_CASE("other_ways") {
  Random random(seed() + 2);
  for (int n = 0; n < 3; ++n) {
    askTime(braked(random), 1e-12, kPlaces, "it flies to the plane and is pulled away from it");
  }
  Throw t;
  t.ball = {0.25, {0, 8.25, 0}, {5, -4, 1}};
  t.plane = {Vector3::UnitY(), 0};
  t.acceleration = Vector3::Zero();
  t.time = 2;
  askTime(t, 1e-15, "a rounding", "no acceleration at all: 8 m at 4 m/s");
  t.acceleration = {0, 0, -9.81};
  askTime(t, 1e-15, "a rounding", "an upright wall: the ball falls along it, 8 m away at 4 m/s");
}

TEST_CASE("place") {
  Random random(seed() + 3);
  for (int n = 0; n < 4; ++n) {
    const Throw t = n % 2 ? falling(random) : rising(random);
    GRADE(sweptBallPlane(t.ball, t.acceleration, t.plane, 9).normal, -t.plane.normal,
          within(1e-12, kPlaces), given("ball", t.ball), given("plane", t.plane),
          about("normal of the contact, from the ball into the plane"));
    GRADE(sweptBallPlane(t.ball, t.acceleration, t.plane, 9).point, t.point, within(1e-11, kPlaces),
          given("ball", t.ball), given("acceleration", t.acceleration, "m/s^2"),
          given("plane", t.plane), unit("m"), about("where it touches"));
  }
}

TEST_CASE("misses") {
  Random random(seed() + 4);
  for (int n = 0; n < 3; ++n) {
    const Throw t = n % 2 ? falling(random) : rising(random);
    askStatus(t, 0.95 * t.time, ImpactStatus::kNoHit, "it touches, but after the duration");
    askTime(t, 1e-12, kPlaces, "the same, with time enough");
  }
  Throw t;
  t.ball = {0.5, {0, 0, 2.5}, {0, 0, -1}};
  t.acceleration = {0, 0, 1};
  askStatus(t, 100, ImpactStatus::kNoHit, "pulled up, it turns before it arrives");
  t.ball.velocity = {1, 0, 1};
  askStatus(t, 100, ImpactStatus::kNoHit, "it rises, and is pulled up");
  t.ball = {0.5, {0, 0, 0.25}, {0, 0, 1}};
  askStatus(t, 100, ImpactStatus::kOverlapping, "its lowest point is 25 cm in the floor");
  t.ball.centre.z() = 0.5;
  askStatus(t, 100, ImpactStatus::kHit, "it touches, and rises: a hit at time 0");
}

TEST_CASE("refuses") {
  GRADE_REFUSES(sweptBallPlane({}, Vector3::Zero(), {}, -1), given("duration", -1.0, "s"));
}

PROBES() {
  Random random(710);
  for (int n = 0; n < 4; ++n) {
    for (const Throw& t : {falling(random), rising(random), braked(random)}) {
      PROBE(status(t, 9));
      PROBE(time(t, 9));
    }
    const Throw last = falling(random);
    PROBE(sweptBallPlane(last.ball, last.acceleration, last.plane, 9).normal);
    PROBE(status(falling(random), 0.4));
  }
  PROBE(time(justAbove(random, 2.5), 9));
  PROBE(time(justAbove(random, 3.25), 9));
  Throw level = falling(random);
  level.acceleration = Vector3::Zero();
  PROBE(status(level, 99));
  PROBE(time(justAbove(random, -2.5), 9));
  PROBE(time(justAbove(random, -3.75), 9));
}

// Grader of 07.swept_balls: the contact is chosen first, and the balls are flown back from it; or
// they move along lines on which everything is a short binary number.

#include "carom/toi/swept_balls.hpp"

#include <cmath>
#include <utility>

#include "grading/fields_toi.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

struct Meeting {
  MovingBall a, b;
  Real time;
  Vector3 normal, point;
};

// Balls that touch at a time, with A's velocity and B's against it. Before, they were apart,
// because they approach at the end.
Meeting meeting(Random& random, Real time) {
  Meeting m;
  m.time = time;
  m.normal = random.direction();
  m.point = random.vector(5);
  m.a.radius = random.between(0.2, 2);
  m.b.radius = random.between(0.2, 2);
  m.a.velocity = random.vector(4);
  Vector3 against = 5 * random.direction();
  if (against.dot(m.normal) > 0) against = -against;
  m.b.velocity = m.a.velocity + against - m.normal;  // never quite along each other
  m.a.centre = m.point - m.a.radius * m.normal - time * m.a.velocity;
  m.b.centre = m.point + m.b.radius * m.normal - time * m.b.velocity;
  return m;
}

// B's centre is (1 + e) times both radii away, along (x, y, z), and moves straight at A: the gap of
// e R closes at u times the length of (x, y, z), which is a whole number.
Meeting straightAt(Random& random) {
  const Vector3 ways[] = {{1, 2, 2}, {3, 4, 0}, {2, 3, 6}, {1, 4, 8}};
  const Real lengths[] = {3, 5, 7, 9};
  const int k = random.integer(0, 3);
  const Real e = 0x1p-40, size = random.integer(5, 60) / 16.0;
  const Real u = (2 * random.integer(5000, 200000) + 1) / 16384.0;
  Meeting m;
  m.a.radius = lengths[k] * size / 4;
  m.b.radius = lengths[k] * size * 3 / 4;
  m.b.centre = size * (1 + e) * ways[k];
  m.b.velocity = -u * ways[k];
  m.time = size * e / u;
  m.normal = ways[k] / lengths[k];
  m.point = m.a.radius * m.normal;
  return m;
}

// B passes A's centre at a distance of R - depth, along x, from a kilometre away.
Meeting grazing(Random& random, Real depth) {
  const Real R = random.integer(4, 32) / 8.0, way = random.integer(800, 1200);
  const Real u = random.integer(1, 32) / 8.0;
  const Real half = depth > 0 ? std::sqrt(depth * (2 * R - depth)) : 0;  // of the chord
  Meeting m;
  m.a.radius = R / 4;
  m.b.radius = R * 3 / 4;
  m.b.centre = {way, R - depth, 0};
  m.b.velocity = {-u, 0, 0};
  m.time = (way - half) / u;
  m.normal = Vector3(half, R - depth, 0) / R;
  m.point = m.a.radius * m.normal;
  return m;
}

Real depthOfGraze(Random& random) {
  return random.integer(1, 9) * 0x1p-40;
}

ImpactStatus status(const Meeting& m, Real duration) {
  return sweptBalls(m.a, m.b, duration).status;
}
Real time(const Meeting& m, Real duration) {
  return sweptBalls(m.a, m.b, duration).time;
}

void askStatus(const Meeting& m, Real duration, ImpactStatus expected, const char* what) {
  const MovingBall &a = m.a, &b = m.b;
  GRADE(sweptBalls(a, b, duration).status, expected, within(0, "the status is one of four"),
        given("a", m.a), given("b", m.b), given("duration", duration, "s"), about(what));
}
void askTime(const Meeting& m, Real tolerance, const char* why, const char* what) {
  askStatus(m, 2 * m.time + 1, ImpactStatus::kHit, what);
  const MovingBall &a = m.a, &b = m.b;
  const Real duration = 2 * m.time + 1;
  GRADE(sweptBalls(a, b, duration).time, m.time, withinRelative(tolerance, why), given("a", m.a),
        given("b", m.b), given("duration", 2 * m.time + 1, "s"), unit("s"), about(what));
}

}  // namespace

TEST_CASE("time") {
  Meeting m;
  m.b = {0.5, {10, 0, 0}, {-2, 0, 0}};
  m.time = 4.25;
  askTime(m, 1e-15, "a rounding", "balls of 1 m and 0.5 m, head on: 8.5 m at 2 m/s");
  Random random(seed());
  for (int n = 0; n < 6; ++n) {
    askTime(meeting(random, random.between(0.5, 5)), 1e-12, "the roundings of the places",
            "two balls in flight");
  }
}

TEST_CASE("place") {
  Random random(seed() + 1);
  for (int n = 0; n < 4; ++n) {
    const Meeting m = meeting(random, random.between(0.5, 5));
    GRADE(sweptBalls(m.a, m.b, 10).normal, m.normal, within(1e-11, "the roundings of the places"),
          given("a", m.a), given("b", m.b), about("normal of the contact, from A to B"));
    GRADE(sweptBalls(m.a, m.b, 10).point, m.point, within(1e-11, "the roundings of the places"),
          given("a", m.a), given("b", m.b), unit("m"), about("where they touch"));
  }
}

TEST_CASE("near") {
  Random random(seed() + 2);
  for (int n = 0; n < 6; ++n) {
    askTime(straightAt(random), 1e-14, "a few units in the last place",
            "straight at each other, from a few millionths of a micrometre");
  }
}

TEST_CASE("graze") {
  Random random(seed() + 3);
  for (int n = 0; n < 5; ++n) {
    askTime(grazing(random, depthOfGraze(random)), 1e-12, "the half chord, a few micrometres long",
            "a graze: the line passes less than a hundredth of a nanometre inside");
    askStatus(grazing(random, -depthOfGraze(random)), 1e6, ImpactStatus::kNoHit,
              "the line passes less than a hundredth of a nanometre outside");
  }
}

TEST_CASE("misses") {
  Random random(seed() + 4);
  for (int n = 0; n < 3; ++n) {
    const Real t = random.between(1, 3);
    const Meeting m = meeting(random, t);
    askStatus(m, 0.9 * t, ImpactStatus::kNoHit, "they meet, but after the duration");
    askTime(m, 1e-12, "the roundings of the places", "the same, with time enough");
    Meeting back = m;
    std::swap(back.a.velocity, back.b.velocity);
    const Vector3 p = back.b.centre - back.a.centre;
    if (p.dot(back.b.velocity - back.a.velocity) > 0) {
      askStatus(back, 100, ImpactStatus::kNoHit, "the same, with velocities exchanged: they part");
    }
  }
  Meeting still;
  still.b = {1, {5, 0, 0}, {0, 0, 0}};
  askStatus(still, 100, ImpactStatus::kNoHit, "balls 5 m apart that do not move");
  still.b.velocity = {-1, 1, 0};
  askStatus(still, 100, ImpactStatus::kNoHit, "a ball that passes by");
}

TEST_CASE("start") {
  Meeting m;
  m.a = {1.5, {0, 0, 0}, {0, 0, 0}};
  m.b = {1.5, {2, 0, 0}, {1, 0, 0}};
  askStatus(m, 10, ImpactStatus::kOverlapping, "centres 2 m apart, radii of 3 m together");
  m.b.centre.x() = 3;
  askStatus(m, 10, ImpactStatus::kHit, "they touch, and part: a hit at time 0");
  m.b = {1.5, {4, 0, 0}, {-1, 0, 0}};
  m.time = 1;
  askTime(m, 1e-15, "a rounding", "1 m apart, at 1 m/s");
  m.a.radius = m.b.radius = 0.125;
  m.b = {0.125, {0.375, 0, 0}, {-0.25, 0, 0}};
  m.time = 0.5;
  askTime(m, 1e-15, "a rounding", "marbles of 12.5 cm radius, 12.5 cm apart, at 25 cm/s");
}

TEST_CASE("refuses") {
  GRADE_REFUSES(sweptBalls({}, {1, {5, 0, 0}, {0, 0, 0}}, -1), given("duration", -1.0, "s"));
}

PROBES() {
  Random random(709);
  for (int n = 0; n < 5; ++n) {
    const Meeting m = meeting(random, random.between(1, 3));
    PROBE(status(m, 9));
    PROBE(time(m, 9));
    PROBE(sweptBalls(m.a, m.b, 9).normal);
  }
  for (int n = 0; n < 4; ++n) {
    const Meeting near = straightAt(random), graze = grazing(random, depthOfGraze(random));
    PROBE(time(near, 9));
    PROBE(status(graze, 1e4));
    const auto halfChord = [&graze] {
      return std::round(1e8 * (graze.b.centre.x() + time(graze, 1e4) * graze.b.velocity.x()));
    };
    PROBE(halfChord());
    PROBE(status(meeting(random, 3), 2.5));
    Meeting parting = meeting(random, 2);
    parting.a.velocity = -parting.a.velocity;
    parting.b.velocity = -parting.b.velocity;
    PROBE(status(parting, 9));
  }
}

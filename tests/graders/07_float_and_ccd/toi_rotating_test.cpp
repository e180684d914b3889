// Grader of 07.toi_rotating: thin plates and single points, which a step that is too long goes
// past; times in closed form, or from the height of a rod's lower end.

#include "carom/toi/toi_rotating.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "grading/fields_toi.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Corners = std::vector<Vector3>;

constexpr Real kTolerance = 1e-6;
constexpr int kMany = 20000;

struct Pair {
  Corners a;
  Sweep A;
  Corners b;
  Sweep B;
};

Sweep at(const Vector3& place) {
  return {.start = {Matrix3::Identity(), place}};
}
// A plate without thickness in the plane of z = 0.
Corners plate() {
  return {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
}
Corners box(const Vector3& half) {
  Corners corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(
        {k & 1 ? half.x() : -half.x(), k & 2 ? half.y() : -half.y(), k & 4 ? half.z() : -half.z()});
  }
  return corners;
}
Pair swapped(const Pair& p) {
  return {p.b, p.B, p.a, p.A};
}

// A box of 20 cm at a height, and a plate.
Pair boxAbovePlate(Real height, Real speed, Real acceleration) {
  Pair p = {box({0.1, 0.1, 0.1}), at({0.2, 0.3, height + 0.1}), plate(), {}};
  p.A.velocity = {1, 0, speed};
  p.A.acceleration = {0, 0, acceleration};
  return p;
}

// A blade of 1 m that turns about its end, which rests at the origin, and a point that it reaches
// after an angle.
Pair bladeAndPoint(Real rate, Real angle, Real distance) {
  Pair p = {{{-0.5, 0, 0}, {0.5, 0, 0}}, at({0.5, 0, 0}), {Vector3::Zero()}, {}};
  p.A.centre = {-0.5, 0, 0};
  p.A.angularVelocity = {0, 0, rate};
  p.B.start.p_WB = distance * Vector3(std::cos(angle), std::sin(angle), 0);
  return p;
}

// The same pair, so many times as large.
Pair scaled(Pair p, Real size) {
  for (Corners* corners : {&p.a, &p.b}) {
    for (Vector3& corner : *corners) corner *= size;
  }
  for (Sweep* sweep : {&p.A, &p.B}) {
    sweep->start.p_WB *= size;
    sweep->velocity *= size;
    sweep->acceleration *= size;
    sweep->centre *= size;
  }
  return p;
}

// A rod of 2 m that spins about the y axis while it falls onto a plate.
struct Rod {
  Real height, angle, rate, speed;

  Pair pair() const {
    Pair p = {{{-1, 0, 0}, {1, 0, 0}}, at({0, 0, height}), plate(), {}};
    const Real c = std::cos(angle), s = std::sin(angle);
    p.A.start.R_WB << c, 0, s, 0, 1, 0, -s, 0, c;
    p.A.angularVelocity = {0, rate, 0};
    p.A.velocity = {0, 0, -speed};
    p.A.acceleration = {0, 0, -9.81};
    return p;
  }
  Real gap(Real t) const {
    return height - speed * t - 9.81 / 2 * t * t - std::abs(std::sin(angle + rate * t));
  }
  // The first time at which the lower end is at the plate, between two of many times.
  Real first() const {
    Real open = 0, closed = 1e-4;
    while (gap(closed) > 0) open = closed, closed += 1e-4;
    for (int i = 0; i < 60; ++i) {
      const Real middle = (open + closed) / 2;
      (gap(middle) > 0 ? open : closed) = middle;
    }
    return open;
  }
  Real closingSpeed(Real t) const {
    return (gap(t - 1e-5) - gap(t)) / 1e-5;
  }
};

// One that does not graze.
Rod anyRod(Random& random) {
  while (true) {
    const Rod rod = {random.between(1.3, 2.5), random.between(0.1, 1.2), random.between(2, 8),
                     random.between(0, 3)};
    if (rod.closingSpeed(rod.first()) > 1) return rod;
  }
}

TimeOfImpact run(const Pair& p, Real duration, int maxSteps = kMany) {
  return toiRotating(p.a, p.A, p.b, p.B, duration, kTolerance, maxSteps);
}
Real late(const TimeOfImpact& hit, Real first) {
  return std::max(0.0, hit.time - first);
}

void askStatus(const Pair& p, Real duration, ImpactStatus expected, const char* what,
               int maxSteps = kMany) {
  const Corners &a = p.a, &b = p.b;
  const Sweep &A = p.A, &B = p.B;
  const Real tolerance = kTolerance;
  GRADE(toiRotating(a, A, b, B, duration, tolerance, maxSteps).status, expected,
        within(0, "the status is one of four"), given("a", p.a, "m"), given("A", p.A),
        given("b", p.b, "m"), given("B", p.B), given("duration", duration, "s"),
        given("maxSteps", maxSteps), about(what));
}
void askHit(const Pair& p, Real duration, Real first, Real speed, const char* what) {
  askStatus(p, duration, ImpactStatus::kHit, what);
  const Corners &a = p.a, &b = p.b;
  const Sweep &A = p.A, &B = p.B;
  const Real tolerance = kTolerance;
  GRADE(toiRotating(a, A, b, B, duration, tolerance, kMany).time, first,
        within(1.2 * kTolerance / speed, "the tolerance of 1e-6 m, divided by the closing speed"),
        given("a", p.a, "m"), given("A", p.A), given("b", p.b, "m"), given("B", p.B),
        given("duration", duration, "s"), unit("s"), about(what));
  GRADE(late(toiRotating(a, A, b, B, duration, tolerance, kMany), first), 0,
        within(1e-11, "it may be early, but never late"), given("a", p.a, "m"), given("A", p.A),
        given("b", p.b, "m"), given("B", p.B), given("duration", duration, "s"), unit("s"),
        about(what));
}

}  // namespace

TEST_CASE("flies") {
  Random random(seed());
  askHit(boxAbovePlate(2, -4, 0), 3, 0.5, 4, "a box flies down, 2 m at 4 m/s, to a thin plate");
  for (int n = 0; n < 3; ++n) {
    const Real height = random.between(0.5, 3), speed = random.between(2, 20);
    const Pair p = boxAbovePlate(height, -speed, 0);
    askHit(n % 2 ? swapped(p) : p, 5, height / speed, speed, "a box flies down to a thin plate");
  }
}

TEST_CASE("speeds_up") {
  Random random(seed() + 1);
  for (int n = 0; n < 3; ++n) {
    const Real height = random.between(0.5, 3), pull = random.between(5, 12);
    const Pair p = boxAbovePlate(height, 0, -pull);
    askHit(n % 2 ? swapped(p) : p, 2, std::sqrt(2 * height / pull), std::sqrt(2 * height * pull),
           "a box is let go above a thin plate");
  }
  for (int n = 0; n < 3; ++n) {
    const Real height = random.between(0.5, 2), pull = random.between(5, 12);
    const Real speed = std::sqrt(2 * pull * height) * random.between(1.1, 1.5);
    const Real end = std::sqrt(speed * speed - 2 * pull * height);
    const Pair p = boxAbovePlate(height, -speed, pull);
    askHit(n % 2 ? swapped(p) : p, 3, (speed - end) / pull, end,
           "a box is shot at a thin plate, and braked all the way");
  }
}

TEST_CASE("turns") {
  Random random(seed() + 2);
  for (int n = 0; n < 4; ++n) {
    const Real rate = random.between(5, 60), angle = random.between(0.7, 1.3);
    const Real distance = random.between(0.8, 0.95);
    const Pair p = bladeAndPoint(rate, angle, distance);
    askHit(
        n % 2 ? swapped(p) : p, 0.9 * std::numbers::pi / rate, angle / rate, rate * distance,
        n % 2 ? "B is a blade that turns about its end" : "A is a blade that turns about its end");
  }
}

TEST_CASE("rod") {
  const Rod known = {1.2, 0.2, 6, 0};
  askHit(known.pair(), 2, 0.20632685398360324, known.closingSpeed(0.20632685398360324),
         "a rod of 2 m, let go 1.2 m above a plate, spinning at 6 rad/s");
  Random random(seed() + 3);
  for (int n = 0; n < 3; ++n) {
    const Rod rod = anyRod(random);
    const Real first = rod.first();
    askHit(rod.pair(), 2, first, rod.closingSpeed(first),
           "a rod that falls and spins onto a thin plate");
  }
  // A long one: its tips move much faster than its angular velocity says.
  const Pair far = scaled(bladeAndPoint(3, 1, 0.9), 8);
  askHit(far, 1, 1.0 / 3, 3 * 7.2, "a blade of 8 m that turns at 3 rad/s");
}

TEST_CASE("status") {
  const Pair p = boxAbovePlate(2, -4, 0);
  askStatus(p, 0.49, ImpactStatus::kNoHit, "2 m at 4 m/s, and 0.49 s");
  askStatus(p, 3, ImpactStatus::kHit, "the same, and 3 s");
  const Pair spinning = Rod{1.5, 0.2, 6, 0}.pair();
  Pair high = spinning;
  high.A.acceleration = Vector3::Zero();
  askStatus(high, 1, ImpactStatus::kNoHit, "a rod that spins in place, too high for the plate");
  askStatus(high, 1, ImpactStatus::kLimit, "the same, with three steps", 3);
  Pair deep = p;
  deep.A.start.p_WB.z() = 0.05;
  askStatus(deep, 1, ImpactStatus::kOverlapping, "a box that is in the plate at the start");
}

TEST_CASE("refuses") {
  const Pair p = boxAbovePlate(2, -4, 0);
  GRADE_REFUSES(toiRotating(p.a, p.A, p.b, p.B, 1, 0, 10), given("tolerance", 0.0, "m"));
}

PROBES() {
  Random random(712);
  for (int n = 0; n < 3; ++n) {
    const Real rate = random.between(5, 60), angle = random.between(0.7, 1.3);
    const Pair blade = bladeAndPoint(rate, angle, random.between(0.8, 0.95));
    PROBE(run(blade, 3 / rate, 400).time);
    PROBE(run(swapped(blade), 3 / rate, 400).time);
    PROBE(run(blade, 3 / rate, 2).time);
    PROBE(run(scaled(blade, 5), 3 / rate, 2).time);
    const Real height = random.between(0.5, 2);
    PROBE(run(boxAbovePlate(height, -5, 0), 3, 400).time);
    PROBE(run(boxAbovePlate(height, 0, -9), 3, 400).time);
    PROBE(run(boxAbovePlate(height, -8, 9), 3, 400).time);
    PROBE(run(boxAbovePlate(height, -1, 0), height / 2, 400).time);
    PROBE(run(anyRod(random).pair(), 2, 2000).time);
  }
}

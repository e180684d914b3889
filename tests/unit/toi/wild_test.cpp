// Numbers of all sizes: an answer that is finite and true, or a refusal; never a hang.

#include <array>
#include <cmath>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/swept_ball_plane.hpp"
#include "carom/toi/swept_balls.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

Real anySize(Random& random, Real decades) {
  return std::pow(10.0, random.between(-decades, decades));
}

Vector3 anyVector(Random& random, Real decades) {
  if (random.bits() % 8 == 0) return Vector3::Zero();
  const Real size = anySize(random, decades);
  return size * random.direction();
}

Shape anyShape(Random& random, Real decades) {
  const auto size = [&] { return anySize(random, decades); };
  switch (random.bits() % 5) {
    case 0:
      return Ball{size()};
    case 1: {
      const Real x = size(), y = size();
      return Box{{x, y, size()}};
    }
    case 2: {
      const Real radius = size();
      return Capsule{radius, size()};
    }
    case 3: {
      const Real radius = size();
      return Cylinder{radius, size()};
    }
    default: {
      const Real scale = size();
      std::vector<Vector3> corners;
      for (int i = 0; i < 12; ++i) corners.push_back(scale * random.direction());
      return hullOfPoints(corners);
    }
  }
}

Sweep anySweep(Random& random, Real decades) {
  Sweep s;
  const Vector3 axis = random.direction();
  const Quaternion q = integrateOrientation({1, 0, 0, 0}, axis, random.between(-3, 3));
  s.start = poseOf(q, anyVector(random, decades));
  s.velocity = anyVector(random, decades);
  s.acceleration = anyVector(random, decades);
  s.angularVelocity = anyVector(random, decades);
  s.centre = anyVector(random, decades);
  return s;
}

bool isFinite(const TimeOfImpact& t) {
  return std::isfinite(t.time) && t.point.allFinite() && t.normal.allFinite() &&
         std::isfinite(t.gap);
}

}  // namespace

TEST_CASE("motions of all sizes have a finite answer or are refused") {
  for (const Real decades : {0.5, 3.0, 12.0, 38.0, 150.0, 300.0}) {
    Random random(41);
    int answered = 0, limits = 0;
    for (int i = 0; i < 300; ++i) {
      const Shape a = anyShape(random, std::min(decades, 38.0));
      const Shape b = anyShape(random, std::min(decades, 38.0));
      const Real duration = anySize(random, decades);
      INFO("1e" << decades << ", pair " << i);
      try {
        const Sweep A = anySweep(random, decades), B = anySweep(random, decades);
        const TimeOfImpact t = firstContact(a, A, b, B, duration, {.maxSteps = 50});
        ++answered;
        CHECK(isFinite(t));
        CHECK(t.time >= 0);
        CHECK(t.time <= duration);
        if (t.status == ImpactStatus::kLimit) ++limits;
      } catch (const InvalidInput&) {
        CHECK(decades > 12);
      }
      const MovingBall p = {anySize(random, decades), anyVector(random, decades),
                            anyVector(random, decades)};
      const MovingBall q = {anySize(random, decades), anyVector(random, decades),
                            anyVector(random, decades)};
      try {
        const TimeOfImpact balls = sweptBalls(p, q, duration);
        CHECK(isFinite(balls));
        const TimeOfImpact plane = sweptBallPlane(p, anyVector(random, decades), {}, duration);
        CHECK(isFinite(plane));
      } catch (const InvalidInput&) {
        CHECK(decades > 12);
      }
    }
    INFO("1e" << decades << ": " << answered << " answered, " << limits << " gave up");
    CHECK(answered > (decades > 100 ? 0 : 20));
  }
}

// Friction at one contact: sliding, rolling, spinning.

#include <cmath>
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/impulse/friction_impulse.hpp"
#include "carom/impulse/rolling_friction.hpp"
#include "carom/impulse/spinning_friction.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
const Vector3 kUp(0, 0, 1);
}  // namespace

TEST_CASE("fast slip is braked with mu times the normal impulse, whatever its speed") {
  // Errata 6.11 and 6.13: the impulse depends on the pressure and not on the speed.
  for (const Real speed : {2.0, 20.0, 2e8}) {
    const Vector3 J = frictionImpulse({speed, 0, -1}, kUp, 3, 0.25, 1);
    CHECK(J == Vector3(-0.75, 0, 0));
  }
}

TEST_CASE("slow slip is stopped and not more than stopped") {
  const Vector3 J = frictionImpulse({0.3, 0.4, -7}, kUp, 100, 0.5, 2);
  CHECK(nearVector(J, Vector3(-0.6, -0.8, 0)));
}

TEST_CASE("erratum 6.14: a perfectly smooth contact has no friction, and a rough one no bounce") {
  // The source's 1 + c stops all sliding for c = 0 and turns it round for c = 1.
  const Vector3 u(1, 2, -1);
  CHECK(frictionImpulse(u, kUp, 5, 0, 1) == Vector3(0, 0, 0));
  const Vector3 rough = frictionImpulse(u, kUp, 1e9, 1, 1);
  CHECK(nearVector(rough, Vector3(-1, -2, 0)));
}

TEST_CASE("friction points against the slip, and never gives energy") {
  Random random(35);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 n = random.direction();
    const Vector3 u = random.vector(3);
    const Real m = random.between(0.1, 3), jn = random.between(0, 3), mu = random.between(0, 2);
    const Vector3 J = frictionImpulse(u, n, jn, mu, m);
    const Vector3 slip = u - u.dot(n) * n;
    REQUIRE(std::abs(J.dot(n)) < 1e-14);            // erratum 6.12: tangential
    REQUIRE(J.norm() <= mu * jn * (1 + 4 * kUlp));  // the cone
    REQUIRE(J.dot(slip) <= 0);                      // against the slip
    REQUIRE((slip + J / m).dot(slip) >= -1e-14);    // never turned round
    REQUIRE(std::abs(J.norm() - std::min(mu * jn, m * slip.norm())) < 1e-13);
  }
}

TEST_CASE("no slip, no friction; no pressure, no friction") {
  CHECK(frictionImpulse({0, 0, -3}, kUp, 2, 0.5, 1) == Vector3(0, 0, 0));
  CHECK(frictionImpulse({3, 0, 0}, kUp, 0, 0.5, 1) == Vector3(0, 0, 0));
}

TEST_CASE("errata 6.15 and 6.16: a resting block is held by its weight; rubber holds more") {
  // Over a step of 0.01 s gravity gives a block on a slope of 50 degrees this much slip; it does
  // not move along the normal at all. mu = 1.5 is above tan 50 and holds it, mu = 1 does not.
  const Real g = 9.81, h = 0.01, angle = 50 * 3.14159265358979323846 / 180;
  const Vector3 u(g * std::sin(angle) * h, 0, 0);
  const Real jn = g * std::cos(angle) * h;
  CHECK((u + frictionImpulse(u, kUp, jn, 1.5, 1)).norm() == 0);
  CHECK((u + frictionImpulse(u, kUp, jn, 1.0, 1)).x() > 0.01);
}

TEST_CASE("friction works on slips whose squares are no doubles") {
  const Vector3 J = frictionImpulse({3e-200, 4e-200, 0}, kUp, 1, 1, 1);
  CHECK(nearVector(J, Vector3(-3e-200, -4e-200, 0)));
  const Vector3 fast = frictionImpulse({3e200, -4e200, 0}, kUp, 1, 1, 1);
  CHECK(nearVector(fast, Vector3(-0.6, 0.8, 0)));
}

TEST_CASE("sliding friction refuses impossible numbers") {
  CHECK_THROWS_WITH(frictionImpulse({1, 0, 0}, kUp, -1, 1, 1), ContainsSubstring("normalImpulse"));
  CHECK_THROWS_WITH(frictionImpulse({1, 0, 0}, kUp, 1, -1, 1), ContainsSubstring("friction"));
  CHECK_THROWS_WITH(frictionImpulse({1, 0, 0}, kUp, 1, 1, 0), ContainsSubstring("tangentialMass"));
  CHECK_THROWS_AS(frictionImpulse({kNan, 0, 0}, kUp, 1, 1, 1), InvalidInput);
}

TEST_CASE("a rolling ball is braked evenly and then stands still") {
  // I w' = -b N about the contact: w0 = 2.1 rad/s is gone after I w0 / (b N) seconds.
  RollingContact ball{.angularVelocity = {0, 2.1, 0}, .inertia = 0.7, .arm = 0.01};
  const Real weight = 5, h = 0.125;
  ball.normalImpulse = weight * h;
  int steps = 0;
  for (; ball.angularVelocity.norm() > 0 && steps < 1000; ++steps) {
    const Real before = ball.angularVelocity.y();
    ball.angularVelocity += rollingFriction(ball) / ball.inertia;
    CHECK(ball.angularVelocity.y() >= 0);
    CHECK(ball.angularVelocity.y() < before);
  }
  CHECK(steps == static_cast<int>(std::ceil(0.7 * 2.1 / (0.01 * weight * h))));
  CHECK(rollingFriction(ball) == Vector3(0, 0, 0));
}

TEST_CASE("rolling friction leaves spinning alone and points against the rolling") {
  const RollingContact ball{
      .angularVelocity = {3, 4, 100}, .normal = kUp, .inertia = 50, .normalImpulse = 2, .arm = 0.5};
  CHECK(nearVector(rollingFriction(ball), Vector3(-0.6, -0.8, 0)));
  CHECK(rollingFriction({.angularVelocity = {0, 0, 9}, .normalImpulse = 1, .arm = 1}) ==
        Vector3(0, 0, 0));
  CHECK_THROWS_WITH(rollingFriction({.arm = -1}), ContainsSubstring("arm = -1"));
  CHECK_THROWS_WITH(rollingFriction({.inertia = 0}), ContainsSubstring("inertia = 0"));
}

TEST_CASE("erratum 6.19: a spinning top stops") {
  const json expected = impulseCase("I9");
  // Disc of 1 kg, R = 0.1 m, mu = 0.25, 50 rad/s.
  const Real R = 0.1, g = 9.81, h = 0.001;
  SpinningContact top{
      .spin = 50, .inertia = R * R / 2, .normalImpulse = g * h, .friction = 0.25, .radius = R};
  int steps = 0;
  for (; top.spin != 0 && steps < 10000; ++steps) top.spin += spinningFriction(top) / top.inertia;
  CHECK(steps == static_cast<int>(std::ceil(number(expected["stop_time"]) / h)));
  CHECK(spinningFriction(top) == 0);
}

TEST_CASE("spinning friction turns against the spin and never turns it round") {
  const SpinningContact right{
      .spin = 3, .inertia = 2, .normalImpulse = 1.5, .friction = 0.5, .radius = 2};
  CHECK(spinningFriction(right) == -1);
  SpinningContact left = right;
  left.spin = -3;
  CHECK(spinningFriction(left) == 1);
  left.spin = -0.25;  // needs 0.5 to stop, and may take 1
  CHECK(spinningFriction(left) == 0.5);
  CHECK_THROWS_WITH(spinningFriction({.radius = -1}), ContainsSubstring("radius = -1"));
  CHECK_THROWS_AS(spinningFriction({.spin = kNan}), InvalidInput);
}

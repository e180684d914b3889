#include "carom/impulse/bouncing_ball.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

namespace {

void check(const BouncingBall& ball, const BounceLaw& law) {
  requireNonNegative(ball.height, "height");
  requireFinite(ball.velocity, "velocity");
  requireRestitution(law.restitution);
  requirePositive(law.gravity, "gravity");
}

// The first impact: when, how fast, and how long the flight after it is.
struct First {
  Real time = 0;
  Real speed = 0;
  Real flight = 0;
};

First firstImpact(const BouncingBall& ball, const BounceLaw& law) {
  const Real v = ball.velocity, g = law.gravity;
  const Real speed = std::sqrt(v * v + 2 * g * ball.height);
  // Downwards the sum (v + speed)/g would cancel.
  const Real time = v >= 0 ? (v + speed) / g : 2 * ball.height / (speed - v);
  return {time, speed, 2 * law.restitution * speed / g};
}

// 1 + e + e^2 + ... with n terms.
Real geometricSum(Real e, Real n) {
  return e == 1 ? n : (1 - std::pow(e, n)) / (1 - e);
}

}  // namespace

Real impactTime(const BouncingBall& ball, const BounceLaw& law, int number) {
  check(ball, law);
  requirePositive(number, "number");
  const First first = firstImpact(ball, law);
  return first.time + first.flight * geometricSum(law.restitution, number - 1);
}

Real restTime(const BouncingBall& ball, const BounceLaw& law) {
  check(ball, law);
  const First first = firstImpact(ball, law);
  if (first.speed == 0) return 0;
  if (law.restitution == 1) return std::numeric_limits<Real>::infinity();
  return first.time + first.flight / (1 - law.restitution);
}

BouncingBall bounceBall(const BouncingBall& ball, const BounceLaw& law, Real time) {
  requireNonNegative(time, "time");
  if (time >= restTime(ball, law)) return {0, 0};
  const First first = firstImpact(ball, law);
  const Real g = law.gravity, e = law.restitution;
  if (time <= first.time) {
    return {std::max(0.0, ball.height + (ball.velocity - g * time / 2) * time),
            ball.velocity - g * time};
  }
  // How many flights are over? The sum of n of them, solved for n.
  const Real flights = (time - first.time) / first.flight;
  const Real over = e == 1 ? flights : std::log1p(-(1 - e) * flights) / std::log(e);
  const Real n = std::floor(over);
  const Real up = first.speed * std::pow(e, n + 1);
  const Real since = time - first.time - first.flight * geometricSum(e, n);
  const Real t = std::clamp(since, 0.0, 2 * up / g);  // rounding may have miscounted by a whisker
  return {std::max(0.0, (up - g * t / 2) * t), up - g * t};
}

}  // namespace carom

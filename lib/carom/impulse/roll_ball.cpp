#include "carom/impulse/roll_ball.hpp"

#include <limits>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

namespace {

Real lengthOf(const Vector2& v) {
  return length({v.x(), v.y(), 0});
}

void check(const TableBall& ball, const TableLaw& law) {
  requireFinite(Vector3(ball.position.x(), ball.position.y(), 0), "position");
  requireFinite(Vector3(ball.velocity.x(), ball.velocity.y(), 0), "velocity");
  requireFinite(ball.angularVelocity, "angularVelocity");
  requirePositive(law.radius, "radius");
  requireNonNegative(law.friction, "friction");
  requirePositive(law.gravity, "gravity");
  requirePositive(law.gyration, "gyration");
}

// Below this part of the speeds that make it up a slip is rounding, and the ball rolls.
constexpr Real kRollingSlip = 4 * std::numeric_limits<Real>::epsilon();

bool rolls(const TableBall& ball, const TableLaw& law) {
  const Real scale = lengthOf(ball.velocity) + law.radius * length(ball.angularVelocity);
  return lengthOf(slipOf(ball, law)) <= kRollingSlip * scale;
}

}  // namespace

Vector2 slipOf(const TableBall& ball, const TableLaw& law) {
  const Vector3& w = ball.angularVelocity;
  return {ball.velocity.x() - w.y() * law.radius, ball.velocity.y() + w.x() * law.radius};
}

Real timeToRoll(const TableBall& ball, const TableLaw& law) {
  check(ball, law);
  if (rolls(ball, law)) return 0;
  const Real braking = law.friction * law.gravity * (1 + 1 / law.gyration);
  return lengthOf(slipOf(ball, law)) / braking;
}

TableBall rollBall(const TableBall& ball, const TableLaw& law, Real time) {
  requireNonNegative(time, "time");
  const Real toRoll = timeToRoll(ball, law);
  TableBall moved = ball;
  const Vector2 slip = slipOf(ball, law);
  if (time < toRoll) {
    // One parabola: v changes by -mu g t along the slip, the spin by as much over k R.
    const Vector2 change = -law.friction * law.gravity * time / lengthOf(slip) * slip;
    moved.position += time * (ball.velocity + change / 2);
    moved.velocity += change;
    const Real turn = 1 / (law.gyration * law.radius);
    moved.angularVelocity.x() += turn * change.y();
    moved.angularVelocity.y() -= turn * change.x();
    return moved;
  }
  if (toRoll > 0) {
    // What is left of the slip when it has gone: v takes k/(1 + k) of it.
    const Vector2 change = -law.gyration / (1 + law.gyration) * slip;
    moved.position += toRoll * (ball.velocity + change / 2);
    moved.velocity += change;
    moved.angularVelocity.x() = -moved.velocity.y() / law.radius;
    moved.angularVelocity.y() = moved.velocity.x() / law.radius;
  }
  moved.position += (time - toRoll) * moved.velocity;
  return moved;
}

}  // namespace carom

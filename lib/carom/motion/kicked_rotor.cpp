#include "carom/motion/kicked_rotor.hpp"

#include <array>

#include "carom/core/checks.hpp"
#include "carom/motion/extrapolation.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {
namespace {

void requireUsable(const RotorState& state, Real time, Real dt, const Torque& torque) {
  requireUsable(state);
  requireFinite(time, "time");
  requireFinite(dt, "dt");
  if (!torque) reject("torque", "an empty function", "must be callable");
}

// A kick: the torque at a time and place changes the angular momentum.
void kick(const SplitRotor& rotor, TurningBody& body, Real dt, Real time, const Torque& torque) {
  const RotorState there = {body.q_WB, rotor.angularVelocity(body.momentum)};
  body.momentum += dt * torque(time, there);
}

}  // namespace

RotorState kickedRotor(const SplitRotor& body, const RotorState& state, Real time, Real dt,
                       std::span<const Real> weights, const Torque& torque) {
  requireUsable(state, time, dt, torque);
  TurningBody b = {state.q_WB, body.moments().cwiseProduct(state.angularVelocity)};
  Real turn = 0, done = 0;  // how much free turning is owed, and how far the kicks have come [1]
  for (const Real w : weights) {
    body.turn4(b, (turn + w / 2) * dt);
    kick(body, b, w * dt, time + (done + w / 2) * dt, torque);
    turn = w / 2;
    done += w;
  }
  body.turn4(b, turn * dt);
  return {renormalize(b.q_WB), body.angularVelocity(b.momentum)};
}

RotorState kickedRotor(const SplitRotor& body, const RotorState& state, Real time, Real dt,
                       int count, const Splitting& method, const Torque& torque) {
  requireUsable(state, time, dt, torque);
  if (count < 0) reject("count", std::to_string(count), "must be zero or more");
  TurningBody b = {state.q_WB, body.moments().cwiseProduct(state.angularVelocity)};
  takeTurns(
      method, dt, count, [&](Real h) { body.turn4(b, h); },
      [&](Real h, Real done) { kick(body, b, h, time + done, torque); });
  return {renormalize(b.q_WB), body.angularVelocity(b.momentum)};
}

RotorState extrapolatedRotor(const SplitRotor& body, const RotorState& state, Real time, Real dt,
                             int count, int answers, const Torque& torque) {
  requireUsable(state, time, dt, torque);
  if (count < 0) reject("count", std::to_string(count), "must be zero or more");
  if (answers < 1 || answers > kMostAnswers) {
    reject("answers", std::to_string(answers), "must be from 1 to " + std::to_string(kMostAnswers));
  }
  const std::array<Real, kMostAnswers> weights = extrapolationWeights(answers);
  TurningBody b = {state.q_WB, body.moments().cwiseProduct(state.angularVelocity)};
  for (int step = 0; step < count; ++step) {
    const Real start = time + step * dt;
    TurningBody sum = {{0, 0, 0, 0}, Vector3::Zero()};
    for (int k = 1; k <= answers; ++k) {
      // Verlet's method k times: its first and last turns are halves.
      const Real h = dt / k;
      TurningBody a = b;
      body.turn4(a, h / 2);
      for (int i = 0; i < k; ++i) {
        kick(body, a, h, start + (i + 0.5) * h, torque);
        body.turn4(a, i + 1 < k ? h : h / 2);
      }
      const Real w = weights[static_cast<std::size_t>(k - 1)];
      sum.q_WB = {sum.q_WB.w + w * a.q_WB.w, sum.q_WB.x + w * a.q_WB.x, sum.q_WB.y + w * a.q_WB.y,
                  sum.q_WB.z + w * a.q_WB.z};
      sum.momentum += w * a.momentum;
    }
    b = {renormalize(sum.q_WB), sum.momentum};
  }
  return {renormalize(b.q_WB), body.angularVelocity(b.momentum)};
}

}  // namespace carom

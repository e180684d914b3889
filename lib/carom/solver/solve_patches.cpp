#include "carom/solver/solve_patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

// The friction that a block asks for, with the slip that it sees now and the pressure it has now.
Vector3 wantedRub(const ContactBlock& block, const Vector3& slip, Real pressed) {
  const Real limit = block.friction * pressed;
  if (block.slips) {
    // Against the mean of the slips at both ends; against the first one if it has turned round.
    const bool ahead = block.slipBefore.dot(slip) > 0;
    const Vector3 along = ahead ? Vector3(block.slipBefore + slip) : block.slipBefore;
    return -limit / along.norm() * along;
  }
  const Vector3 sticking = block.rub - block.inverse * slip;
  if (sticking.squaredNorm() <= limit * limit) return sticking;
  // On the cone friction points against the slip: what stays when a small step along it is taken
  // and put back onto the cone.
  const Vector3 next = block.rub - block.lightest * slip;
  const Real size = next.norm();
  return size > limit ? Vector3(limit / size * next) : next;
}

// One visit. Returns the largest change of a speed.
Real visit(ContactBlock& block, MovingBody& a, MovingBody& b) {
  Real change = 0;
  if (block.rubs > 0) {
    Real pressed = 0;
    for (int i = 0; i < block.count; ++i) pressed += block.impulses[i];
    Vector3 slip = Vector3::Zero();
    for (int k = 0; k < block.rubs; ++k) slip[k] = speedAtEnd(block.tangents[k], a, b);
    const Vector3 rub = wantedRub(block, slip, pressed);
    const Vector3 added = rub - block.rub;
    block.rub = rub;
    for (int k = 0; k < block.rubs; ++k) pushAlong(block.tangents[k], added[k], a, b);
    change = added.norm() / block.lightest;
  }
  for (int i = 0; i < block.count; ++i) {
    if (block.masses[i] == 0) continue;
    const Real missing = block.targets[i] - speedAtEnd(block.normals[i], a, b);
    const Real total = std::max(Real(0), block.impulses[i] + block.masses[i] * missing);
    const Real added = total - block.impulses[i];
    block.impulses[i] = total;
    pushAlong(block.normals[i], added, a, b);
    change = std::max(change, std::abs(added) / block.masses[i]);
  }
  return change;
}

}  // namespace

Sweeps solvePatches(std::span<MovingBody> bodies, std::span<ContactBlock> blocks,
                    const SweepLimits& limits) {
  Sweeps done;
  std::int64_t rows = 0;
  for (const ContactBlock& block : blocks) rows += block.count + block.rubs;
  if (rows == 0) return done;
  const std::int64_t most = std::max<std::int64_t>(limits.least, limits.rowBudget / rows);
  const Real little = limits.tolerance * limits.speed;
  // Rounding keeps the last digits moving; when they do not settle further it is time to stop.
  constexpr Real kAlmost = 1e-11;
  constexpr int kPatience = 12;
  Real best = std::numeric_limits<Real>::infinity();
  int unchanged = 0;
  do {
    done.change = 0;
    for (ContactBlock& block : blocks) {
      const Real change = visit(block, bodies[block.bodyA], bodies[block.bodyB]);
      done.change = std::max(done.change, change);
    }
    ++done.sweeps;
    unchanged = done.change < best / 2 ? 0 : unchanged + 1;
    best = std::min(best, done.change);
    if (best < kAlmost * limits.speed && unchanged > kPatience) break;
  } while (done.change > little && done.sweeps < most);
  done.rows = rows * done.sweeps;
  return done;
}

}  // namespace carom

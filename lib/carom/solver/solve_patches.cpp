#include "carom/solver/solve_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "carom/impulse/positive_solve.hpp"
#include "carom/solver/friction_law.hpp"

namespace carom {

namespace {

// The friction within a cone of the given size that acts against a slip, which is w without it and
// w + S f with it: f = -(S + s)^-1 w with s = 0 if that sticks, else such that |f| is the limit.
// Newton's method for 1/|f| - 1/limit, which is almost a straight line in s (Moré and Sorensen
// 1983).
Vector3 frictionAgainst(const ContactBlock& block, const Vector3& w, Real limit) {
  const Vector3 sticking = -(block.inverse * w);
  if (sticking.squaredNorm() <= limit * limit) return sticking;
  if (!(limit > 0)) return Vector3::Zero();
  // Below this the friction is too large, above it too small.
  const Real reach = w.norm() / limit;
  Real s = std::max(Real(0), reach - 1 / block.lightest);
  Vector3 f = sticking;
  if (!std::isfinite(reach)) return Vector3::Zero();
  constexpr int kMost = 20;
  constexpr Real kExact = 4 * std::numeric_limits<Real>::epsilon();
  for (int i = 0; i < kMost; ++i) {
    const PositiveSolve solve(block.matrix + s * Matrix3::Identity());
    f = -solve.solve(w);
    const Real size = f.norm();
    if (std::abs(size - limit) <= kExact * limit) break;
    const Real slope = f.dot(solve.solve(f));  // of -|f|^2 / 2
    s = std::max(Real(0), s + (size - limit) / limit * size * size / slope);
  }
  return limit / f.norm() * f;
}

// The friction that a block asks for, with the slip that it sees now and the pressure it has now.
// Where slip turns aside its two laws meet in a jump, and neither may hold at what the other leads
// to: sweeps would go to and fro for ever. After a few changes friction is against the slip at the
// end alone, which has one law.
Vector3 wantedRub(ContactBlock& block, const Vector3& slip, Real pressed) {
  constexpr int kMostChanges = 8;
  const Real limit = block.friction * pressed;
  const Vector3 without = slip - block.matrix * block.rub;
  FrictionLaw law = frictionLaw(block, without, limit);
  if (law.given != block.given) {
    block.given = law.given;
    if (++block.lawChanges > kMostChanges) {
      block.slips = false;
      law = frictionLaw(block, without, limit);
    }
  }
  if (law.given) return -limit / law.before.norm() * law.before;
  return frictionAgainst(block, law.before + without, limit);
}

// All points at once: what stops them all, or, if that would make one of them pull, an even
// pressure. What is even stays even: a straight stack is not tilted by the order in which its
// corners are visited. Returns the largest change of a speed.
Real pressTogether(ContactBlock& block, MovingBody& a, MovingBody& b) {
  Vector3 missing = Vector3::Zero();
  for (int i = 0; i < block.count; ++i) {
    missing += (block.targets[i] - speedAtEnd(block.normals[i], a, b)) * block.places[i];
  }
  const Vector3 plane = block.plane * missing;
  std::array<Real, 4> added = {};
  Real least = 0;
  for (int i = 0; i < block.count; ++i) {
    added[i] = plane.dot(block.places[i]);
    least = std::min(least, block.impulses[i] + added[i]);
  }
  if (least < 0) {
    Real even = block.evenMass * missing.x();
    for (int i = 0; i < block.count; ++i) even = std::max(even, -block.impulses[i]);
    added.fill(even);
  }
  Real change = 0;
  for (int i = 0; i < block.count; ++i) {
    block.impulses[i] += added[i];
    pushAlong(block.normals[i], added[i], a, b);
    change = std::max(change, std::abs(added[i]) / block.masses[i]);
  }
  return change;
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
  if (block.evenMass > 0) change = std::max(change, pressTogether(block, a, b));
  for (int i = 0; i < block.count; ++i) {
    if (block.masses[i] == 0) continue;
    const Real missing = block.targets[i] - speedAtEnd(block.normals[i], a, b);
    const Real wanted = block.impulses[i] + block.masses[i] * missing;
    const Real total = block.holds[i] ? wanted : std::max(Real(0), wanted);
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
  // What is no nearer after so many rows, or sweeps, will not be: it goes round in a circle.
  constexpr int kCircleSweeps = 300;
  constexpr std::int64_t kCircleRows = 50'000;
  const std::int64_t circle = std::max<std::int64_t>(kCircleSweeps, kCircleRows / rows);
  Real best = std::numeric_limits<Real>::infinity();
  int unchanged = 0;
  do {
    done.change = 0;
    for (ContactBlock& block : blocks) {
      const Real change = visit(block, bodies[block.bodyA], bodies[block.bodyB]);
      done.change = std::max(done.change, change);
    }
    ++done.sweeps;
    // A steep edge that slips can jam: friction presses it, and pressure makes friction, without
    // end (Painlevé 1895). It then does not slip on but sticks, as far as the cone allows.
    constexpr Real kWild = 100;
    if (done.change > kWild * limits.speed) {
      for (ContactBlock& block : blocks) block.slips = false;
    }
    unchanged = done.change < best / 2 ? 0 : unchanged + 1;
    best = std::min(best, done.change);
    if (unchanged > (best < kAlmost * limits.speed ? kPatience : circle)) break;
  } while (done.change > little && done.sweeps < most);
  done.rows = rows * done.sweeps;
  return done;
}

}  // namespace carom

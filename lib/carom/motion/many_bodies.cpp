#include "carom/motion/many_bodies.hpp"

#include "carom/core/checks.hpp"

namespace carom {
namespace {

void requireAsMany(std::size_t count, std::size_t expected, const char* name) {
  if (count == expected) return;
  reject(name, std::to_string(count),
         "must be that of the velocities, " + std::to_string(expected));
}

}  // namespace

void stepFalling(std::span<Real> positions, std::span<Real> velocities, Real acceleration,
                 Real dt) {
  requireAsMany(positions.size(), velocities.size(), "number of positions");
  requireFinite(acceleration, "acceleration");
  requireFinite(dt, "dt");
  const std::size_t n = positions.size();
  Real* x = positions.data();
  Real* v = velocities.data();
  if (acceleration == 0) {
    // To add zero would only turn -0 into 0: the velocities need not be written.
    for (std::size_t i = 0; i < n; ++i) x[i] = x[i] + dt * v[i];
    return;
  }
  const Real fall = dt * dt / 2 * acceleration, gain = dt / 2 * (acceleration + acceleration);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = x[i] + dt * v[i] + fall;
    v[i] = v[i] + gain;
  }
}

void beginSteps(std::span<Real> positions, std::span<Real> velocities,
                std::span<const Real> accelerations, Real dt) {
  requireAsMany(positions.size(), velocities.size(), "number of positions");
  requireAsMany(accelerations.size(), velocities.size(), "number of accelerations");
  requireFinite(dt, "dt");
  const std::size_t n = positions.size();
  Real* x = positions.data();
  Real* v = velocities.data();
  const Real* a = accelerations.data();
  for (std::size_t i = 0; i < n; ++i) {
    v[i] += dt / 2 * a[i];
    x[i] += dt * v[i];
  }
}

void endSteps(std::span<Real> velocities, std::span<const Real> accelerations, Real dt) {
  requireAsMany(accelerations.size(), velocities.size(), "number of accelerations");
  requireFinite(dt, "dt");
  const std::size_t n = velocities.size();
  Real* v = velocities.data();
  const Real* a = accelerations.data();
  for (std::size_t i = 0; i < n; ++i) v[i] += dt / 2 * a[i];
}

}  // namespace carom

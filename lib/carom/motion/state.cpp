#include "carom/motion/state.hpp"

#include "carom/core/checks.hpp"

namespace carom {
namespace {

void requireFiniteAll(const Coordinates& values, const char* name) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      reject(std::string(name) + "[" + std::to_string(i) + "]", toText(values[i]),
             "must be finite");
    }
  }
}

}  // namespace

Coordinates accelerationAt(const Acceleration& acceleration, Real time, const Coordinates& position,
                           const Coordinates& velocity) {
  if (!acceleration) reject("acceleration", "an empty function", "must be callable");
  Coordinates a = acceleration(time, position, velocity);
  if (a.size() != position.size()) {
    reject("number of accelerations", std::to_string(a.size()),
           "must be that of the positions, " + std::to_string(position.size()));
  }
  return a;
}

void requireUsable(const State& state, Real time, Real dt) {
  if (state.position.size() != state.velocity.size()) {
    reject("number of velocities", std::to_string(state.velocity.size()),
           "must be that of the positions, " + std::to_string(state.position.size()));
  }
  requireFiniteAll(state.position, "position");
  requireFiniteAll(state.velocity, "velocity");
  requireFinite(time, "time");
  requireFinite(dt, "dt");
}

}  // namespace carom

#pragma once
// What the tests of the motion layer share: reference values from tests/cases/motion.json, and the
// equations of motion of the cases.

#include <cmath>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/state.hpp"
#include "support/cases.hpp"

namespace carom_test {

using carom::Coordinates;
using carom::Real;
using carom::State;

// One case of group N.
inline json motionCase(const std::string& id) {
  return readCase("motion", id);
}

inline Coordinates column(const std::vector<Real>& values) {
  Coordinates c(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) c[static_cast<Eigen::Index>(i)] = values[i];
  return c;
}

inline State start(const std::vector<Real>& x, const std::vector<Real>& v) {
  return {column(x), column(v)};
}

inline Coordinates spring(Real, const Coordinates& x, const Coordinates&) {
  return -x;
}

inline Coordinates duffing(Real, const Coordinates& x, const Coordinates&) {
  return column({-x[0] - x[0] * x[0] * x[0]});
}

inline Coordinates pendulum(Real, const Coordinates& x, const Coordinates&) {
  return column({-9.81 * carom::sine(x[0])});
}

// Down is positive; k = 0.05 per metre.
inline Coordinates fallWithDrag(Real, const Coordinates&, const Coordinates& v) {
  return column({9.81 - 0.05 * v[0] * std::abs(v[0])});
}

inline Coordinates kepler(Real, const Coordinates& x, const Coordinates&) {
  const Real r2 = x[0] * x[0] + x[1] * x[1];
  const Real r3 = r2 * std::sqrt(r2);
  return column({-x[0] / r3, -x[1] / r3});
}

inline State perihelion(Real e) {
  return start({1 - e, 0}, {0, std::sqrt((1 + e) / (1 - e))});
}

}  // namespace carom_test

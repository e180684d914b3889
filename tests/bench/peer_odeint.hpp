#pragma once
// Boost.odeint on the four numbers of a quaternion: Fehlberg's method of order 7(8), which chooses
// its own steps for a given tolerance.

#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>

#include "carom/rotation/quaternion.hpp"

namespace carom::bench {

template <class Rate>
Quaternion fehlberg78(const Rate& rate, const Quaternion& start, Real duration, Real tolerance) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 4>;
  State q = {start.w, start.x, start.y, start.z};
  const auto flow = [&rate](const State& p, State& out, double t) {
    const Vector3 w = rate(t) / 2;
    out[0] = -p[1] * w.x() - p[2] * w.y() - p[3] * w.z();
    out[1] = p[0] * w.x() + p[2] * w.z() - p[3] * w.y();
    out[2] = p[0] * w.y() + p[3] * w.x() - p[1] * w.z();
    out[3] = p[0] * w.z() + p[1] * w.y() - p[2] * w.x();
  };
  odeint::integrate_adaptive(
      odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance), flow, q,
      0.0, duration, 1e-2);
  return {q[0], q[1], q[2], q[3]};
}

}  // namespace carom::bench

#pragma once
// Boost.odeint on systems of any small size: its fixed steps, and its methods that choose steps.

#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "carom/core/real.hpp"

namespace carom::bench {

template <std::size_t n>
using OdeintState = std::array<double, n>;

/// Classical Runge-Kutta steps. \param flow called as flow(y, dydt, t)
template <std::size_t n, class Flow>
OdeintState<n> odeintRk4(const Flow& flow, OdeintState<n> y, Real duration, int steps) {
  boost::numeric::odeint::runge_kutta4<OdeintState<n>> stepper;
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) stepper.do_step(flow, y, i * h, h);
  return y;
}

/// McLachlan's symplectic method of order 4. \param force called as force(q, dpdt)
template <std::size_t n, class Force>
OdeintState<2 * n> odeintSymplectic(const Force& force, const OdeintState<2 * n>& start,
                                    Real duration, int steps) {
  boost::numeric::odeint::symplectic_rkn_sb3a_mclachlan<OdeintState<n>> stepper;
  OdeintState<n> q, p;
  for (std::size_t i = 0; i < n; ++i) q[i] = start[i], p[i] = start[n + i];
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) stepper.do_step(force, q, p, i * h, h);
  OdeintState<2 * n> end;
  for (std::size_t i = 0; i < n; ++i) end[i] = q[i], end[n + i] = p[i];
  return end;
}

/// Which method chooses the steps.
enum class OdeintMethod { dopri5, fehlberg78, bulirschStoer };

/// Chosen steps. \param flow called as flow(y, dydt, t) \param tolerance absolute and relative
template <std::size_t n, class Flow>
OdeintState<n> odeintAdaptive(OdeintMethod method, const Flow& flow, OdeintState<n> y,
                              Real duration, Real tolerance) {
  namespace odeint = boost::numeric::odeint;
  using State = OdeintState<n>;
  constexpr double kFirst = 1e-2;
  if (method == OdeintMethod::dopri5) {
    odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(tolerance, tolerance), flow, y,
        0.0, duration, kFirst);
  } else if (method == OdeintMethod::fehlberg78) {
    odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance), flow,
        y, 0.0, duration, kFirst);
  } else {
    odeint::bulirsch_stoer<State> stepper(tolerance, tolerance);
    odeint::integrate_adaptive(stepper, flow, y, 0.0, duration, kFirst);
  }
  return y;
}

}  // namespace carom::bench

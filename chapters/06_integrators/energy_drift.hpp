#pragma once
// Does a method keep the energy of a spring, how well, and for how long?
//
// Method: let a spring of 1 kg and 1 N/m go at 1 m, follow it for many steps, and look at its
// energy after each: how far it is ever off, and where it goes on the whole. For the second the
// mean over the later half of the run is compared with the mean over the earlier half: what swings
// averages out, what drifts does not.
// Why two numbers: velocity Verlet is off by more than Runge and Kutta's method, and comes back. In
// the end that counts for more.
// Source: section 7.4 of the source text, which finds Verlet handier; case N15.
// Not handled: explicit Euler for so long that the energy is no double any more.

#include <span>
#include <vector>

#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/velocity_verlet.hpp"

namespace carom {

/// The methods that are measured. \ingroup motion
enum class StepMethod {
  kExplicitEuler,      ///< explicitEuler()
  kSemiImplicitEuler,  ///< semiImplicitEuler()
  kVelocityVerlet,     ///< velocityVerlet()
  kRk4,                ///< rk4()
};

/// The step of a method. \param method which \return the function that makes it
/// \ingroup motion
inline Step stepOf(StepMethod method) {
  switch (method) {
    case StepMethod::kExplicitEuler:
      return explicitEuler;
    case StepMethod::kSemiImplicitEuler:
      return semiImplicitEuler;
    case StepMethod::kVelocityVerlet:
      return velocityVerlet;
    case StepMethod::kRk4:
      return rk4;
  }
  return {};
}

/// The force of a spring of 1 kg and 1 N/m. \param position n x 1 [m] \return n x 1 [m/s^2]
/// \ingroup motion
inline Coordinates unitSpring(Real, const Coordinates& position, const Coordinates&) {
  return -position;
}

/// What a method does to the energy of a spring. \ingroup motion
struct EnergyDrift {
  Real dt = 0;       ///< length of a step [s]
  Real largest = 0;  ///< largest error of the energy after any step, as a share of the first [1]
  Real drift = 0;    ///< by what share of the first the energy grows on the whole [1/s]
};

/// Measures what a method does to the energy of a spring of 1 kg and 1 N/m that is let go at 1 m.
/// \param method which
/// \param lengths of a step to try, each positive [s]
/// \param steps how many of each, an even number of at least two
/// \return one row for each length, in the order given
/// \throws InvalidInput if a length is not positive and finite, or the number of steps odd or below
/// two
/// \ingroup motion
std::vector<EnergyDrift> energyDrift(StepMethod method, std::span<const Real> lengths, int steps);

}  // namespace carom

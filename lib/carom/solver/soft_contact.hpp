#pragma once
// How does a contact push overlapping bodies apart without throwing them?
//
// Method: as a spring with a damper would, which says how fast and how smoothly it does that:
//   x'' = -2 zeta w x' - w^2 x     with x the separation and w = 2 pi f.
// The velocity at the end of the step is asked for, so that no spring is too stiff (implicit
// Euler): u' = u - h (2 zeta w u' + w^2 (x + h u')). Solved for the change of u, that is what a
// rigid row does, with three numbers more:
//   impulse of a visit = -massScale m (u + biasRate x) - impulseScale (impulse so far)
// Why frequency and damping instead of stiffness: they mean the same for a pebble and for a lorry.
// Source: Catto, GDC 2011 ("Soft constraints") and 2024 ("Solver2D"); Lacoursière 2007.
// Not handled: nothing is free: a spring under load is compressed, by F / (m w^2).

#include "carom/core/real.hpp"

namespace carom {

/// A contact that gives way a little. As it is by default, it does not. \ingroup solver
struct SoftContact {
  Real biasRate = 0;      ///< overlap is taken away at this rate [1/s]
  Real massScale = 1;     ///< share of a rigid row's impulse [1]
  Real impulseScale = 0;  ///< share of the impulse so far that is given back [1]
};

/// A spring and damper as numbers for a row.
/// \param frequency of the spring, positive [Hz]
/// \param dampingRatio one: comes back as fast as it can without swinging; zero or positive [1]
/// \param dt length of the step or sub-step, positive [s]
/// \return the three numbers
/// \throws InvalidInput if a number is out of its range
/// \ingroup solver
SoftContact softContact(Real frequency, Real dampingRatio, Real dt);

}  // namespace carom

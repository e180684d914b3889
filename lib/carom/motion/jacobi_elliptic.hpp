#pragma once
// What is to a pendulum what sine and cosine are to a spring?
//
// Method: Jacobi's elliptic functions sn, cn, dn. The arithmetic-geometric mean, which halves the
// modulus's distance to zero more than quadratically with each step, leads to a modulus so small
// that they are sine and cosine; the same steps backwards give the functions wanted. Six steps do
// for any modulus but the last before one.
// Why through means and not through a series: each step is a mean and a root, no digit cancels, and
// the angle enters through one sine and one cosine only. The phase used here is that angle, pi u /
// (2 K): a full period is 2 pi whatever the modulus, so long times can be reduced exactly.
// Why the complementary modulus k': near one the modulus k itself has lost the digits that matter.
// Source: Gauss 1799; Bulirsch, Numerische Mathematik 7, 1965 (sncndn); Abramowitz and Stegun, 16.4
// and 17.6.
// Not handled: complex arguments.

#include <array>

#include "carom/core/real.hpp"

namespace carom {

/// The three elliptic functions of one argument: sn^2 + cn^2 = 1, dn^2 + k^2 sn^2 = 1.
/// \ingroup motion
struct EllipticFunctions {
  Real sn = 0;  ///< the sine of the amplitude [1]
  Real cn = 1;  ///< the cosine of the amplitude [1]
  Real dn = 1;  ///< what is left of k [1]
};

/// The elliptic functions of one modulus. \ingroup motion
class JacobiElliptic {
 public:
  /// Prepares for a modulus, given by the complementary one.
  /// \param complement k' = sqrt(1 - k^2), above zero and at most one [1]
  /// \throws InvalidInput if it is not
  explicit JacobiElliptic(Real complement);

  /// Prepares for a modulus that is so small that the complementary one does not show it.
  /// \param complement k', above zero and at most one [1]
  /// \param modulus k, from zero to one [1]
  /// \throws InvalidInput if they are not
  JacobiElliptic(Real complement, Real modulus);

  /// The arithmetic-geometric mean of 1 and k'. \return agm(1, k') = pi / (2 K)
  Real mean() const {
    return a_[static_cast<std::size_t>(steps_)];
  }

  /// The quarter period, K. \return the complete elliptic integral of the first kind
  Real quarterPeriod() const;

  /// The functions at a phase.
  /// \param phase pi u / (2 K) [rad], any size
  /// \return sn, cn and dn of u
  EllipticFunctions at(Real phase) const;

  /// The phase at which the functions stand in a given ratio, in the quadrant of their signs.
  /// \param sn times any positive number
  /// \param cn times the same number
  /// \return phase in [-pi, pi] [rad]
  Real phaseOf(Real sn, Real cn) const;

  /// The means on the way, for sums that follow them: a_0 = 1. \param i from 0 to steps() \return
  /// a_i
  Real a(int i) const {
    return a_[static_cast<std::size_t>(i)];
  }
  /// The means on the way: b_0 = k'. \param i from 0 to steps() \return b_i
  Real b(int i) const {
    return b_[static_cast<std::size_t>(i)];
  }
  /// How many means were taken. \return steps until both agree
  int steps() const {
    return steps_;
  }

 private:
  static constexpr int kMost = 16;  // enough for k' = 1e-300
  std::array<Real, kMost + 1> a_ = {}, b_ = {};
  int steps_ = 0;
  Real firstPhase(Real sn, Real cn) const;
};

}  // namespace carom

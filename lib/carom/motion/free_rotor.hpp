#pragma once
// Where will any body in free fall point in an hour, in one evaluation?
//
// Method: the angular velocity of a free body is (a1 cn, a2 sn, a3 dn), with Jacobi's elliptic
// functions of a phase that grows steadily. The attitude follows in two parts. The direction of L
// in the body is known from the angular velocity: it says how the body lies, but for a turn about
// L. That turn grows steadily too, plus a part that comes back every period, which is the angle of
// a complex number, a theta function: a series that needs four or five terms.
// Why: no error but rounding, for any time, forwards or backwards; the cost is that of three sines.
// A body in free flight need not be stepped at all.
// Why not cancelling: everything is written with differences of moments, I1 - I2 and so on, which
// doubles subtract exactly where it matters, and with sums of terms of one sign. So bodies that are
// round, nearly round or spheres need no other formula; rotations about one axis exactly are
// steady.
// Source: Jacobi 1850; Landau and Lifshitz, Mechanics, section 37; van Zon and Schofield, Journal
// of Computational Physics 225, 2007, whose method this is (there with the theta function of
// another quarter period); Hairer, Lubich and Wanner 2006, VII.5.
// Not handled: torque. Near the unstable rotation about the middle axis the motion itself
// multiplies every error, that of the given numbers first, by some thousands per flip; and phases
// grow with time, so an error of one rounding in a rate becomes |w| t roundings.

#include <array>

#include "carom/motion/jacobi_elliptic.hpp"
#include "carom/motion/rotor.hpp"

namespace carom {

/// The free rotation of one body, from a state at one time. \ingroup motion
class FreeRotor {
 public:
  /// Prepares for a body and a state of it.
  /// \param moments principal moments of inertia [kg m^2]
  /// \param anchor attitude and angular velocity
  /// \param time when the body is in that state [s]
  /// \throws InvalidInput if a number is not finite, a moment not positive, the quaternion not of
  /// norm one, or the angular momentum or the energy too large or too small for a double
  /// \source{16}
  /// \erratum{4.5}
  FreeRotor(const Vector3& moments, const RotorState& anchor, Real time = 0);

  /// Attitude and angular velocity at a time.
  /// \param time any time [s]
  /// \return the state, its quaternion of unit norm
  /// \throws InvalidInput if the time is not finite
  RotorState at(Real time) const;

  /// The time after which the angular velocity in the body is the same again.
  /// \return period [s]; zero for a body that turns steadily
  Real period() const;

 private:
  // How the body lies, but for what the anchor adds: its rotation into a frame whose z axis is L.
  struct Pose {
    Quaternion q;
    Vector3 momentum;  // L [body]
  };
  Pose poseAt(Real elapsed) const;
  void prepareTurn(Real k, Real nu, Real slope);

  static constexpr int kMostTerms = 64;  // q < 0.99 needs no more
  Vector3 moments_;
  RotorState anchor_;
  Real time_ = 0;
  bool steady_ = false;           // turns about one axis of the body, or is a sphere
  std::array<int, 3> axes_ = {};  // which axes of the body are called 1, 2 and 3
  Real handed_ = 1;               // -1 if they are so named that the frame is left-handed
  Vector3 amplitudes_;            // of L along 1, 2, 3; the third has the sign of L there
  Real size_ = 0;                 // |L|
  JacobiElliptic elliptic_{1};    // of the modulus of this motion
  Real phase_ = 0;                // at the anchor [rad]
  Real phaseRate_ = 0;            // [rad/s]
  Real turnRate_ = 0;             // about L [rad/s]
  std::array<Real, kMostTerms> even_ = {}, odd_ = {};  // of the theta function
  int terms_ = 0;
  Quaternion frame_;  // from the frame of L to the world
};

}  // namespace carom

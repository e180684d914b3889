#pragma once
// How is a free rotation stepped for a million steps without losing energy or direction?
//
// Method: the energy of a body is a sum, and each part alone is a motion that a child can follow. A
// body with two equal moments turns steadily about its angular momentum and about its own axis: two
// rotations. What the third moment differs is one more rotation, about one axis of the body. Doing
// them in turn, half of one, all of the other, half of the first, is of order 2; thirteen turns
// with lengths found by Blanes and Moan make order 4.
// Why: each part keeps the angular momentum in the world exactly, and the whole is symplectic: the
// energy swings by an amount that depends on the step, and does not drift.
// Why not three rotations about three axes: the same order, but with a larger error, above all for
// bodies that are nearly round about an axis.
// Source: Dullweber, Leimkuhler and McLachlan, Journal of Chemical Physics 107, 1997; Hairer,
// Lubich and Wanner, Geometric Numerical Integration, 2006, VII.5; Blanes and Moan, Journal of
// Computational and Applied Mathematics 142, 2002 (S6 of order 4).
// Not handled: torque (kicked_rotor.hpp).

#include "carom/motion/rotor.hpp"

namespace carom {

/// Steps the free rotation of one body by symplectic splitting. \ingroup motion
class SplitRotor {
 public:
  /// Prepares for a body. \param moments principal moments of inertia [kg m^2]
  /// \throws InvalidInput if one is not positive and finite
  explicit SplitRotor(const Vector3& moments);

  /// The body. \return its principal moments of inertia [kg m^2]
  const Vector3& moments() const {
    return moments_;
  }

  /// One step of order 2. \param state attitude and angular velocity at the start
  /// \param dt length of the step; negative runs backwards [s]
  /// \return attitude and angular velocity after it
  /// \throws InvalidInput if a number is not finite or the quaternion not of norm one
  RotorState step2(const RotorState& state, Real dt) const;

  /// One step of order 4, at six times the cost. \param state attitude and angular velocity at the
  /// start
  /// \param dt length of the step; negative runs backwards [s]
  /// \return attitude and angular velocity after it
  /// \throws InvalidInput if a number is not finite or the quaternion not of norm one
  RotorState step4(const RotorState& state, Real dt) const;

 private:
  struct Moving {
    Quaternion q;
    Vector3 momentum;  // L [body]
  };
  void turnAbout(int axis, Real rate, Real dt, Moving& body) const;
  void turnRound(Real dt, Moving& body) const;

  Vector3 moments_;
  int odd_ = 0;         // the axis of the part that makes the body not round
  int round_ = 2;       // the axis about which the other part is round
  Real oddRate_ = 0;    // 1/I_odd - 1/I_equal [1/(kg m^2)]
  Real roundRate_ = 0;  // 1/I_round - 1/I_equal [1/(kg m^2)]
  Real equal_ = 1;      // the moment that two axes share [kg m^2]
};

}  // namespace carom

#pragma once
// How is a free rotation stepped for a million steps without losing energy or direction?
//
// Method: the energy of a body is a sum, and each part alone is a motion that a child can follow.
// Were the moments all equal, it would turn steadily about its angular momentum L. What two of them
// differ from the third is one rotation more for each, about that axis of the body. Doing these two
// in turn, half of one, all of the other, half of the first, is of order 2; thirteen turns with
// lengths found by Blanes and Moan make order 4.
// Why: each part keeps the angular momentum in the world exactly, and the whole is symplectic: the
// energy swings by an amount that depends on the step, and does not drift.
// Why it is fast: the turn about L multiplies the attitude from the left, by a rotation that stays
// the same in the world, and the others from the right. So it is done once, however many parts or
// steps there are. What is left waits for one short sine after the other.
// Source: Dullweber, Leimkuhler and McLachlan, Journal of Chemical Physics 107, 1997; Hairer,
// Lubich and Wanner, Geometric Numerical Integration, 2006, VII.5; Blanes and Moan, Journal of
// Computational and Applied Mathematics 142, 2002 (S6 of order 4).
// Not handled: torque (kicked_rotor.hpp).

#include "carom/motion/rotor.hpp"

namespace carom {

/// A body that turns, in the numbers that the splitting works with. \ingroup motion
struct TurningBody {
  Quaternion q_WB;                     ///< attitude, body to world, of unit norm but for rounding
  Vector3 momentum = Vector3::Zero();  ///< L [kg m^2/s, body]
};

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

  /// Many steps of order 4. The last turn of each and the first of the next are about the same axis
  /// and become one, and the turn about L is made once for all.
  /// \param state attitude and angular velocity at the start
  /// \param dt length of a step; negative runs backwards [s]
  /// \param count how many steps, zero or more
  /// \return attitude and angular velocity after them, those of step4() but for rounding
  /// \throws InvalidInput if a number is not finite, the quaternion not of norm one, or the count
  /// negative
  RotorState steps4(const RotorState& state, Real dt, int count) const;

  /// Turns a body as step4() does, in place and without a look at what it is given: for loops that
  /// kick it in between. \param body is turned \param dt how long; negative runs backwards [s]
  void turn4(TurningBody& body, Real dt) const;

  /// The angular velocity that goes with an angular momentum.
  /// \param momentum L [kg m^2/s, body] \return [rad/s, body]
  Vector3 angularVelocity(const Vector3& momentum) const {
    return momentum.cwiseQuotient(moments_);
  }

 private:
  TurningBody begin(const RotorState& state, Real dt) const;
  RotorState end(const TurningBody& body) const;
  template <int n, int r>
  void turnAxes(TurningBody& body, Real dt, int count, const Real (&odd)[n + 1],
                const Real (&round)[n]) const;
  template <int n>
  void turn(TurningBody& body, Real dt, int count, const Real (&odd)[n + 1],
            const Real (&round)[n]) const;

  Vector3 moments_;
  int round_ = 2;       // the axis of one of the two rotations; that of the other comes next
  Real roundRate_ = 0;  // 1/I_round - 1/I_equal [1/(kg m^2)]
  Real oddRate_ = 0;    // 1/I_odd - 1/I_equal [1/(kg m^2)]; zero: a round body
  Real equal_ = 1;      // the moment of the axis that is left [kg m^2]
};

}  // namespace carom

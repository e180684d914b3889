#pragma once
// Bodies in an impact, for the graders of chapter 5: drawn at random, and what an impulse does to
// them, written out along the bodies' own axes.

#include <array>

#include "carom/core/cross.hpp"
#include "carom/impulse/body_motion.hpp"
#include "graders/solids.hpp"
#include "grading/fields_impulse.hpp"
#include "grading/random.hpp"

namespace carom::grading {

/// A body by its mass, its three moments of inertia and the axes they belong to.
struct Solid {
  Real mass = 1;                       ///< [kg]
  Vector3 moments = Vector3::Ones();   ///< along its own axes [kg m^2]
  Matrix3 axes = Matrix3::Identity();  ///< in the columns; body to world [1]
  Velocity velocity;                   ///< [world]

  /// The tensor along the world's axes, for an angular momentum [kg m^2, world].
  Matrix3 inertia() const {
    return axes * moments.asDiagonal() * axes.transpose();
  }
  /// Its inverse [1/(kg m^2), world].
  Matrix3 inverseInertia() const {
    const Matrix3 inverse = axes * Matrix3(moments.cwiseInverse().asDiagonal()) * axes.transpose();
    return (inverse + inverse.transpose()) / 2;
  }
  /// As the functions of the chapter take it.
  MovingBody moving() const {
    return {{1 / mass, inverseInertia()}, velocity};
  }
  /// The same with the tensor along its own axes.
  OrientedBody oriented() const {
    OrientedBody body;
    body.inverseMass = 1 / mass;
    body.inverseInertia = moments.cwiseInverse().asDiagonal();
    body.R_WB = axes;
    body.velocity = velocity;
    return body;
  }
  /// What an impulse changes, one of the body's own axes after the other.
  Velocity change(const Vector3& arm, const Vector3& impulse) const {
    Velocity d;
    d.linear = impulse / mass;
    for (int k = 0; k < 3; ++k) {
      const Vector3 axis = axes.col(k);
      // The moment of the impulse about this axis: the volume that axis, arm and impulse span.
      Matrix3 span;
      span << axis, arm, impulse;
      const Real torque = span(0, 0) * (span(1, 1) * span(2, 2) - span(1, 2) * span(2, 1)) -
                          span(0, 1) * (span(1, 0) * span(2, 2) - span(1, 2) * span(2, 0)) +
                          span(0, 2) * (span(1, 0) * span(2, 1) - span(1, 1) * span(2, 0));
      d.angular += torque / moments[k] * axis;
    }
    return d;
  }
  /// The velocity of the point at the end of an arm, from where it is a moment later and earlier.
  static Vector3 pointAt(const Velocity& v, const Vector3& arm) {
    const Real rate = v.angular.norm();
    if (rate == 0) return v.linear;
    // A quarter turn carries the part of the arm across the axis where its velocity points.
    const Vector3 axis = v.angular / rate;
    const Vector3 across = arm - arm.dot(axis) * axis;
    return v.linear + rate * (turn(axis, std::acos(-1.0) / 2) * across);
  }
};

/// Any body: from 0.5 to 4 kg, about 1 m large, lying anyhow, flying and turning.
inline Solid anySolid(Random& random) {
  Solid solid;
  solid.mass = random.between(0.5, 4);
  // Moments that a solid can have: none is larger than the other two together.
  Vector3 spread;
  for (int k = 0; k < 3; ++k) spread[k] = solid.mass * random.between(0.02, 0.4);
  solid.moments = {spread.y() + spread.z(), spread.x() + spread.z(), spread.x() + spread.y()};
  solid.axes = anyTurn(random, 0.3, 2.8);
  solid.velocity.linear = random.vector(3);
  solid.velocity.angular = random.vector(3);
  return solid;
}

/// Any contact between two bodies about 1 m large.
inline Contact anyContact(Random& random) {
  Contact contact;
  contact.normal = random.direction();
  contact.armA = random.vector();
  contact.armB = random.vector();
  return contact;
}

/// How fast B's point moves away from A's along the normal [m/s].
inline Real partingSpeed(const Velocity& a, const Velocity& b, const Contact& contact) {
  return (Solid::pointAt(b, contact.armB) - Solid::pointAt(a, contact.armA)).dot(contact.normal);
}

/// The velocities of A and B after an impulse, which acts on B as it is written.
inline std::array<Velocity, 2> after(const Solid& a, const Solid& b, const Contact& contact,
                                     const Vector3& impulse) {
  const Velocity da = a.change(contact.armA, -impulse), db = b.change(contact.armB, impulse);
  return {Velocity{a.velocity.linear + da.linear, a.velocity.angular + da.angular},
          Velocity{b.velocity.linear + db.linear, b.velocity.angular + db.angular}};
}

}  // namespace carom::grading

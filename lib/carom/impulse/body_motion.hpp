#pragma once
// What does an impact need to know about a body?
//
// How fast it moves and turns, and how hard that is to change. Both are asked for as plain structs:
// no shape, no pose, no history. A body that nothing can move has zeros where others have their
// inverse mass and inverse inertia; in every formula of this layer its terms then vanish by
// themselves, so a wall needs no second formula.
// Convention: the normal of a contact points from A to B, arms point from the centre of mass to the
// contact, and an impulse acts on B as it is written, on A with the opposite sign
// (docs/notation.md).
// Why world axes in BodyMass: the velocities of two bodies can only be compared in one frame. An
// inertia tensor is known along the axes of its body, so it has to be turned each time the body has
// turned; bodyMass() does that, and OrientedBody keeps both parts for whoever wants to do it.
// Not handled: masses that flow, and bodies that bend.

#include "carom/core/real.hpp"
#include "carom/mass/mass_properties.hpp"

/// \defgroup impulse Impulse and friction: chapter 5
/// What a contact does to the velocities of the bodies.

namespace carom {

/// How a rigid body moves. \ingroup impulse
struct Velocity {
  Vector3 linear = Vector3::Zero();   ///< of the centre of mass [m/s, world]
  Vector3 angular = Vector3::Zero();  ///< [rad/s, world]
};

/// How a rigid body moves in the plane. \ingroup impulse
struct PlanarVelocity {
  Vector2 linear = Vector2::Zero();  ///< of the centre of mass [m/s, world]
  Real angular = 0;                  ///< counter-clockwise [rad/s]
};

/// How easily a body is moved and turned, as it lies now. Default: it cannot be moved.
/// \ingroup impulse
struct BodyMass {
  Real inverseMass = 0;                      ///< [1/kg]; 0: nothing can push it away
  Matrix3 inverseInertia = Matrix3::Zero();  ///< [1/(kg m^2), world, about the centre of mass]
};

/// How easily a body is moved and turned in the plane. Default: it cannot be moved.
/// \ingroup impulse
struct PlanarBodyMass {
  Real inverseMass = 0;     ///< [1/kg]; 0: nothing can push it away
  Real inverseInertia = 0;  ///< [1/(kg m^2), about the centre of mass]; 0: nothing can turn it
};

/// A body in an impact. \ingroup impulse
struct MovingBody {
  BodyMass mass;      ///< how easily it is moved [world]
  Velocity velocity;  ///< how it moves [world]
};

/// A body in an impact in the plane. \ingroup impulse
struct PlanarBody {
  PlanarBodyMass mass;      ///< how easily it is moved
  PlanarVelocity velocity;  ///< how it moves
};

/// A body whose inertia is still written along its own axes, as chapter 2 leaves it.
/// \ingroup impulse
struct OrientedBody {
  Real inverseMass = 0;                      ///< [1/kg]; 0: nothing can push it away
  Matrix3 inverseInertia = Matrix3::Zero();  ///< [1/(kg m^2), body, about the centre of mass]
  Matrix3 R_WB = Matrix3::Identity();        ///< rotation, body to world [1]
  Velocity velocity;                         ///< how it moves [world]
};

/// Where two bodies touch. \source{25,26}
/// \erratum{6.1,6.9} \ingroup impulse
struct Contact {
  Vector3 normal = Vector3::UnitZ();  ///< unit, from A to B [1, world]
  Vector3 armA = Vector3::Zero();     ///< from A's centre of mass to the contact [m, world]
  Vector3 armB = Vector3::Zero();     ///< from B's centre of mass to the contact [m, world]
};

/// Where two bodies touch in the plane. \source{25,26}
/// \ingroup impulse
struct PlanarContact {
  Vector2 normal = Vector2::UnitY();  ///< unit, from A to B [1, world]
  Vector2 armA = Vector2::Zero();     ///< from A's centre of mass to the contact [m, world]
  Vector2 armB = Vector2::Zero();     ///< from B's centre of mass to the contact [m, world]
};

/// How far the length of a normal may be from one: rounding of a normalised vector is below 4 ulp,
/// and a few rotations add as much again. A larger value lets errors through that show in energies.
/// \ingroup impulse
inline constexpr Real kUnitTolerance = 1e-12;

/// How far an inertia tensor may be from symmetric, relative to its largest entry: far above the
/// rounding of a tensor that was turned, far below any slip of the pen.
/// \ingroup impulse
inline constexpr Real kSymmetryTolerance = 1e-10;

/// How easily a weighed body is moved, lying as it does.
/// \param body its mass and inertia along its own axes; the volume and centre are not used
/// \param R_WB rotation, body to world
/// \return inverse mass and inverse inertia along the world's axes
/// \throws InvalidInput if the mass is not positive and finite, the inertia not symmetric
/// (kSymmetryTolerance) or not positive definite, or R_WB not finite
/// \erratum{4.4}
/// \ingroup impulse
BodyMass bodyMass(const MassProperties& body, const Matrix3& R_WB);

/// The same for a body that keeps its own axes.
/// \param body inverse mass, inverse inertia along its own axes, and its rotation
/// \return inverse mass and inverse inertia along the world's axes, exactly symmetric
/// \erratum{4.4}
/// \ingroup impulse
BodyMass massInWorld(const OrientedBody& body);

/// A weighed body that moves.
/// \param body its mass and inertia along its own axes
/// \param R_WB rotation, body to world
/// \param velocity how it moves [world]
/// \return the body, its inverse inertia along its own axes
/// \throws InvalidInput as bodyMass(), or if a velocity is not finite
/// \ingroup impulse
OrientedBody orientedBody(const MassProperties& body, const Matrix3& R_WB,
                          const Velocity& velocity);

/// How easily a planar body is moved.
/// \param mass positive [kg]
/// \param inertia about the centre of mass, positive [kg m^2]
/// \return inverse mass and inverse inertia
/// \throws InvalidInput if one is not positive and finite
/// \ingroup impulse
PlanarBodyMass planarBodyMass(Real mass, Real inertia);

/// Refuses a contact that cannot be worked with. \param contact any contact
/// \throws InvalidInput if a number is not finite or the normal not of length one (kUnitTolerance)
/// \ingroup impulse
void requireUsable(const Contact& contact);

/// Refuses a planar contact that cannot be worked with. \param contact any contact
/// \throws InvalidInput if a number is not finite or the normal not of length one (kUnitTolerance)
/// \ingroup impulse
void requireUsable(const PlanarContact& contact);

/// Refuses a body that cannot be worked with. Whether its tensor is definite is asked by the makers
/// only. \param body any body \param name what it is called, for the message
/// \throws InvalidInput if a number is not finite or the inverse mass is negative
/// \ingroup impulse
void requireUsable(const MovingBody& body, const char* name);

/// Refuses a planar body that cannot be worked with.
/// \param body any body \param name what it is called, for the message
/// \throws InvalidInput if a number is not finite or an inverse mass or inertia is negative
/// \ingroup impulse
void requireUsable(const PlanarBody& body, const char* name);

/// Refuses a tensor that no solid has. \param inertia any matrix [kg m^2]
/// \throws InvalidInput if it is not finite, not symmetric (kSymmetryTolerance) or not positive
/// definite
/// \ingroup impulse
void requireInertia(const Matrix3& inertia);

/// Refuses a coefficient of restitution outside of [0, 1].
/// \param restitution the coefficient [1]
/// \throws InvalidInput if it is not from zero to one: an impact would take energy from nowhere
/// \ingroup impulse
void requireRestitution(Real restitution);

}  // namespace carom

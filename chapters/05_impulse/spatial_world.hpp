#pragma once
// A world in space, made of the functions of this chapter.
//
// A step: what touches bounces, at the speeds at which it arrived; gravity, the air and Euler's
// equation change the velocities; what they press together is held, without a bounce; the bodies
// move; what overlaps is pushed apart. Normal impulses come first, and friction after them.
// Friction of a pair acts at its centre of pressure: that is where the floor pushes on the whole.
// Not handled: fast bodies, which may pass through each other, and the little energy that pushing
// out adds to what bounces (chapter 7); piles (chapter 9); the energy that the explicit step of
// Euler's equation gives a tumbling body (chapter 6).

#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/combine_restitution.hpp"
#include "carom/impulse/drag_force.hpp"
#include "carom/rotation/quaternion.hpp"

namespace carom {

/// One body of the world. Its shape is drawn about the centre of mass.
struct SpatialWorldBody {
  Shape shape;                            ///< [m, body]
  OrientedBody motion;                    ///< mass, rotation and velocity; immovable by default
  Vector3 position = Vector3::Zero();     ///< of the centre of mass [m, world]
  Quaternion orientation;                 ///< body to world
  Matrix3 inertia = Matrix3::Identity();  ///< [kg m^2, body, about the centre of mass]
  AirDrag air{.area = 0};                 ///< what the air does to it; nothing by default
  Real restitution = 0;                   ///< its own, from 0 to 1 [1]
  Real friction = 0;                      ///< its own, zero or positive [1]
  Real rollingArm = 0;                    ///< how far in front of its middle it is held up [m]
  Real patchRadius = 0;                   ///< of the disc on which it stands [m]
};

/// The whole world.
struct SpatialWorld {
  std::vector<SpatialWorldBody> bodies;             ///< in the order of their numbers
  Vector3 gravity{0, 0, -9.81};                     ///< [m/s^2]
  RestitutionRule rule = RestitutionRule::product;  ///< for two coefficients of restitution
  Real time = 0;                                    ///< since the beginning [s]
};

/// A body that can be moved.
/// \param shape about the centre of mass [m, body]
/// \param weight mass and inertia along the axes of the shape
/// \param position of the centre of mass [m, world]
/// \param velocity how it moves
/// \return the body, lying as its shape is drawn
/// \throws InvalidInput if mass, inertia or velocity cannot be worked with
SpatialWorldBody movableBody(const Shape& shape, const MassProperties& weight,
                             const Vector3& position, const Velocity& velocity = {});

/// Lets time pass. The friction of a pair is the geometric mean of both.
/// \param world is changed
/// \param dt duration, positive [s]
/// \throws InvalidInput if dt is not positive and finite, or a body cannot be worked with
void step(SpatialWorld& world, Real dt);

}  // namespace carom

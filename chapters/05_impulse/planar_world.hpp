#pragma once
// A world in the plane, made of the functions of this chapter.
//
// A step: gravity changes the velocities; the bodies move until the first two discs touch, or a
// disc touches a wall; what touches then is resolved; and so on until the step is over. Polygons
// and compounds are looked at at these moments only, and are pushed apart if they overlap.
// Not handled: fast polygons, which may pass through each other (chapter 7), walls for anything but
// discs (an immovable polygon does that), and piles (chapter 9).

#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/combine_restitution.hpp"

namespace carom {

/// One body of the world. Its shape is drawn about the centre of mass.
struct PlanarWorldBody {
  PlanarShape shape;       ///< [m, body]
  PlanarBody motion;       ///< mass and velocity; immovable by default
  Vector2 position{0, 0};  ///< of the centre of mass [m, world]
  Real angle = 0;          ///< counter-clockwise [rad]
  Real restitution = 1;    ///< its own, from 0 to 1 [1]
  Real friction = 0;       ///< its own, zero or positive [1]
};

/// A straight wall that cannot move.
struct PlanarWall {
  Vector2 normal{0, 1};  ///< unit, into the room [1, world]
  Real offset = 0;       ///< the wall is where normal . x = offset [m]
  Real restitution = 1;  ///< its own, from 0 to 1 [1]
  Real friction = 0;     ///< its own, zero or positive [1]
};

/// The whole world.
struct PlanarWorld {
  std::vector<PlanarWorldBody> bodies;              ///< in the order of their numbers
  std::vector<PlanarWall> walls;                    ///< around them
  Vector2 gravity{0, 0};                            ///< [m/s^2]
  RestitutionRule rule = RestitutionRule::product;  ///< for two coefficients of restitution
  Real time = 0;                                    ///< since the beginning [s]
  int impacts = 0;                                  ///< moments at which something hit
};

/// Lets time pass. The friction of a pair is the geometric mean of both.
/// \param world is changed
/// \param dt duration, positive [s]
/// \throws InvalidInput if dt is not positive and finite, or a body cannot be worked with
void step(PlanarWorld& world, Real dt);

}  // namespace carom

#pragma once
// What does a world have to be told about a body?
//
// Where it is, how it moves, what it is made of. The frame of the body is the user's own: its
// shapes stand in it, and position and orientation say where it is. Inside, the world keeps each
// body at its centre of mass and along its principal axes, where free motion has a closed form;
// that is nobody's business but its own. Velocities are those of the centre of mass.
// Not handled: bodies that bend, break or change their mass.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/triangle_mesh.hpp"
#include "carom/rotation/quaternion.hpp"

namespace carom::world {

/// What may move a body. \ingroup world
enum class BodyKind {
  dynamic,    ///< forces and impacts
  kinematic,  ///< only its own velocity, which nothing changes but the user
  immovable   ///< nothing
};

/// What a shape is made of. \ingroup world
struct Material {
  Real friction = 0.5;   ///< mu, zero or positive; a pair has the geometric mean of both [1]
  Real restitution = 0;  ///< e, from 0 to 1; a pair has the larger of both [1]
};

/// Which shapes meet which: a pair does if each one's mask has a bit of the other's group, unless
/// both are of one family that is not zero. \ingroup world
struct Filter {
  std::uint32_t group = 1;            ///< what this shape is, a set of bits
  std::uint32_t mask = 0xFFFF'FFFFu;  ///< what it meets, a set of bits
  std::uint32_t family = 0;           ///< shapes of one family pass through each other; 0: none
};

/// One shape of a body. \ingroup world
struct ShapeDescription {
  Shape shape = Ball{};    ///< any solid; a half-space only on bodies that no force moves
  Pose pose = {};          ///< body from shape
  Material material = {};  ///< friction and bounce
  Filter filter = {};      ///< what it meets
  Real density = 1000;     ///< positive; used where the body has no mass of its own [kg/m^3]
  /// Ground made of triangles, instead of `shape`; only on immovable bodies. Its front is where
  /// corners run counter-clockwise. It is a sheet and may be open: it carries what comes from its
  /// front, and a body whose middle is behind a face is not held by it. Two triangles share an edge
  /// if they name the same two vertices. Each triangle, ridge and rim is a shape with an id.
  std::shared_ptr<const TriangleMesh> ground = {};
};

/// A body, as the user describes it. \ingroup world
struct BodyDescription {
  BodyKind kind = BodyKind::dynamic;          ///< what may move it
  Vector3 position = Vector3::Zero();         ///< origin of the body's frame [m, world]
  Quaternion orientation = {};                ///< body to world, of norm one
  Vector3 velocity = Vector3::Zero();         ///< of the centre of mass [m/s, world]
  Vector3 angularVelocity = Vector3::Zero();  ///< [rad/s, world]
  std::vector<ShapeDescription> shapes = {};  ///< may be empty if the mass is given
  std::optional<MassProperties> mass =
      {};                ///< mass, centre and inertia in the frame of the body; if
                         ///< not given, from shapes and densities
  bool maySleep = true;  ///< false: stays awake, and all that it touches
};

}  // namespace carom::world

#pragma once
// How do bodies lie in memory so that one instruction works on four of them?
//
// Method: what a step asks for all the time, its *hot* numbers, goes into blocks of four bodies: of
// each number the four side by side. The rest, *cold*, stays where it was. The last block is filled
// up with bodies that do not exist: at rest in the origin, and of no inverse mass, so that no force
// moves them.
// Why blocks and no array per number: a block is in one place in memory, and a body is found in it.
// Source: arrays of structures of arrays are common property; the words hot and cold: Acton 2014.
// Not handled: which numbers are hot, which is for a measurement to say.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/core/real.hpp"
#include "lane_values.hpp"

namespace carom {

/// All that is known of a body, in one piece. \ingroup solver
struct WholeBody {
  std::int32_t name = 0;                      ///< as the user calls it
  Vector3 position = Vector3::Zero();         ///< of the centre of mass [m, world]
  Vector3 velocity = Vector3::Zero();         ///< of the same [m/s, world]
  Vector4 orientation = Vector4(1, 0, 0, 0);  ///< quaternion w, x, y, z
  Vector3 angularVelocity = Vector3::Zero();  ///< [rad/s, world]
  Real inverseMass = 0;                       ///< zero: cannot be moved [1/kg]
  Matrix3 inverseInertia = Matrix3::Zero();   ///< [1/(kg m^2), body]
  Real friction = 0.5;                        ///< mu [1]
  Real restitution = 0;                       ///< e [1]
};

/// What it takes to move four bodies. \ingroup solver
struct BodyBlock {
  std::array<LaneValues, 3> position;  ///< x of all four, then y, then z [m, world]
  std::array<LaneValues, 3> velocity;  ///< the same of the velocity [m/s, world]
  LaneValues inverseMass;              ///< [1/kg]
};

/// Copies what is hot into blocks. Body i stands in block i / 4, lane i % 4.
/// \param bodies any number of them
/// \return as few blocks as hold them; lanes without a body are zero
/// \ingroup solver
std::vector<BodyBlock> soaLayout(std::span<const WholeBody> bodies);

/// Copies it back. Everything else in the bodies stays as it is.
/// \param blocks as soaLayout() makes them
/// \param bodies as many as the blocks were made of
/// \throws InvalidInput if the blocks are not as many as the bodies take
/// \ingroup solver
void aosLayout(std::span<const BodyBlock> blocks, std::span<WholeBody> bodies);

}  // namespace carom

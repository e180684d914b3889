#include "carom/motion/particle_box.hpp"

#include "carom/core/checks.hpp"

namespace carom {
namespace {

Edge edgeOf(const ParticleBox& box, int axis) {
  return box.edges[static_cast<std::size_t>(axis)];
}

// Where the force of two particles is zero: the sixth root of two [sizes].
constexpr Real kRestDistance = 1.122462048309373;

}  // namespace

int dimensionsOf(const ParticleBox& box) {
  int count = 0;
  for (const Edge edge : box.edges) count += edge != Edge::Flat;
  return count;
}

Real volumeOf(const ParticleBox& box) {
  Real volume = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (edgeOf(box, axis) != Edge::Flat) volume *= box.size[axis];
  }
  return volume;
}

PairForce wallForce(const LennardJones& atoms, Real distance) {
  const LennardJones pushing = {atoms.depth, atoms.size, kRestDistance};
  const PairForce pair = pairForce(pushing, 4 * distance * distance);
  return {pair.factor, pair.energy / 2};
}

void requireUsable(const ParticleBox& box, const LennardJones& atoms) {
  if (dimensionsOf(box) == 0) reject("box", "flat along all axes", "must have room along one");
  const Real reach = atoms.cutoff * atoms.size;
  for (int axis = 0; axis < 3; ++axis) {
    const Edge edge = edgeOf(box, axis);
    const Real least = edge == Edge::Periodic ? 2 * reach : edge == Edge::Wall ? reach : 0;
    if (edge == Edge::Flat) continue;
    requireFinite(box.size, "box");
    if (!(box.size[axis] >= least)) {
      reject("box", toText(box.size),
             edge == Edge::Periodic ? "must be at least two cut-offs long where periodic"
                                    : "must be at least one cut-off long between walls");
    }
  }
}

void requireInside(const ParticleBox& box, const LennardJones& atoms, const Vector3& position,
                   const Vector3& velocity) {
  const Real least = atoms.size / 4;
  requireFinite(position, "position");
  requireFinite(velocity, "velocity");
  for (int axis = 0; axis < 3; ++axis) {
    const Edge edge = edgeOf(box, axis);
    const Real x = position[axis];
    if (edge == Edge::Wall && !(x >= least && x <= box.size[axis] - least)) {
      reject("position", toText(position),
             "must be between the walls of the box, a quarter of the size from each");
    }
    if (edge == Edge::Flat && (x != 0 || velocity[axis] != 0)) {
      reject(x != 0 ? "position" : "velocity", toText(x != 0 ? position : velocity),
             "must be zero along an axis that is flat");
    }
  }
}

}  // namespace carom

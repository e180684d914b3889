#include "carom/motion/particle_lattice.hpp"

#include <cmath>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/random.hpp"

namespace carom {
namespace {

constexpr Real kMostParticles = 1e8;

void requireUsable(const LatticePlan& plan) {
  Real count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int sites = plan.sites[axis];
    if (sites < 1) reject("sites", std::to_string(sites), "must be at least 1");
    if (plan.edges[axis] == Edge::Flat && sites != 1) {
      reject("sites", std::to_string(sites), "must be 1 along an axis that is flat");
    }
    count *= sites;
  }
  if (count > kMostParticles) reject("number of sites", toText(count), "must be at most 1e8");
  requirePositive(plan.density, "density");
  requirePositive(plan.mass, "mass");
  requireNonNegative(plan.temperature, "temperature");
  if (count == 1 && plan.temperature != 0) {
    reject("temperature", toText(plan.temperature), "must be zero for one particle, which rests");
  }
}

// The edge of a square or cube that holds one particle. Square roots are rounded alike everywhere,
// cube roots are not; so Newton's method finds it, from above until it gets no smaller.
Real spacingOf(Real density, int dimensions) {
  const Real room = 1 / density;
  if (dimensions == 1) return room;
  if (dimensions == 2) return std::sqrt(room);
  Real edge = room > 1 ? room : 1;
  for (;;) {
    const Real next = edge - (edge - room / (edge * edge)) / 3;
    if (!(next < edge)) return edge;
    edge = next;
  }
}

}  // namespace

LatticeStart latticeStart(const LatticePlan& plan) {
  requireUsable(plan);
  LatticeStart start;
  start.box.edges = plan.edges;
  const int dimensions = dimensionsOf(start.box);
  if (dimensions == 0) reject("box", "flat along all axes", "must have room along one");
  const Real spacing = spacingOf(plan.density, dimensions);
  Vector3 first = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (plan.edges[static_cast<std::size_t>(axis)] == Edge::Flat) continue;
    start.box.size[axis] = spacing * plan.sites[static_cast<std::size_t>(axis)];
    first[axis] = spacing / 2;
  }

  Random random(plan.seed);
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < plan.sites[2]; ++k) {
    for (int j = 0; j < plan.sites[1]; ++j) {
      for (int i = 0; i < plan.sites[0]; ++i) {
        start.positions.push_back(first + spacing * Vector3(i, j, k));
        Vector3 velocity = random.vector();
        for (int axis = 0; axis < 3; ++axis) {
          if (plan.edges[static_cast<std::size_t>(axis)] == Edge::Flat) velocity[axis] = 0;
        }
        start.velocities.push_back(velocity);
        sum += velocity;
      }
    }
  }

  const auto count = static_cast<Real>(start.positions.size());
  Real squares = 0;
  for (Vector3& velocity : start.velocities) {
    velocity -= sum / count;
    squares += velocity.squaredNorm();
  }
  const Real wanted = plan.temperature / plan.mass * dimensions * count;
  const Real factor = wanted == 0 ? 0 : std::sqrt(wanted / squares);
  for (Vector3& velocity : start.velocities) velocity *= factor;
  return start;
}

}  // namespace carom

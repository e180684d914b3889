#include "carom/motion/particles.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "carom/core/checks.hpp"

namespace carom {
namespace {

constexpr std::size_t kMostParticles = 100'000'000;
constexpr std::size_t kLanes = 64;    // pairs that are worked through together
constexpr Real kLeastDistance = 0.5;  // of two particles at the start, in units of their size

const ParticleRules& checked(const ParticleRules& rules) {
  requirePositive(rules.atoms.depth, "depth");
  requirePositive(rules.atoms.size, "size");
  requirePositive(rules.atoms.cutoff, "cutoff");
  requirePositive(rules.mass, "mass");
  requireNonNegative(rules.skin, "skin");
  if (!(rules.skin <= rules.atoms.cutoff)) {
    reject("skin", toText(rules.skin),
           "must be no more than the cut-off, " + toText(rules.atoms.cutoff));
  }
  requireUsable(rules.box, rules.atoms);
  return rules;
}

std::size_t checkedCount(std::span<const Vector3> positions, std::span<const Vector3> velocities) {
  if (positions.size() != velocities.size()) {
    reject("number of velocities", std::to_string(velocities.size()),
           "must be that of the positions, " + std::to_string(positions.size()));
  }
  if (positions.empty() || positions.size() > kMostParticles) {
    reject("number of particles", std::to_string(positions.size()),
           "must be 1 to " + std::to_string(kMostParticles));
  }
  return positions.size();
}

}  // namespace

Particles::Particles(std::span<const Vector3> positions, std::span<const Vector3> velocities,
                     const ParticleRules& rules)
    : rules_(checked(rules)),
      cells_(rules.box, listReach(), checkedCount(positions, velocities)),
      positions_(positions.begin(), positions.end()),
      velocities_(velocities.begin(), velocities.end()),
      forces_(positions.size(), Vector3::Zero()),
      listedAt_(positions.size()),
      spare_(positions.size()),
      slots_(positions.size()),
      ids_(positions.size()),
      spareIds_(positions.size()) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    requireInside(rules_.box, rules_.atoms, positions[i], velocities[i]);
    ids_[i] = static_cast<std::int32_t>(i);
  }
  bringInside();
  makeList();

  const Real least = kLeastDistance * rules_.atoms.size;
  for (const NeighborList::Row& row : list_.rows()) {
    const Vector3 from =
        positions_[static_cast<std::size_t>(row.particle)] - imageShift(rules_.box, row.image);
    for (const std::int32_t j : list_.partners(row)) {
      const Real distance = (positions_[static_cast<std::size_t>(j)] - from).norm();
      if (distance < least) {
        reject("distance of two particles", toText(distance),
               "must be at least half their size, " + toText(least));
      }
    }
  }
  updateForces();
}

//! [steps]
ParticleStatus Particles::velocityVerletStep(Real dt) {
  requireFinite(dt, "dt");
  kick(dt / 2);
  if (!drift(dt)) return ParticleStatus::Exploded;
  updateForces();
  kick(dt / 2);
  return ParticleStatus::Moved;
}

ParticleStatus Particles::semiImplicitEulerStep(Real dt) {
  requireFinite(dt, "dt");
  kick(dt);
  if (!drift(dt)) return ParticleStatus::Exploded;
  updateForces();
  return ParticleStatus::Moved;
}

ParticleStatus Particles::explicitEulerStep(Real dt) {
  requireFinite(dt, "dt");
  if (!drift(dt)) return ParticleStatus::Exploded;
  kick(dt);
  updateForces();
  return ParticleStatus::Moved;
}
//! [steps]

void Particles::kick(Real dt) {
  if (exploded_) return;
  const Real factor = dt / rules_.mass;
  for (std::size_t i = 0; i < count(); ++i) velocities_[i] += factor * forces_[i];
}

// Moves all, unless one of them goes too far. So no position ever is anything but a number in or
// near the box, and whoever crosses a wall crosses only one.
bool Particles::drift(Real dt) {
  const Real furthest = rules_.atoms.cutoff * rules_.atoms.size;
  bool sound = !exploded_;
  for (const Vector3& v : velocities_) {
    sound = sound & (dt * dt * v.squaredNorm() <= furthest * furthest);  // false for NaN
  }
  exploded_ = !sound;
  if (exploded_) return false;

  for (std::size_t i = 0; i < count(); ++i) positions_[i] += dt * velocities_[i];
  // No image holds back who comes much too fast: the mirror itself does.
  for (int axis = 0; axis < 3; ++axis) {
    if (rules_.box.edges[static_cast<std::size_t>(axis)] != Edge::Wall) continue;
    const Real far = rules_.box.size[axis];
    for (std::size_t i = 0; i < count(); ++i) {
      Real& x = positions_[i][axis];
      if (x >= 0 && x <= far) continue;
      x = x < 0 ? -x : 2 * far - x;
      velocities_[i][axis] = -velocities_[i][axis];
    }
  }

  Real moved = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    moved = std::max(moved, (positions_[i] - listedAt_[i]).squaredNorm());
  }
  const Real half = rules_.skin * rules_.atoms.size / 2;
  listIsOld_ = moved >= half * half;
  return true;
}

// Whole boxes off, so that the particle is in the box; the far edge belongs to it.
void Particles::bringInside() {
  for (int axis = 0; axis < 3; ++axis) {
    if (rules_.box.edges[static_cast<std::size_t>(axis)] != Edge::Periodic) continue;
    const Real size = rules_.box.size[axis];
    for (Vector3& position : positions_) {
      Real& x = position[axis];
      if (x < 0 || x > size) x = std::clamp(x - size * std::floor(x / size), Real(0), size);
    }
  }
}

// All particles into the order of the cells, then their pairs.
void Particles::makeList() {
  const std::span<const std::int32_t> order = cells_.sort(positions_);
  const auto reorder = [&](auto& values, auto& spare) {
    for (std::size_t k = 0; k < order.size(); ++k) {
      spare[k] = values[static_cast<std::size_t>(order[k])];
    }
    std::swap(values, spare);
  };
  reorder(positions_, spare_);
  reorder(velocities_, spare_);
  reorder(ids_, spareIds_);
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    slots_[static_cast<std::size_t>(ids_[k])] = static_cast<std::int32_t>(k);
  }
  listedAt_ = positions_;
  list_.collect(cells_, rules_.box, positions_, listReach());
  listIsOld_ = false;
  ++listsMade_;
}

void Particles::updateForces() {
  if (listIsOld_) {
    bringInside();
    makeList();
  }
  std::fill(forces_.begin(), forces_.end(), Vector3::Zero());
  potential_ = virial_ = 0;
  for (const NeighborList::Row& row : list_.rows()) {
    const Vector3 from =
        positions_[static_cast<std::size_t>(row.particle)] - imageShift(rules_.box, row.image);
    const std::span<const std::int32_t> partners = list_.partners(row);
    for (std::size_t done = 0; done < partners.size(); done += kLanes) {
      addPairs(row.particle, from,
               partners.subspan(done, std::min(kLanes, partners.size() - done)));
    }
  }
  addWalls();
}

void Particles::addWalls() {
  for (int axis = 0; axis < 3; ++axis) {
    if (rules_.box.edges[static_cast<std::size_t>(axis)] != Edge::Wall) continue;
    for (std::size_t i = 0; i < count(); ++i) {
      const Real x = positions_[i][axis], rest = rules_.box.size[axis] - x;
      // Farther than that, and even than 0.56 sizes, there is no force.
      if (x >= rules_.atoms.size && rest >= rules_.atoms.size) continue;
      const PairForce near = wallForce(rules_.atoms, x), far = wallForce(rules_.atoms, rest);
      forces_[i][axis] += 2 * x * near.factor - 2 * rest * far.factor;
      potential_ += near.energy + far.energy;
    }
  }
}

// In three passes: who is near, what that does, and to whom. A branch on the distance would be
// guessed wrong for every third pair; so every pair is written down, and the next one over it if it
// is too far. The pass in the middle has no branch and no index, so the compiler makes lanes of it.
void Particles::addPairs(std::int32_t particle, const Vector3& from,
                         std::span<const std::int32_t> partners) {
  const LennardJones atoms = rules_.atoms;
  const Real reach = atoms.cutoff * atoms.size, reachSquared = reach * reach;
  Real x[kLanes], y[kLanes], z[kLanes], squared[kLanes], energy[kLanes], virial[kLanes];
  std::int32_t partner[kLanes];

  std::size_t near = 0;
  for (const std::int32_t j : partners) {
    const Vector3 d = positions_[static_cast<std::size_t>(j)] - from;
    x[near] = d.x(), y[near] = d.y(), z[near] = d.z();
    squared[near] = d.squaredNorm();
    partner[near] = j;
    near += d.squaredNorm() < reachSquared;
  }

  // pairForce() with one division and without the question whether they are near.
  const Real size6 = atoms.size * atoms.size * atoms.size * atoms.size * atoms.size * atoms.size;
  const Real lift = 4 * atoms.depth;
  const Real cut6 = size6 / (reachSquared * reachSquared * reachSquared);
  const Real atCut = lift * (cut6 * cut6 - cut6);
  for (std::size_t k = 0; k < near; ++k) {
    const Real inverse = 1 / squared[k];
    const Real s6 = size6 * (inverse * inverse * inverse);
    const Real work = 6 * lift * (2 * s6 * s6 - s6);  // force times distance
    energy[k] = lift * (s6 * s6 - s6) - atCut;
    virial[k] = work;
    const Real factor = work * inverse;
    x[k] *= factor, y[k] *= factor, z[k] *= factor;
  }

  // Sums of this row stay in registers; members would be written for every pair.
  Vector3 own = Vector3::Zero();
  Real energySum = 0, virialSum = 0;
  for (std::size_t k = 0; k < near; ++k) {
    const Vector3 force(x[k], y[k], z[k]);
    own -= force;
    forces_[static_cast<std::size_t>(partner[k])] += force;
    energySum += energy[k];
    virialSum += virial[k];
  }
  potential_ += energySum;
  virial_ += virialSum;
  forces_[static_cast<std::size_t>(particle)] += own;
}

void Particles::reverse() {
  for (Vector3& velocity : velocities_) velocity = -velocity;
}

ParticleTotals Particles::totals() const {
  ParticleTotals totals;
  Real squares = 0;
  for (const Vector3& velocity : velocities_) {
    squares += velocity.squaredNorm();
    totals.momentum += rules_.mass * velocity;
  }
  const auto dimensions = static_cast<Real>(dimensionsOf(rules_.box));
  totals.kinetic = rules_.mass * squares / 2;
  totals.potential = potential_;
  totals.temperature = rules_.mass * squares / (dimensions * static_cast<Real>(count()));
  totals.pressure = (rules_.mass * squares + virial_) / (dimensions * volumeOf(rules_.box));
  return totals;
}

}  // namespace carom

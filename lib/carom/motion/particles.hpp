#pragma once
// How do ten thousand particles move?
//
// Method: velocity Verlet in place. Each step kicks the velocities by half of what the forces do,
// drifts the positions, asks for the forces at the new places, and kicks by the other half: one
// evaluation of the forces a step. They come from a list of near pairs, which is made anew, from
// cells, when somebody has moved by half the skin. The particles are then sorted into the order of
// the cells, so that partners are near each other in memory as well.
// The same three parts in other orders are explicit and semi-implicit Euler; they are here to be
// seen beside it.
// Why in place: no step takes memory, once the lists are as long as they get. Every sum is made in
// an order that depends on nothing but the motion, so the same crowd gives the same bits each time.
// At the cut-off the force jumps, by 0.039 e/s at 2.5 s. Each pair that crosses it gains or loses an
// energy of order dt, half of them this way and half that. So the energy of 400 particles wanders by
// 0.001 e each in 100 000 steps of 0.005; that of more particles by less.
// Source: Swope, Andersen, Berens and Wilson, Journal of Chemical Physics 76, 1982 (the step);
// Verlet, Physical Review 159, 1967 (the list); section 9 of the source text (Euler that explodes).
// Not handled: particles of several kinds, bonds, thermostats, several cores.

#include "carom/motion/neighbor_list.hpp"

namespace carom {

/// What holds for all particles of a crowd. \ingroup motion
struct ParticleRules {
  LennardJones atoms = {};  ///< how they push and pull each other
  Real mass = 1;            ///< of each, positive [kg]
  ParticleBox box = {};     ///< where they are
  /// How much further than the cut-off the list of pairs reaches, in units of the size: more pairs,
  /// but a list that lasts longer. 0 makes it anew in every step; at most the cut-off. Measured
  /// (./course bench --suite particles): 0.3 to 0.7 are nearly as good as the best [1]
  Real skin = 0.5;
};

/// How a step has gone. \ingroup motion
enum class ParticleStatus {
  Moved,     ///< as it should
  Exploded,  ///< a velocity is not finite, or would carry its particle past the whole reach of the
             ///< force in one step: the step is far too long. No position has been changed, and
             ///< none will be any more
};

/// What can be said of a crowd as a whole. \ingroup motion
struct ParticleTotals {
  Real kinetic = 0;                    ///< energy of motion [J]
  Real potential = 0;                  ///< energy of all pairs, and of the walls [J]
  Vector3 momentum = Vector3::Zero();  ///< [kg m/s, world]
  Real temperature = 0;                ///< twice the kinetic energy per particle and dimension [J]
  Real pressure = 0;  ///< of motion and of forces between particles (virial) [N/m^(d-1)]

  /// What must not change. \return kinetic and potential energy together [J]
  Real energy() const {
    return kinetic + potential;
  }
};

/// Many equal particles in a box. \ingroup motion
class Particles {
 public:
  /// Puts particles into a box.
  /// \param positions n points; along a periodic axis they are brought into the box [m, world]
  /// \param velocities n of them [m/s, world]
  /// \param rules for all of them
  /// \throws InvalidInput if counts differ, there are no particles or more than a hundred million, a
  /// number is not finite, the mass, depth, size or cut-off not positive, the skin negative or more
  /// than the cut-off, the box too small (requireUsable()), a particle behind a wall or off the
  /// plane (requireInside()), or two are nearer than half their size, where their energy is 16 000
  /// times the depth
  Particles(std::span<const Vector3> positions, std::span<const Vector3> velocities,
            const ParticleRules& rules);

  /// One step of velocity Verlet: order 2, reversible, the energy stays near what it was.
  /// \param dt length of the step; negative runs backwards [s]
  /// \return whether it could be made
  /// \throws InvalidInput if dt is not finite
  ParticleStatus velocityVerletStep(Real dt);

  /// One step of semi-implicit Euler: order 1, but the energy does not run away.
  /// \param dt length of the step; negative runs backwards [s]
  /// \return whether it could be made
  /// \throws InvalidInput if dt is not finite
  ParticleStatus semiImplicitEulerStep(Real dt);

  /// One step of explicit Euler: order 1, and the energy grows until all flies apart.
  /// \param dt length of the step; negative runs backwards [s]
  /// \return whether it could be made
  /// \throws InvalidInput if dt is not finite
  ParticleStatus explicitEulerStep(Real dt);

  /// Turns all velocities round: the same motion backwards.
  void reverse();

  /// How many there are. \return their number
  std::size_t count() const {
    return positions_.size();
  }

  /// Where a particle is. Along a periodic axis it may be a little outside of the box, as it is
  /// brought back only when the list is made anew.
  /// \param particle in the order in which they were given \return [m, world]
  const Vector3& position(std::size_t particle) const {
    return positions_[slot(particle)];
  }

  /// How it moves. \param particle as for position() \return [m/s, world]
  const Vector3& velocity(std::size_t particle) const {
    return velocities_[slot(particle)];
  }

  /// What pushes it. \param particle as for position() \return [N, world]
  const Vector3& force(std::size_t particle) const {
    return forces_[slot(particle)];
  }

  /// Energies, momentum, temperature and pressure now. \return sums over all particles
  ParticleTotals totals() const;

  /// How often the list of pairs has been made. \return at least 1
  std::size_t listsMade() const {
    return listsMade_;
  }

  /// The pairs that are looked at in a step now. \return their number
  std::size_t pairsListed() const {
    return list_.pairs();
  }

 private:
  std::size_t slot(std::size_t particle) const {
    return static_cast<std::size_t>(slots_[particle]);
  }
  Real listReach() const {
    return (rules_.atoms.cutoff + rules_.skin) * rules_.atoms.size;
  }
  void kick(Real dt);
  bool drift(Real dt);
  void bringInside();
  void makeList();
  void updateForces();
  void addWalls();
  void addPairs(std::int32_t particle, const Vector3& from, std::span<const std::int32_t> partners);

  ParticleRules rules_;
  CellGrid cells_;
  NeighborList list_;
  // In the order of the cells, as they were when the list was made.
  std::vector<Vector3> positions_, velocities_, forces_, listedAt_, spare_;
  std::vector<std::int32_t> slots_, ids_, spareIds_;  // where a particle is, and who is there
  Real potential_ = 0, virial_ = 0;
  std::size_t listsMade_ = 0;
  bool listIsOld_ = false, exploded_ = false;
};

}  // namespace carom

#pragma once
// How are the contacts of a tower solved where sweeps gain little?
//
// Method: all contacts of an island at once. Each row is given a very stiff spring about the
// impulse that it has now: its new impulse is the old one less stiffness times speed, cut off where
// it would pull and where friction would leave its cone. With these springs velocities are the only
// unknowns, six per body, and Newton's method finds them: each round solves one sparse linear
// system over the bodies (body_matrix.hpp), in which rows that are cut off have no spring and
// friction at its limit turns and grows with the pressure. Then the impulses found become the old
// ones, and it begins again: at the end no spring is stretched any more, so that how stiff they
// were has no part in the answer. As long as the same rows carry, the factors serve again, and a
// repetition costs what a sweep costs.
// Why: a sweep carries a load one body further, and trades it between a heavy and a light one in
// parts of their ratio. A factorisation carries it to the ground at once, whatever the masses are.
// Redundant points need no care: their springs share.
// Where nothing slips yet it is first asked what happens if nothing can: friction without a limit is
// a problem with one answer, which is found in a few rounds, and begun from no impulses at all its
// forces are the evenest that hold the load, whatever order the rows are in. If all of them are
// within their cones it is the answer with the limits, too; what is not is let go, and it is asked
// again. Near a limit, or with strong friction, the other way may wander for long: an arch or a
// house of cards is hardly found by it.
// The law is that of the sweeps (friction_law.hpp), and so are the fixed points: friction is
// against the slip and does not lift (no convex approximation of the cone).
// Source: augmented Lagrangian with Newton's method for friction, Alart and Curnier 1991; proximal
// points, Rockafellar 1976; sparse systems over bodies, Castro and others 2022 (SAP), whose cone is
// the associated one; subspaces from sweeps, Silcowitz, Niebe and Erleben 2010.
// Friction as Coulomb said has solutions that make energy (Painlevé 1895, Kane 1984); sweeps hardly
// come to them, Newton's method may. Such a solution is none.
// Not handled: that it converges is proved without friction only; with it the caller must look.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/solver/body_matrix.hpp"
#include "carom/solver/friction_law.hpp"

namespace carom {

/// How far a direct solution may go. \ingroup solver
struct NewtonLimits {
  std::int64_t work = 20'000;  ///< products of blocks of six by six, in all factorisations
  int rounds = 100;            ///< solutions of a linear system; positive
  Real speed = 1;              ///< what is fast in this scene, at least [m/s]
};

/// What a direct solution came to. \ingroup solver
struct NewtonResult {
  bool solved = false;     ///< only rounding is left
  int factorisations = 0;  ///< matrices taken apart
  int rounds = 0;          ///< linear systems solved
  std::int64_t work = 0;   ///< what all that cost, about, in visits of a row by a sweep
  Real error = 0;          ///< largest change of speed that a row still asks for [m/s]
};

/// How much the rows of an island still ask for. \ingroup solver
struct IslandError {
  Real speed = 0;      ///< largest change of speed [m/s]
  bool small = false;  ///< nothing is more than rounding of what the bodies carry
};

/// Solves islands directly; keeps its memory from one to the next. \ingroup solver
class IslandNewton {
 public:
  /// Takes memory. \param bodies the most in an island, those that nothing moves included
  /// \param blocks the most in an island
  void reserve(int bodies, int blocks);

  /// Looks whether the impulses that the blocks hold are the solution; changes nothing.
  /// \param bodies as they move with these impulses \param blocks prepared
  /// \param speed what is fast in this scene, at least [m/s] \return what is missing
  IslandError errorOf(std::span<const MovingBody> bodies, std::span<const ContactBlock> blocks,
                      Real speed);

  /// Makes velocities zero if all of them are only rounding of what the bodies carry, so that what
  /// rests rests to the last bit. \param bodies as errorOf() has just seen them
  void dropRounding(std::span<MovingBody> bodies) const;

  /// Solves. \param bodies their velocities are changed; the impulses that the blocks hold have
  /// been applied \param blocks their impulses are changed; if it is not solved, both are as they
  /// were \param limits how far to go \return what it came to
  NewtonResult solve(std::span<MovingBody> bodies, std::span<ContactBlock> blocks,
                     const NewtonLimits& limits);

 private:
  // What a block's friction does.
  enum class Rub : std::uint8_t { none, sticks, slips, given };
  // A block while it is solved. Rows 0 to 3 are along the normal, 4 to 6 those of friction.
  struct Work {
    int nodeA = -1, nodeB = -1;  // unknowns of its bodies; negative: cannot be moved
    int link = -1;               // between them
    FrictionLaw law;
    std::array<Real, 4> stiff = {};    // of the springs along the normal [kg]
    Real stiffRub = 0;                 // of those of friction [kg]
    std::array<Real, 7> speeds = {};   // of the rows now [m/s]
    std::array<Real, 7> along = {};    // their change in the direction that is searched [m/s]
    std::array<Real, 4> presses = {};  // impulses at these speeds [N s]
    Vector3 rub = Vector3::Zero();     // the same of friction [N s]
    std::uint8_t carries = 0;          // bits of the points that press
    Rub mode = Rub::none;
    bool loose = false;                 // does not rub where all else is glued
    Vector3 heading = Vector3::Zero();  // of friction at its limit [1]
    Real share = 0;                     // of the springs' force that the cone lets through [1]
    std::uint8_t factoredCarries = 0;   // what the factors were made for
    Rub factoredMode = Rub::none;
  };

  struct Kept {
    std::array<Real, 4> impulses = {};
    Vector3 rub = Vector3::Zero();
  };

  bool prepare(std::span<const MovingBody> bodies, std::span<const ContactBlock> blocks);
  void readSpeeds(std::span<const MovingBody> bodies, std::span<const ContactBlock> blocks);
  void evaluate(const ContactBlock& block, Real t, Work& work) const;
  static void unbalance(const ContactBlock& block, const Work& work, std::span<BodyVector> force);
  bool factor(std::span<const ContactBlock> blocks);
  void addBlock(const ContactBlock& block, const Work& work);
  Real slope(std::span<const ContactBlock> blocks, Real t);
  Real searchLine(std::span<const ContactBlock> blocks, Real start);
  void accept(std::span<MovingBody> bodies, std::span<ContactBlock> blocks);
  Real energyOf(std::span<const MovingBody> bodies) const;
  bool loosen(std::span<const ContactBlock> blocks);
  void begin(std::span<MovingBody> bodies, std::span<ContactBlock> blocks, bool cold);
  bool iterate(std::span<MovingBody> bodies, std::span<ContactBlock> blocks,
               const NewtonLimits& limits, NewtonResult& result);

  BodyMatrix matrix_;
  std::vector<Work> work_;
  std::vector<int> nodes_;            // of each body
  std::vector<BodyLink> links_;       // of blocks between two that move
  std::vector<BodyBlock> masses_;     // of each node
  std::vector<BodyVector> velocity_;  // change since the impulses that the blocks hold
  std::vector<BodyVector> step_;      // direction of the search
  std::vector<Real> loads_;           // of each body [m/s]
  std::vector<Kept> kept_;            // impulses as they were
  std::vector<MovingBody> free_;      // bodies without impulses
  std::vector<Velocity> keptVelocity_;
  std::int64_t looks_ = 0;  // at all blocks, of a solution
  bool symmetric_ = true;
  bool coupled_ = true;  // the limit of friction follows the pressure within a round
  bool glued_ = false;   // friction has no limit, nor needs pressure
  bool hasFactors_ = false;
};

}  // namespace carom

#pragma once
// Which ideas does a world use?
//
// Each one is a switch, so that a chapter can show what happens without it, and what it costs. The
// defaults are what the project recommends.

#include "carom/core/real.hpp"
#include "carom/impulse/combine_restitution.hpp"
#include "carom/solver/row_width.hpp"

namespace carom::world {

/// How the pairs of shapes that may meet are found. \ingroup world
enum class PairFinding {
  tree,     ///< trees of boxes; what never moves is in one of its own
  allPairs  ///< every shape against every other
};

/// The switches and limits of a world. \ingroup world
struct WorldSettings {
  Vector3 gravity = Vector3(0, 0, -9.81);  ///< [m/s^2, world]

  PairFinding pairFinding = PairFinding::tree;  ///< how pairs are found
  bool warmStarting = true;                     ///< begin with the impulses of the last step
  bool sleeping = true;                         ///< let islands sleep that have come to rest
  bool keepStill = true;      ///< do not step an island in which the last step changed nothing
  bool continuous = true;     ///< look for first contacts inside the step
  bool locateEvents = true;   ///< find impacts and ends of slipping inside the step and go on there
  bool divideCrowds = true;   ///< go a long step in parts where a crowd flies about
  bool exactRotation = true;  ///< free rotation in closed form where the inertia needs it
  bool gyroscopic = true;     ///< the gyroscopic term at all; false: bodies turn as balls do
  bool trapezoidal = true;    ///< move by the mean of the velocities at both ends of the step
  bool projectPositions = true;  ///< take overlap away by moving bodies, not by speed
  bool friction = true;          ///< rows for friction where a coefficient is not zero
  bool restitution = true;       ///< bounces where a coefficient is not zero

  bool directIslands = true;  ///< solve islands directly where sweeps gain little

  int iterations = 10;      ///< sweeps over the rows of an island, at least; positive
  int rowBudget = 100'000;  ///< sweeps go on until nothing changes or so many rows were visited
  int eventContacts = 64;   ///< islands with more closed contacts than this take no events
  int pileContacts = 256;   ///< islands with more closed contacts than this are piles: soft steps
  /// So are islands of more bodies that do not bounce. With both zero islands go by soft steps as
  /// soon as they touch: at an even cost, and to a millimetre.
  int pileBodies = 300;
  /// An island of eight bodies and more whose step took more than so many times what it would take
  /// as a pile is one for the next `pileSteps` steps, as long as something in it rubs and nothing
  /// bounces: balls if it has more closed contacts than `eventContacts` or most are faster than a
  /// step of free fall makes them; others if it has so many and a tenth of them moves; positive.
  /// Where more than 128 bodies are awake no island is too small: balls are a pile then however
  /// fast they are, others if a tenth of them moves; and piles of eight balls and more stay piles
  /// while most are faster than a step of free fall makes them. What is left of the step that took
  /// too much is taken at once.
  int pileWork = 10;
  int pileSteps = 60;  ///< for which an island stays a pile that took too much; zero or more
  int shortSteps = 8;  ///< of a pile in a step; positive
  int threads = 1;     ///< who work on piles; the result is the same for any number; positive
  RowWidth rowWidth = RowWidth::widest;  ///< lanes of piles; the result is the same for each
  int directWork = 20'000;  ///< blocks multiplied at most to solve an island directly, zero or more
  int eventsPerBody =
      200;  ///< in one step; after that impacts are plastic, and then not looked for
  bool extrapolation = true;    ///< advance: combine tries of different steps into a better one
  Real shortestSubStep = 1e-5;  ///< advance: islands are stepped no finer; positive [s]
  int maxBodies = 1'000'000;    ///< more are refused
  RestitutionRule restitutionRule = RestitutionRule::maximum;  ///< how two bounces become one

  /// A body that touches and turns by more than this in a step takes it in several phases, sixteen at
  /// most, each with the forces of its own moment: a box that tips over its edge falls right to a
  /// millionth of a second. Larger than any turn: one phase; positive [rad].
  Real phaseTurn = 1e-5;
  Real contactMargin = 0.01;   ///< surfaces nearer than this are watched; positive [m]
  Real touchTolerance = 1e-8;  ///< gap at which approaching points have met; positive [m]
  Real restTolerance = 1e-6;   ///< gap up to which a contact that carried stays closed [m]
  Real shortestBounce = 1e-4;  ///< bounces that end within this part of a step are not made [1]

  Real sleepTime = 0.5;       ///< how long an island has to be at rest; positive [s]
  Real sleepSpeed = 0.05;     ///< no point of a body that falls asleep is faster; positive [m/s]
  Real sleepDistance = 1e-3;  ///< nor goes further within the sleep time; positive [m]
};

/// Refuses settings that no world can work with. \param settings any settings
/// \throws InvalidInput naming the value and the rule
/// \ingroup world
void requireUsable(const WorldSettings& settings);

}  // namespace carom::world

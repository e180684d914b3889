#pragma once
// Does the world stay sound, whatever it is given?
//
// Method: scenes made at random from a seed, and a few built to be hard. Each one is run and
// watched from outside: every number finite, nobody outside of the walls, no energy from nothing,
// no step without an end. What is found names the seed, so that one scene can be run again.
// Bounds on energy, beside that of the scene: its motion, and the height of the room. It is never more
// than at the start by a share of 1e-6. What a step may add to what those before it have left is the
// error of one step, 1e-3 at most: a phase of contact is right to the second order, and bodies here
// turn by up to some radians in a step. Where a switch takes an idea away the step falls short by its
// own first order: a body of speed v is up to v dt deep in a wall when that is noticed, and lifting it
// out costs m g v dt. That is allowed once per body and step. So does a pile, whose contacts nobody
// follows: in a step it may lift bodies as fast as soft steps take overlap away. That it has lost
// when they sank, and in all nothing is allowed for it. Bodies that overlap at the start may be lifted
// by the height of the room, and those that lie in a hill then by that of hills, and gain no speed
// from it.
// Bounds on places: the middle of a body is never behind a wall. Who looks at the ends of steps only
// may be there by the way that the fastest goes in a step, and by what of that is left at the rate at
// which overlap is taken away, if it is.
// Bounds on steps: nobody falls by more than an eighth of his size in the first one.
// Not handled: whether the motion is right (that is what all other tests ask).

#include <cstdint>
#include <string>
#include <vector>

#include "carom/core/real.hpp"

namespace carom::stress {

/// What was tried, and the worst of it.
struct Tally {
  long scenes = 0;      ///< that were run
  long bodies = 0;      ///< in them, walls not counted
  long steps = 0;       ///< of all
  long contacts = 0;    ///< points of manifolds, over all steps
  long impacts = 0;     ///< resolved at their time
  long searches = 0;    ///< for a first contact
  long refused = 0;     ///< bad calls, each refused
  Real gain = 0;        ///< greatest growth of energy since the start beside that of the scene [1]
  Real gainOfStep = 0;  ///< the same in one step [1]
  Real depth = 0;       ///< deepest overlap beside the size of the bodies [1]

  /// Takes in what another tried. \param other of it
  void add(const Tally& other);
};

/// How a trial ended.
struct Outcome {
  Tally tally;           ///< what was done
  std::string failure;   ///< what went wrong; empty: nothing
  bool isPlain = false;  ///< of a random scene: solids for walls, and no idea of the step left out
};

/// A scene made from a seed: two to twelve bodies of any shape in a room, ten to sixty steps.
/// \param seed names the scene
/// \return what was found; the run ends with the first fault
Outcome runRandomScene(std::uint64_t seed);

/// What a random scene is, in a line. \param seed names the scene
std::string describeRandomScene(std::uint64_t seed);

/// A scene that was built to be hard.
struct Trial {
  std::string name;               ///< for the command line
  std::string asks;               ///< what it asks, in a line
  Outcome (*run)(Real duration);  ///< runs it for so long, as a share of the full length [1]
};

/// All of them.
const std::vector<Trial>& trials();

/// Calls that must be refused, each with its value named and nothing changed.
Outcome refuseAll();

}  // namespace carom::stress

#pragma once
// What has a step done, and what has it left out?
//
// Numbers of things, counted where the work is done. They are the same on every machine, so that
// tests can ask whether a scene of balls ever built a separating axis. Times are not the world's
// business.

#include <cstdint>

#include "carom/core/real.hpp"

namespace carom::world {

/// What the last step did. \ingroup world
struct Counters {
  std::int64_t parts = 0;             ///< parts that it was gone in, because a crowd flies about
  std::int64_t bodiesAwake = 0;       ///< bodies that were stepped
  std::int64_t bodiesAsleep = 0;      ///< bodies that were skipped
  std::int64_t bodiesFree = 0;        ///< of those awake: in free flight, nothing near
  std::int64_t islandsAwake = 0;      ///< islands that were stepped
  std::int64_t islandsAsleep = 0;     ///< islands that were skipped
  std::int64_t islandsStill = 0;      ///< awake, but nothing can change in them: not stepped
  std::int64_t pairsTested = 0;       ///< boxes compared to find pairs
  std::int64_t pairsBegun = 0;        ///< pairs that came near
  std::int64_t pairsEnded = 0;        ///< pairs that went apart
  std::int64_t pairsAwake = 0;        ///< pairs that were looked at
  std::int64_t pairsKept = 0;         ///< of those awake: nothing has changed, nothing was made
  std::int64_t pairsAsleep = 0;       ///< pairs that were skipped
  std::int64_t manifoldsMade = 0;     ///< manifolds computed
  std::int64_t manifoldsCarried = 0;  ///< of piles: carried along, or of features as they were
  std::int64_t axesSearches = 0;      ///< of those: by separating axes (boxes and hulls)
  std::int64_t contactPoints = 0;     ///< points of the manifolds
  std::int64_t normalRows = 0;        ///< rows of contact set up
  std::int64_t frictionRows = 0;      ///< rows of friction set up
  std::int64_t rowsSolved = 0;        ///< rows times sweeps
  std::int64_t pileBodies = 0;        ///< bodies of islands that took soft steps
  std::int64_t pileContacts = 0;      ///< contacts of these
  std::int64_t pileColors = 0;        ///< colours of the contacts, of the pile that has most
  std::int64_t islandsTooDear = 0;    ///< islands that took so much that they are piles from now on
  std::int64_t islandsDirect = 0;     ///< sets of contacts that were solved directly
  std::int64_t islandsGivenUp = 0;    ///< of which that found nothing
  std::int64_t factorisations = 0;    ///< matrices taken apart for that
  std::int64_t directWork = 0;        ///< what these cost, about, in visits of a row
  std::int64_t firstContacts = 0;     ///< searches for a first contact
  std::int64_t impacts = 0;           ///< impacts resolved at their time
  std::int64_t slipChanges = 0;       ///< ends of slipping located
  std::int64_t exactRotations = 0;    ///< bodies turned by the closed form
  std::int64_t splitRotations = 0;    ///< bodies turned by splitting: a torque acts, or by a switch
  std::int64_t projections = 0;       ///< pairs whose overlap was taken away
  std::int64_t energiesKept = 0;      ///< islands to which a step would have given energy
  std::int64_t islandsSplit = 0;      ///< islands looked through because a contact had ended
  std::int64_t islandsWoken = 0;      ///< islands that woke
  std::int64_t islandsPutToSleep = 0;  ///< islands that fell asleep
  std::int64_t macroSteps = 0;         ///< searches for pairs while the world advances
  std::int64_t subSteps = 0;           ///< steps of islands while the world advances, all tries
  std::int64_t triesRefused = 0;       ///< tries of islands taken back: too wrong
  std::int64_t macroStepsCut = 0;      ///< long steps taken back: a body left its box
  std::int64_t triesForced = 0;        ///< tries that were too wrong and too short to cut
};

/// What the last query looked at. \ingroup world
struct QueryCounters {
  std::int64_t shapesUpdated = 0;  ///< shapes whose places the tree had to be told
  std::int64_t nodesVisited = 0;   ///< nodes of the tree
  std::int64_t shapesTested = 0;   ///< shapes whose own geometry was asked
};

}  // namespace carom::world

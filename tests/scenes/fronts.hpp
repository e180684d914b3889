#pragma once
// Which of two engines gets to an error for less?
//
// A run of an engine is a point: what it cost, and how wrong it was. Of an engine's points those
// count that no other of them beats in both; in the order of their cost they are its front, along
// which the error falls. Engines are compared at one error at a time, by these rules:
//
// 1. Between two neighbouring points of its front an engine gets to an error for the cost on the
//    straight line through both, cost and error being logarithmic.
// 2. There is no line beyond the ends. An error larger than that of the cheapest point costs what
//    that point costs: who is more exact than he has to be gets nothing for it. An error smaller
//    than that of the last point is not reached, and has no cost.
// 3. The comparison is made at the errors that the others reach: at each point of each of their
//    fronts. There the cheapest of the others is taken, wherever on its front it is.
// 4. Where ours does not get to an error, that is said, and ours is behind there: nothing is
//    compared at an error that one of both did not reach.
// 5. What rounding makes of an answer is not compared: errors below a bound that belongs to the
//    scene count as the bound.
//
// Why not fit a line through all points: fronts bend, and end.
// Not handled: errors of chance. A run that is right by accident stays on the front.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "carom/core/real.hpp"

namespace carom::scenes {

/// A run: what it cost, and how wrong it was.
struct CostAndError {
  Real cost = 0;   ///< positive [any unit]
  Real error = 0;  ///< not negative [any unit]
};

/// The points that no other beats, cheapest first, so that errors fall.
using Front = std::vector<CostAndError>;

/// The front of some runs. \param runs in any order \param rounding errors below count as this,
/// positive \return its points
Front frontOf(std::vector<CostAndError> runs, Real rounding);

/// What it costs to get to an error (rules 1 and 2). \param front of an engine
/// \param error positive \return nothing if the front does not get there
std::optional<Real> costAt(const Front& front, Real error);

/// An engine with its front.
struct NamedFront {
  std::string name;  ///< of the engine
  Front front;       ///< may be empty: it failed everywhere
};

/// The cheapest of some engines at an error.
struct Cheapest {
  std::string name;  ///< of the engine
  Real cost = 0;     ///< [unit of the fronts]
};

/// Who gets to an error for the least cost? \param fronts of the engines \param error positive
/// \return nothing if none gets there
std::optional<Cheapest> cheapestAt(std::span<const NamedFront> fronts, Real error);

/// Ours beside the others, at one error.
struct Comparison {
  Real error = 0;                ///< that one of the others reached
  Cheapest theirs;               ///< the cheapest of the others
  std::optional<Cheapest> ours;  ///< the cheapest of ours; nothing: it did not get there
  /// How many times dearer they are; zero if ours did not get there.
  Real ratio() const {
    return ours ? theirs.cost / ours->cost : 0;
  }
};

/// Ours beside the others (rules 3 and 4). \param ours the ways of one engine \param theirs others
/// \return one for each error on a front of the others, largest first
std::vector<Comparison> compareFronts(std::span<const NamedFront> ours,
                                      std::span<const NamedFront> theirs);

}  // namespace carom::scenes

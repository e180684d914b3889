#pragma once
// The parts of the suite `integrators`, and what they hand to each other.

#include "bench/integrators_race.hpp"
#include "carom/rotation/quaternion.hpp"

namespace carom::bench {

/// What all parts write into.
struct Figures {
  Json rows = Json::array();     ///< a row for each point of each diagram
  Json targets = Json::array();  ///< what was to be reached, and what was
};

/// A number of a case, from the project's references. \param id of the case \param path keys
Real caseNumber(const std::string& id, const std::string& key, int index = -1, int inner = -1);

/// Writes how many times faster ours are than the best peer at one error: the best of all, where one
/// of them is a closed form, and the best of the steps. \param closedForms how many times were
/// wanted of a closed form \param steps and of the steps; 0: nothing was
void judge(Figures& figures, const char* diagram, const Race& race, const std::string& scene,
           Real level, Real closedForms, Real steps);

/// W2 and scene F: bodies that turn freely.
void freeRotors(const Options& options, Figures& figures);
/// W3: tops.
void heavyTops(const Options& options, Figures& figures);
/// W4: pendulum, air and planets.
void translations(const Options& options, Figures& figures);
/// W5: what a million steps do to the energy.
void energyDrift(const Options& options, Figures& figures);
/// Steps by themselves: nanoseconds, and ten thousand bodies beside a copy.
void singleSteps(const Options& options, Figures& figures);
/// The orders that every method shows.
void measuredOrders(Figures& figures);

}  // namespace carom::bench

#pragma once
// What the suite `accuracy` keeps: for each problem every run, the fronts' comparison, and where
// and with what it was measured.
//
// The record is a file that pages draw from, without an engine. Problems that were not run stay in
// it as they were, so that it can be remade scene by scene.

#include <filesystem>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "scenes/fronts.hpp"
#include "scenes/problems.hpp"

namespace carom::bench {

/// The runs of one engine with one question.
struct Curve {
  std::string name;                        ///< of the engine
  bool ours = false;                       ///< Carom
  std::vector<scenes::CostAndError> runs;  ///< in the order of their steps [us per simulated s]
  std::vector<Real> failed;                ///< cost of runs that have no error [us per s]
};

/// Error over cost of each engine. \param problem what was run \param question a figure of it
/// \param rows of the problem \return one curve for each engine that ran it
std::vector<Curve> curvesOf(const scenes::Problem& problem, const scenes::Question& question,
                            const Json& rows);

/// Ours beside the others. \param question whose rounding counts \param curves of all engines
/// \return as compareFronts()
std::vector<scenes::Comparison> compared(const scenes::Question& question,
                                         const std::vector<Curve>& curves);

/// What a problem came to, for the record. \param problem what was run \param rows of it
/// \param where machine, compiler and flags
Json recordOf(const scenes::Problem& problem, const Json& rows, const std::string& where);

/// Puts problems into a record. \param file made if it is not there
/// \param records by name of the problem
void keepRecords(const std::filesystem::path& file, const Json& records);

/// Draws a question of a problem. \param file to write \param problem with its title
/// \param question with its axis \param curves of all engines
void drawFronts(const std::filesystem::path& file, const scenes::Problem& problem,
                const scenes::Question& question, const std::vector<Curve>& curves);

}  // namespace carom::bench

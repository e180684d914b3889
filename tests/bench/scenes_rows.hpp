#pragma once
// Runs of scenes for the suites `scenes`, `accuracy`, `growth` and `skip`: one process for each, so that an
// engine that crashes, hangs or asks for too much memory loses a row and not the suite.

#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "scenes/families.hpp"
#include "scenes/run_scene.hpp"

namespace carom::bench {

/// What the command line of these suites says beside that of all.
struct SceneOptions {
  Options common;
  std::vector<std::string> engines;  ///< names or beginnings of names; empty: the best of each
  std::vector<std::string> scenes;   ///< beginnings of names; empty: all
  std::vector<Real> rates{60};       ///< steps per second
  int limit = 120;                   ///< processor time of a run [s]
  int most = 100'000;                ///< bodies, for growth and skipping
  bool list = false;                 ///< only say what there is
  Real batch = 0;                    ///< as RunOptions has it [s]
};

/// Reads --engine A,B, --scene A,B, --rates 60,240, --limit SECONDS, --most N and --list, and
/// leaves the rest to readOptions().
SceneOptions readSceneOptions(int argc, char** argv);

/// The engines that were asked for.
std::vector<scenes::EngineKind> enginesOf(const SceneOptions& options);

/// Whether an engine with these settings is to run a scene.
bool runs(const SceneOptions& options, const scenes::EngineKind& kind, const scenes::Scene& scene);

/// One run in a process of its own.
/// \param suite name for the row \param kind engine \param scene what
/// \param rate steps per second \param options limits and repeats
/// \return a row; with "failed" where there is nothing to report
Json rowOf(const std::string& suite, const scenes::EngineKind& kind, const scenes::Scene& scene,
           Real rate, const SceneOptions& options);

/// Prints the engines with their settings.
void printEngines(const std::vector<scenes::EngineKind>& kinds);

/// Prints the rows of one scene.
void printRows(const Json& rows);

}  // namespace carom::bench

#pragma once
// Lets an engine run a scene: what does it cost, and how wrong is the result?
//
// Processor time is taken around blocks of steps between two looks of the judge, so what the judge
// does is not counted. Its clock may tick as coarsely as 10 ms; where the whole run takes less than
// a second, the scene is run again without a judge, as often as asked. Of each hundredth of the run
// the median of those runs counts, by the clock on the wall: so what other programs take of a run
// drops out. Runs of a few steps are timed in batches: their worlds are made beforehand. The final state must be the same to the last bit, so
// time and error belong to the same motion.

#include "scenes/scene.hpp"

namespace carom::scenes {

/// What came of a run.
struct Run {
  std::vector<Figure> figures;   ///< of the judge
  std::vector<Figure> counters;  ///< of the engine: mean over the steps before a look
  Real seconds = 0;              ///< of processor time, in the part that is timed [s]
  Real simulated = 0;            ///< in the same part [s]
  long steps = 0;                ///< in the same part
  bool finite = true;            ///< whether all states were numbers
  bool repeats = true;           ///< whether every run ended in the same state
  std::uint64_t hash = 0;        ///< of the final state
  long allocations = 0;          ///< in the steps of the timed part, if they were counted
  Real bytes = 0;                ///< taken by the engine at the end, if it was measured
};

/// How a scene is run.
struct RunOptions {
  int repeats =
      0;  ///< runs without a judge, if one takes less than a second; 0: time the judged one
  /// If positive, repeats are timed in pieces of about this length instead of hundredths, and the
  /// states are read where the judge would look; runs that are shorter are timed many at once [s].
  Real batch = 0;
  std::function<long()> allocations;  ///< how often memory was asked for so far; may be empty
  std::function<Real()> bytes;        ///< how much memory is taken now; may be empty
};

/// Runs a scene.
/// \param kind which engine \param scene what \param dt length of a step [s]
/// \param options repeats and meters \return what came of it
Run runScene(const EngineKind& kind, const Scene& scene, Real dt, const RunOptions& options = {});

}  // namespace carom::scenes

#pragma once
// What does a world keep for its piles?
//
// Nothing that lasts: memory that is used again, and threads. A copy of a world gets its own.

#include <cstdint>
#include <memory>
#include <vector>

#include "carom/core/kept_threads.hpp"
#include "carom/solver/graph_colors.hpp"
#include "carom/solver/soft_steps.hpp"

namespace carom::world {

/// Threads and memory of piles. \ingroup world
struct Pile {
  SoftSteps steps;                       ///< the solver
  std::vector<std::int32_t> islands;     ///< that go by soft steps in this step
  std::vector<std::int32_t> members;     ///< bodies, those that can be moved first
  std::vector<std::int32_t> pairs;       ///< pairs that have points
  std::vector<ColorEdge> edges;          ///< their bodies
  std::vector<std::uint8_t> counts;      ///< their points
  std::unique_ptr<KeptThreads> threads;  ///< made when they are first needed

  Pile() = default;
  /// \cond
  Pile(const Pile&) {}
  Pile& operator=(const Pile&) {
    return *this;
  }
  /// \endcond
};

/// The threads of a world. \param pile of the world \param count how many are wanted
/// \return so many \ingroup world
inline KeptThreads& threadsOf(Pile& pile, int count) {
  if (!pile.threads || pile.threads->count() != count) {
    pile.threads = std::make_unique<KeptThreads>(count);
  }
  return *pile.threads;
}

}  // namespace carom::world

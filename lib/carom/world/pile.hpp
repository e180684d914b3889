#pragma once
// What does a world keep for its piles?
//
// Nothing that lasts: memory that is used again, and threads. A copy of a world gets its own.

#include <cstdint>
#include <memory>
#include <vector>

#include "carom/core/kept_threads.hpp"
#include "carom/core/real.hpp"
#include "carom/solver/graph_colors.hpp"
#include "carom/solver/soft_steps.hpp"

namespace carom::world {

/// A pair of a pile, as much of it as is asked in the order of all. \ingroup world
struct PileLook {
  std::int32_t pair = -1;  ///< which
  std::int32_t a = -1;     ///< local number of its first body; negative if it cannot be moved
  std::int32_t b = -1;     ///< the same of the second
  std::uint8_t count = 0;  ///< its points
};

/// Threads and memory of piles. \ingroup world
struct Pile {
  SoftSteps steps;                       ///< the solver
  std::vector<std::int32_t> islands;     ///< that go by soft steps in this step
  std::vector<std::size_t> firsts;       ///< of each of these the place of its first body in a list
  std::vector<Real> shares;              ///< of its speed that it may keep [1]
  std::vector<PileLook> looks;           ///< their pairs
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

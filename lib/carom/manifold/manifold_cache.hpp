#pragma once
// What is worth remembering of a pair of bodies from one step to the next?
//
// Only hints. An axis that separated the pair is tried first; the features that were nearest start
// the search. No result is ever taken from here: the answer with a cache is the answer without one,
// bit for bit, or a replay that starts in the middle would differ from the run that it repeats.
// Source: temporal coherence after Baraff 1990; Gregorius, GDC 2015.

#include <cstdint>

#include "carom/core/real.hpp"

namespace carom {

/// Hints for one pair of convex shapes. Start with a default-made one, and keep it with the pair.
/// \ingroup manifold
struct ManifoldCache {
  std::int32_t axis = -1;      ///< axis that separated or was best: numbering of the pair's method
  std::int32_t featureA = -1;  ///< face, edge or vertex of A that was nearest; -1: unknown
  std::int32_t featureB = -1;  ///< face, edge or vertex of B that was nearest; -1: unknown
  std::int32_t vertexA = 0;    ///< vertex of A that was farthest along the normal
  std::int32_t vertexB = 0;    ///< vertex of B that was farthest against the normal
};

}  // namespace carom

#include "pair_counts.hpp"

#include "grading/seam.hpp"
#include "pair_counts_fields.hpp"

CAROM_SEAM(std::vector<PairCount>, pairCounts,
           (std::span<const Aabb<3>> scene, std::span<const int> counts), (scene, counts))

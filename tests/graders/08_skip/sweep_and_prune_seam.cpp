#include "carom/broadphase/sweep_and_prune.hpp"

#include "grading/fields_broadphase.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<IndexPair>, sweepAndPrune, (std::span<const Aabb<3>> boxes), (boxes))

#include "carom/broadphase/grid_pairs.hpp"

#include "grading/fields_broadphase.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<IndexPair>, gridPairs, (std::span<const Aabb<3>> boxes, Real cell),
           (boxes, cell))

#include "carom/broadphase/tree_query.hpp"

#include "grading/fields_broadphase.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<std::int32_t>, treeQuery, (const BoxTree& tree, const Aabb<3>& box),
           (tree, box))

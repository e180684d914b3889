#include "carom/broadphase/tree_refit.hpp"

#include "grading/fields_broadphase.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(void, treeRefit, (BoxTree & tree, std::int32_t leaf, const Aabb<3>& box),
           (tree, leaf, box))

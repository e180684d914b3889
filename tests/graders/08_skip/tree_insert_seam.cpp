#include "carom/broadphase/tree_insert.hpp"

#include "grading/fields_broadphase.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::int32_t, treeInsert, (BoxTree & tree, const Aabb<3>& box, std::int32_t item),
           (tree, box, item))

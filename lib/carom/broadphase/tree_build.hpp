#pragma once
// How is a good tree made of many boxes at once?
//
// Method: from the top. The centres of the boxes are counted into eight bins along the axis on
// which they are spread most; of the seven cuts between bins the one is taken for which the
// surfaces of both halves, each times its number of boxes, add up to least (how many boxes a query
// will have to look at). Then the same with each half. The nodes come out in the order of a walk
// through the tree, each parent before its children and each left child next to it, so that walks
// and refits read memory forwards.
// Why bins: sorting at every level finds slightly better cuts for twice the time.
// Source: Wald, On fast construction of SAH-based bounding volume hierarchies, 2007.
// Not handled: splitting a box in two so that its halves lie better.

#include <vector>

#include "carom/broadphase/box_tree.hpp"

namespace carom {

/// A box and what it is the box of. \tparam Dim 2 or 3 \ingroup broadphase
template <int Dim>
struct BoxedItem {
  Aabb<Dim> box;              ///< [m]
  std::int32_t item = kNone;  ///< its number
};

/// Memory that building needs and keeps for the next time. \ingroup broadphase
struct BuildScratch {
  /// Boxes that wait for their nodes.
  struct Range {
    std::int32_t begin = 0;       ///< first of them
    std::int32_t end = 0;         ///< behind the last of them
    std::int32_t parent = kNone;  ///< the node above theirs
    bool isRight = false;         ///< theirs is the right child
  };
  std::vector<Range> open;  ///< ranges still to be built
};

/// Makes a tree of items.
/// \tparam Dim 2 or 3
/// \param items with boxes that hold a point; come back in the order of the leaves
/// \param tree gets all its nodes anew, in the order of a walk; takes memory only to grow
/// \param scratch memory to work in
/// \ingroup broadphase
template <int Dim>
void buildTree(std::vector<BoxedItem<Dim>>& items, TreeNodes<Dim>& tree, BuildScratch& scratch);

/// \cond
extern template void buildTree(std::vector<BoxedItem<2>>& items, TreeNodes<2>& tree,
                               BuildScratch& scratch);
extern template void buildTree(std::vector<BoxedItem<3>>& items, TreeNodes<3>& tree,
                               BuildScratch& scratch);
/// \endcond

}  // namespace carom

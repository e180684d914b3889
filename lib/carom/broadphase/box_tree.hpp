#pragma once
// What is a tree of boxes?
//
// Every leaf holds the box of one item; every other node has two children and a box that holds
// theirs. Who does not meet the box of a node meets nothing below it: half of the bodies are left
// out with one comparison. The nodes lie in one array and name each other by index.
// Why indices and a list of free places instead of pointers: the array can move in memory and be
// copied, a node is 64 bytes, one line of the cache, and the same scene gives the same tree.
// Source: Goldsmith and Salmon, IEEE Computer Graphics and Applications 7(5), 1987 (surface area);
// the source, section 5.3.1, names such a tree and leaves it there.
// Not handled: what makes a tree good (tree_insert.hpp, tree_build.hpp).

#include <algorithm>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// A leaf with an item, or a node above two others. \tparam Dim 2 or 3 \ingroup broadphase
template <int Dim>
struct TreeNode {
  Aabb<Dim> box;                ///< holds the boxes of both children; of a leaf: of its item [m]
  std::int32_t parent = kNone;  ///< the node above; of a free place: the next free one
  std::int32_t left = kNone;    ///< one child; none in a leaf
  std::int32_t right = kNone;   ///< the other child; none in a leaf
  std::int32_t item = kNone;    ///< what a leaf holds; none in a node with children

  /// Has it no children? \return true for a leaf
  bool isLeaf() const {
    return left == kNone;
  }
};
static_assert(sizeof(TreeNode<3>) == 64, "a node must fill one line of the cache");

/// The nodes of a tree. \tparam Dim 2 or 3 \ingroup broadphase
template <int Dim>
struct TreeNodes {
  std::vector<TreeNode<Dim>> nodes;  ///< in any order, with free places between them
  std::int32_t root = kNone;         ///< the node above all others; none in an empty tree
  std::int32_t free = kNone;         ///< first of the free places, linked by their `parent`
};

/// The tree of space. \ingroup broadphase
using BoxTree = TreeNodes<3>;

/// Takes a place for a node.
/// \tparam Dim 2 or 3 \param tree gets one node more \return index of a node as it is by default
/// \ingroup broadphase
template <int Dim>
std::int32_t takeNode(TreeNodes<Dim>& tree) {
  if (tree.free == kNone) {
    tree.nodes.emplace_back();
    return static_cast<std::int32_t>(tree.nodes.size()) - 1;
  }
  const std::int32_t node = tree.free;
  tree.free = tree.nodes[node].parent;
  tree.nodes[node] = TreeNode<Dim>();
  return node;
}

/// Gives the place of a node back.
/// \tparam Dim 2 or 3 \param tree loses the node \param node that nothing refers to any more
/// \ingroup broadphase
template <int Dim>
void giveNode(TreeNodes<Dim>& tree, std::int32_t node) {
  tree.nodes[node] = TreeNode<Dim>();
  tree.nodes[node].parent = tree.free;
  tree.free = node;
}

/// Half of the surface of a box: how likely it is that something large meets it. In the plane half
/// of its border. Sides above 1e100 m count as 1e100, so that two infinite boxes can be compared.
/// \param box that holds a point [m] \return [m^2]
/// \ingroup broadphase
inline Real halfSurface(const Aabb<3>& box) {
  const Real x = std::min(box.high(0) - box.low(0), Real(1e100));
  const Real y = std::min(box.high(1) - box.low(1), Real(1e100));
  const Real z = std::min(box.high(2) - box.low(2), Real(1e100));
  return x * y + y * z + z * x;
}

/// Half of the border of a rectangle; sides above 1e100 m count as 1e100.
/// \param box that holds a point [m] \return [m]
/// \ingroup broadphase
inline Real halfSurface(const Aabb<2>& box) {
  const Real x = std::min(box.high(0) - box.low(0), Real(1e100));
  const Real y = std::min(box.high(1) - box.low(1), Real(1e100));
  return x + y;
}

}  // namespace carom

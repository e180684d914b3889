#pragma once
// How are the boxes of moving bodies kept so that any of them is found at once?
//
// Method: a tree of boxes (box_tree.hpp) that knows where each item's leaf is. Items are put in
// where the surface grows least, and nodes on the way up change places where that makes a box
// smaller (rotations). An item that moves a little keeps its place, and the boxes above follow; one
// that leaves the box of its grandparent is taken out and put in again. Many that move at once are
// set together, and all boxes made anew from the last node to the first. When that has made the
// boxes much larger than they need be, rebuild() makes the tree new (tree_build.hpp).
// Why walks without a stack: a node that was looked at leads by its parent to the next one that is
// not below it. So no walk takes memory or can be too deep, and a walk that starts behind a leaf
// meets each of the pairs once.
// Why items and not leaves are named outside: rebuild() moves the leaves, so that neighbours in
// space are neighbours in memory.
// Source: Goldsmith and Salmon, 1987; Kopta et al., Fast, effective BVH updates for animated
// scenes, 2012 (rotations); Catto, Dynamic bounding volume hierarchies, GDC 2019.
// Not handled: margins around bodies and who makes pairs of what is found (broad_phase.hpp).

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "carom/broadphase/box_tree.hpp"
#include "carom/broadphase/tree_build.hpp"

namespace carom {

/// What a tree has done since it was made. \ingroup broadphase
struct TreeWork {
  std::int64_t moved = 0;       ///< leaves that got another box
  std::int64_t refitted = 0;    ///< boxes above leaves that were made anew
  std::int64_t reinserted = 0;  ///< of the moved, those that were put in at another place
  std::int64_t rotated = 0;     ///< nodes that changed places with another one
  std::int64_t rebuilt = 0;     ///< times that the whole tree was made anew
};

/// Does a box that moves along a straight way meet a box that rests?
/// \tparam Dim 2 or 3
/// \param resting the box that rests [m] \param moving the box that moves, where it starts [m]
/// \param way its displacement [m], finite \param limit how much of the way counts, 0 to 1
/// \return true if they meet; also, within a few roundings, if they pass at a hair's breadth
/// \ingroup broadphase
template <int Dim>
bool meetsOnWay(const Aabb<Dim>& resting, const Aabb<Dim>& moving,
                const typename Aabb<Dim>::Vector& way, Real limit) {
  Real enter = 0, leave = limit;
  for (int k = 0; k < Dim; ++k) {
    // They meet on this axis while near <= t way <= far.
    const Real near = resting.low(k) - moving.high(k), far = resting.high(k) - moving.low(k);
    if (way(k) == 0) {
      if (near > 0 || far < 0) return false;
    } else {
      enter = std::max(enter, (way(k) > 0 ? near : far) / way(k));
      leave = std::min(leave, (way(k) > 0 ? far : near) / way(k));
    }
  }
  // Both quotients are off by less than two units in the last place each.
  return enter <= leave * (1 + 4 * std::numeric_limits<Real>::epsilon());
}

/// A tree of the boxes of items; an item is a number from 0 that the caller chose, small numbers
/// preferred (memory goes with the largest). Nothing is allocated but when it grows beyond its
/// largest size yet; the same calls give the same tree and the same order of answers.
/// \tparam Dim 2 or 3
/// \ingroup broadphase
template <int Dim>
class Tree {
 public:
  /// The boxes of its items.
  using Box = Aabb<Dim>;
  /// A point or a displacement.
  using Vector = typename Aabb<Dim>::Vector;

  /// Makes room, so that no call takes memory up to this size.
  /// \param items how many items, and the first number that none of them has
  void reserve(std::int32_t items);

  /// Puts an item in.
  /// \param item a number from 0 that is not in the tree
  /// \param box low not above high, infinite sides allowed [m]
  /// \throws InvalidInput if the item is in already, or negative, or the box holds no point
  void insert(std::int32_t item, const Box& box);

  /// Takes an item out. \param item that is in the tree \throws InvalidInput if it is not
  void remove(std::int32_t item);

  /// Gives an item another box.
  /// \param item that is in the tree \param box as for insert()
  /// \throws InvalidInput if the item is not in, or the box holds no point
  void move(std::int32_t item, const Box& box);

  /// Gives many items other boxes at once; none of them changes its place in the tree.
  /// \param items that are in the tree, each once
  /// \param boxes one for each item, as for insert()
  /// \throws InvalidInput as move(), and if the spans differ in length; then nothing is changed
  void move(std::span<const std::int32_t> items, std::span<const Box> boxes);

  /// Makes the whole tree anew, as good as it can be, neighbours side by side in memory.
  void rebuild();

  /// Is an item in the tree? \param item any number \return true if it is
  bool contains(std::int32_t item) const {
    return item >= 0 && static_cast<std::size_t>(item) < leafOf_.size() && leafOf_[item] != kNone;
  }

  /// The box of an item. \param item that is in the tree \return as it was given [m]
  /// \throws InvalidInput if it is not in
  const Box& box(std::int32_t item) const;

  /// How many items it holds. \return 0 or more
  std::int32_t size() const {
    return size_;
  }

  /// Surface of all nodes above leaves, over that of the root: about how many of them a small box
  /// anywhere in the root meets. The less, the better the tree.
  /// \return [1]; 0 for fewer than two items
  Real quality() const;

  /// By what factor the quality has become worse since the last rebuild(), as of the last time
  /// that many items moved at once. \return [1], 1 after rebuild()
  Real worsening() const {
    return worsening_;
  }

  /// How many items came in since the last rebuild(), and an eighth of how often one changed its
  /// place: that was chosen in a tree that had nearly all others already.
  /// \return 0 or more
  std::int64_t unsettled() const {
    return added_ + replaced_ / 8;
  }

  /// The items whose closed boxes meet a box.
  /// \param box low not above high [m]
  /// \param visit called with each item, once; must not change the tree
  /// \return how many nodes were looked at
  template <class Visit>
  std::int64_t overlap(const Box& box, Visit&& visit) const;

  /// The items that a moving box may meet on its way.
  /// \param box where it starts, finite [m] \param way its displacement, finite [m]
  /// \param visit called with each item; returns how much of the way still counts from now on, as
  ///   a fraction from 0 to 1 (1 to go on, what it hit to shorten, below 0 to end)
  /// \return how many nodes were looked at
  template <class Visit>
  std::int64_t sweep(const Box& box, const Vector& way, Visit&& visit) const;

  /// The items whose boxes a ray may hit.
  /// \param origin where it starts [m] \param way to where it ends, from there [m]
  /// \param visit as for sweep()
  /// \return how many nodes were looked at
  template <class Visit>
  std::int64_t ray(const Vector& origin, const Vector& way, Visit&& visit) const {
    return sweep(Box{origin, origin}, way, std::forward<Visit>(visit));
  }

  /// All pairs of items of this tree whose closed boxes meet.
  /// \param visit called with two items, each pair once, in no particular order of the two
  /// \return how many nodes were looked at
  template <class Visit>
  std::int64_t pairs(Visit&& visit) const;

  /// All pairs of an item of this tree and one of another whose closed boxes meet.
  /// \param other another tree \param visit called with an item of this and one of the other
  /// \return how many nodes were looked at
  template <class Visit>
  std::int64_t pairs(const Tree& other, Visit&& visit) const;

  /// All items, in the order of the leaves: neighbours in space near each other.
  /// \param visit called with each item
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (std::int32_t node = nodes_.root; node != kNone; node = next(node)) {
      if (nodes_.nodes[node].isLeaf()) visit(nodes_.nodes[node].item);
    }
  }

  /// The nodes, to look at. \return the tree as the chapter explains it
  const TreeNodes<Dim>& nodes() const {
    return nodes_;
  }

  /// What it has done so far. \return counts since it was made
  const TreeWork& work() const {
    return work_;
  }

 private:
  // The first node of a walk that is not below this one.
  std::int32_t behind(std::int32_t node) const {
    const TreeNode<Dim>* nodes = nodes_.nodes.data();
    for (std::int32_t above = nodes[node].parent; above != kNone; above = nodes[node].parent) {
      if (nodes[above].left == node) return nodes[above].right;
      node = above;
    }
    return kNone;
  }
  std::int32_t next(std::int32_t node) const {
    const TreeNode<Dim>& at = nodes_.nodes[node];
    return at.isLeaf() ? behind(node) : at.left;
  }
  template <class Visit>
  std::int64_t overlapFrom(std::int32_t node, const Box& box, Visit&& visit) const;

  void requireIn(std::int32_t item) const;
  void insertLeaf(const Box& box, std::int32_t item);
  void takeLeaves();
  void makeFromLeaves();
  void removeLeaf(std::int32_t leaf);
  void rotate(std::int32_t node);
  void refitFrom(std::int32_t node);
  Real refitAll();

  TreeNodes<Dim> nodes_;
  std::vector<std::int32_t> leafOf_;  // by item
  std::vector<BoxedItem<Dim>> leaves_;
  BuildScratch scratch_;
  TreeWork work_;
  std::int32_t size_ = 0;
  std::int64_t added_ = 0, replaced_ = 0;  // since the last rebuild()
  Real builtSurface_ = 0;  // of all nodes above leaves, after the last rebuild [m^2]
  Real worsening_ = 1;
  bool ordered_ = false;  // every child behind its parent in memory
};

template <int Dim>
template <class Visit>
std::int64_t Tree<Dim>::overlapFrom(std::int32_t node, const Box& box, Visit&& visit) const {
  const TreeNode<Dim>* nodes = nodes_.nodes.data();
  std::int64_t visited = 0;
  while (node != kNone) {
    const TreeNode<Dim>& at = nodes[node];
    ++visited;
    if (!meets(at.box, box)) {
      node = behind(node);
    } else if (at.isLeaf()) {
      visit(at.item);
      node = behind(node);
    } else {
      node = at.left;
    }
  }
  return visited;
}

template <int Dim>
template <class Visit>
std::int64_t Tree<Dim>::overlap(const Box& box, Visit&& visit) const {
  return overlapFrom(nodes_.root, box, std::forward<Visit>(visit));
}

template <int Dim>
template <class Visit>
std::int64_t Tree<Dim>::sweep(const Box& box, const Vector& way, Visit&& visit) const {
  std::int64_t visited = 0;
  Real limit = 1;
  for (std::int32_t node = nodes_.root; node != kNone && limit >= 0;) {
    const TreeNode<Dim>& at = nodes_.nodes[node];
    ++visited;
    if (!meetsOnWay(at.box, box, way, limit)) {
      node = behind(node);
    } else if (at.isLeaf()) {
      limit = std::min(limit, static_cast<Real>(visit(at.item)));
      node = behind(node);
    } else {
      node = at.left;
    }
  }
  return visited;
}

template <int Dim>
template <class Visit>
std::int64_t Tree<Dim>::pairs(Visit&& visit) const {
  std::int64_t visited = 0;
  for (std::int32_t node = nodes_.root; node != kNone; node = next(node)) {
    const TreeNode<Dim>& at = nodes_.nodes[node];
    if (!at.isLeaf()) continue;
    // Those before it have met it already.
    visited += overlapFrom(behind(node), at.box, [&](std::int32_t b) { visit(at.item, b); });
  }
  return visited;
}

template <int Dim>
template <class Visit>
std::int64_t Tree<Dim>::pairs(const Tree& other, Visit&& visit) const {
  std::int64_t visited = 0;
  for (std::int32_t node = nodes_.root; node != kNone; node = next(node)) {
    const TreeNode<Dim>& at = nodes_.nodes[node];
    if (!at.isLeaf()) continue;
    visited += other.overlap(at.box, [&](std::int32_t b) { visit(at.item, b); });
  }
  return visited;
}

extern template class Tree<2>;
extern template class Tree<3>;

}  // namespace carom

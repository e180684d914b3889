#include "carom/broadphase/tree.hpp"

#include "carom/broadphase/require_box.hpp"
#include "carom/broadphase/tree_insert.hpp"
#include "carom/broadphase/tree_refit.hpp"
#include "carom/core/checks.hpp"
#include "carom/core/reserve_ahead.hpp"
#include "carom/core/variant.hpp"

namespace carom {
namespace {

template <int Dim>
bool same(const Aabb<Dim>& a, const Aabb<Dim>& b) {
  return a.low == b.low && a.high == b.high;
}

}  // namespace

template <int Dim>
void Tree<Dim>::reserve(std::int32_t items) {
  if (items <= 0) return;
  const auto count = static_cast<std::size_t>(items);
  reserveAhead(nodes_.nodes, 2 * count);
  reserveAhead(leafOf_, count);
  reserveAhead(leaves_, count);
  reserveAhead(scratch_.open, count);
}

template <int Dim>
void Tree<Dim>::requireIn(std::int32_t item) const {
  if (!contains(item)) reject("item", std::to_string(item), "must be in the tree");
}

template <int Dim>
const Aabb<Dim>& Tree<Dim>::box(std::int32_t item) const {
  requireIn(item);
  return nodes_.nodes[leafOf_[item]].box;
}

template <int Dim>
void Tree<Dim>::insert(std::int32_t item, const Box& box) {
  requireItem(item);
  requireBox(box);
  if (contains(item)) reject("item", std::to_string(item), "must not be in the tree yet");
  if (static_cast<std::size_t>(item) >= leafOf_.size()) leafOf_.resize(item + 1, kNone);
  insertLeaf(box, item);
  ++size_;
  ++added_;
}

template <int Dim>
void Tree<Dim>::insertLeaf(const Box& box, std::int32_t item) {
  if constexpr (Dim == 3) {
    ordered_ = false;
    leafOf_[item] = treeInsert(nodes_, box, item);
    if (takesPlainPath()) return;
    // Nodes whose boxes have grown may now be better off elsewhere: from below, without the first,
    // whose children are two boxes that it was made for.
    const std::int32_t made = nodes_.nodes[leafOf_[item]].parent;
    for (std::int32_t up = made; up != kNone; up = nodes_.nodes[up].parent) {
      if (up != made) rotate(up);
    }
  } else {
    // In the plane there are only pictures, of tens of boxes: all of it is made anew.
    takeLeaves();
    leaves_.push_back({box, item});
    makeFromLeaves();
  }
}

// Changes one child with one grandchild on the other side, if the box that this changes gets
// smaller. The box of the node itself stays as it is.
template <int Dim>
void Tree<Dim>::rotate(std::int32_t top) {
  TreeNode<Dim>* nodes = nodes_.nodes.data();
  Real most = 0;
  std::int32_t child = kNone, grandchild = kNone;
  Box box;
  const auto attempt = [&](std::int32_t alone, std::int32_t side) {
    if (nodes[side].isLeaf()) return;
    const Real before = halfSurface(nodes[side].box);
    const auto exchange = [&](std::int32_t goes, std::int32_t stays) {
      const Box changed = joined(nodes[alone].box, nodes[stays].box);
      const Real gain = before - halfSurface(changed);
      if (!(gain > most)) return;
      most = gain;
      child = alone;
      grandchild = goes;
      box = changed;
    };
    exchange(nodes[side].left, nodes[side].right);
    exchange(nodes[side].right, nodes[side].left);
  };
  attempt(nodes[top].left, nodes[top].right);
  attempt(nodes[top].right, nodes[top].left);
  if (child == kNone) return;

  const std::int32_t side = nodes[grandchild].parent;
  (nodes[top].left == child ? nodes[top].left : nodes[top].right) = grandchild;
  (nodes[side].left == grandchild ? nodes[side].left : nodes[side].right) = child;
  nodes[grandchild].parent = top;
  nodes[child].parent = side;
  nodes[side].box = box;
  ++work_.rotated;
}

// Makes the boxes from a node upwards, until one stays as it was.
template <int Dim>
void Tree<Dim>::refitFrom(std::int32_t node) {
  TreeNode<Dim>* nodes = nodes_.nodes.data();
  for (; node != kNone; node = nodes[node].parent) {
    const Box box = joined(nodes[nodes[node].left].box, nodes[nodes[node].right].box);
    ++work_.refitted;
    if (same(box, nodes[node].box)) return;
    nodes[node].box = box;
  }
}

template <int Dim>
void Tree<Dim>::removeLeaf(std::int32_t leaf) {
  TreeNode<Dim>* nodes = nodes_.nodes.data();
  const std::int32_t parent = nodes[leaf].parent;
  giveNode(nodes_, leaf);
  if (parent == kNone) {
    nodes_.root = kNone;
    return;
  }
  // The sibling takes the place of the node that was above both.
  const std::int32_t sibling =
      nodes[parent].left == leaf ? nodes[parent].right : nodes[parent].left;
  const std::int32_t higher = nodes[parent].parent;
  nodes[sibling].parent = higher;
  giveNode(nodes_, parent);
  if (higher == kNone) {
    nodes_.root = sibling;
    return;
  }
  (nodes[higher].left == parent ? nodes[higher].left : nodes[higher].right) = sibling;
  refitFrom(higher);
}

template <int Dim>
void Tree<Dim>::remove(std::int32_t item) {
  requireIn(item);
  removeLeaf(leafOf_[item]);
  leafOf_[item] = kNone;
  --size_;
}

template <int Dim>
void Tree<Dim>::move(std::int32_t item, const Box& box) {
  requireIn(item);
  requireBox(box);
  ++work_.moved;
  const std::int32_t leaf = leafOf_[item];
  if constexpr (Dim == 3) {
    if (takesPlainPath()) return treeRefit(nodes_, leaf, box);
  }
  TreeNode<Dim>* nodes = nodes_.nodes.data();
  const std::int32_t parent = nodes[leaf].parent;
  const std::int32_t above = parent == kNone ? kNone : nodes[parent].parent;
  if (above == kNone || holds(nodes[above].box, box)) {
    nodes_.nodes[leaf].box = box;
    refitFrom(parent);
    return;
  }
  ++work_.reinserted;
  ++replaced_;
  removeLeaf(leaf);
  insertLeaf(box, item);
}

template <int Dim>
void Tree<Dim>::move(std::span<const std::int32_t> items, std::span<const Box> boxes) {
  if (items.size() != boxes.size()) {
    reject("number of boxes", std::to_string(boxes.size()), "must be that of the items");
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    requireIn(items[i]);
    requireBox(boxes[i]);
  }
  // One pass over all nodes costs less than many walks up; it needs them in order.
  const bool together = ordered_ && 16 * static_cast<std::int64_t>(items.size()) > size_;
  bool plain = false;
  if constexpr (Dim == 3) plain = takesPlainPath();
  if (!together || plain) {
    for (std::size_t i = 0; i < items.size(); ++i) move(items[i], boxes[i]);
    return;
  }
  for (std::size_t i = 0; i < items.size(); ++i) nodes_.nodes[leafOf_[items[i]]].box = boxes[i];
  work_.moved += static_cast<std::int64_t>(items.size());
  const Real surface = refitAll();
  worsening_ = builtSurface_ > 0 ? surface / builtSurface_ : 1;
}

template <int Dim>
Real Tree<Dim>::refitAll() {
  Real surface = 0;
  for (auto node = nodes_.nodes.rbegin(); node != nodes_.nodes.rend(); ++node) {
    if (node->isLeaf()) continue;
    node->box = joined(nodes_.nodes[node->left].box, nodes_.nodes[node->right].box);
    surface += halfSurface(node->box);
  }
  work_.refitted += size_ - 1;
  return surface;
}

template <int Dim>
void Tree<Dim>::takeLeaves() {
  leaves_.clear();
  forEach([&](std::int32_t item) { leaves_.push_back({nodes_.nodes[leafOf_[item]].box, item}); });
}

template <int Dim>
void Tree<Dim>::rebuild() {
  takeLeaves();
  makeFromLeaves();
}

template <int Dim>
void Tree<Dim>::makeFromLeaves() {
  buildTree(leaves_, nodes_, scratch_);
  for (std::size_t node = 0; node < nodes_.nodes.size(); ++node) {
    if (nodes_.nodes[node].isLeaf()) {
      leafOf_[nodes_.nodes[node].item] = static_cast<std::int32_t>(node);
    }
  }
  builtSurface_ = 0;
  for (const TreeNode<Dim>& node : nodes_.nodes) {
    if (!node.isLeaf()) builtSurface_ += halfSurface(node.box);
  }
  worsening_ = 1;
  added_ = replaced_ = 0;
  ordered_ = true;
  ++work_.rebuilt;
}

template <int Dim>
Real Tree<Dim>::quality() const {
  if (size_ < 2) return 0;
  Real surface = 0;
  for (std::int32_t node = nodes_.root; node != kNone; node = next(node)) {
    if (!nodes_.nodes[node].isLeaf()) surface += halfSurface(nodes_.nodes[node].box);
  }
  const Real whole = halfSurface(nodes_.nodes[nodes_.root].box);
  // All at one point: every node is met whenever the root is.
  return whole > 0 ? surface / whole : size_ - 1;
}

template class Tree<2>;
template class Tree<3>;

}  // namespace carom

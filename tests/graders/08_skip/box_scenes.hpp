#pragma once
// Scenes of boxes for the graders of chapter 8, and the truth about them, by trying everything.

#include <algorithm>
#include <vector>

#include "carom/broadphase/box_tree.hpp"
#include "carom/broadphase/index_pair.hpp"
#include "grading/fields_broadphase.hpp"
#include "grading/grade.hpp"

namespace carom::grading {

using Boxes = std::vector<Aabb<3>>;
using Pairs = std::vector<IndexPair>;

/// A box by its middle and half its edges [m].
inline Aabb<3> boxAround(const Vector3& center, const Vector3& half) {
  return {center - half, center + half};
}

/// A box by its corners [m].
inline Aabb<3> boxFrom(const Vector3& low, const Vector3& high) {
  return {low, high};
}

/// Boxes of 0.4 to 1.6 m anywhere within +-size [m].
inline Boxes crowd(Random& random, int count, Real size) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const Vector3 center = random.vector(size);
    Vector3 half;
    for (int k = 0; k < 3; ++k) half(k) = random.between(0.2, 0.8);
    boxes.push_back(boxAround(center, half));
  }
  return boxes;
}

/// Have two boxes a point in common? Touching counts.
inline bool haveCommonPoint(const Aabb<3>& a, const Aabb<3>& b) {
  for (int k = 0; k < 3; ++k) {
    if (std::max(a.low(k), b.low(k)) > std::min(a.high(k), b.high(k))) return false;
  }
  return true;
}

/// The pairs, by trying all.
inline Pairs pairsAmong(const Boxes& boxes) {
  Pairs pairs;
  const auto count = static_cast<std::int32_t>(boxes.size());
  for (std::int32_t a = 0; a < count; ++a) {
    for (std::int32_t b = a + 1; b < count; ++b) {
      if (haveCommonPoint(boxes[a], boxes[b])) pairs.push_back({a, b});
    }
  }
  return pairs;
}

/// A tree of boxes in the order given: halves of halves, or each beside all that follow (a chain).
/// Items are 10, 11, 12, ..., so that none is mistaken for the number of a node.
inline BoxTree treeOf(const Boxes& boxes, bool chain = false) {
  struct Range {
    std::int32_t begin, end, parent;
    bool right;
  };
  BoxTree tree;
  if (boxes.empty()) return tree;
  std::vector<Range> open = {{0, static_cast<std::int32_t>(boxes.size()), kNone, false}};
  while (!open.empty()) {
    const Range range = open.back();
    open.pop_back();
    const auto node = static_cast<std::int32_t>(tree.nodes.size());
    tree.nodes.emplace_back();
    tree.nodes[node].parent = range.parent;
    if (range.parent == kNone) {
      tree.root = node;
    } else {
      (range.right ? tree.nodes[range.parent].right : tree.nodes[range.parent].left) = node;
    }
    tree.nodes[node].box = boxes[range.begin];
    for (std::int32_t i = range.begin; i < range.end; ++i) {
      tree.nodes[node].box.low = tree.nodes[node].box.low.cwiseMin(boxes[i].low);
      tree.nodes[node].box.high = tree.nodes[node].box.high.cwiseMax(boxes[i].high);
    }
    if (range.end - range.begin == 1) {
      tree.nodes[node].item = 10 + range.begin;
      continue;
    }
    const std::int32_t middle = chain ? range.begin + 1 : (range.begin + range.end) / 2;
    open.push_back({middle, range.end, node, true});
    open.push_back({range.begin, middle, node, false});
  }
  return tree;
}

/// The leaf of an item.
inline std::int32_t leafOf(const BoxTree& tree, std::int32_t item) {
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(tree.nodes.size()); ++i) {
    if (tree.nodes[i].isLeaf() && tree.nodes[i].item == item) return i;
  }
  return kNone;
}

}  // namespace carom::grading

#pragma once
// How the types of chapter 8's broad phase cross the pipe.

#include "carom/broadphase/box_tree.hpp"
#include "carom/broadphase/index_pair.hpp"
#include "grading/fields_detection.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<IndexPair> {
  static constexpr auto list = fieldList("first", &IndexPair::first, "second", &IndexPair::second);
};

template <int Dim>
struct Fields<TreeNode<Dim>> {
  static constexpr auto list =
      fieldList("box", &TreeNode<Dim>::box, "parent", &TreeNode<Dim>::parent, "left",
                &TreeNode<Dim>::left, "right", &TreeNode<Dim>::right, "item", &TreeNode<Dim>::item);
};

template <int Dim>
struct Fields<TreeNodes<Dim>> {
  static constexpr auto list = fieldList("nodes", &TreeNodes<Dim>::nodes, "root",
                                         &TreeNodes<Dim>::root, "free", &TreeNodes<Dim>::free);
};

}  // namespace carom::grading

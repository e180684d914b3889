#pragma once
// Which contacts may be solved side by side?
//
// Method: contacts are edges of a graph whose nodes are bodies; edges that share a body get
// different colours, and what has one colour can be solved in any order, or at once. Each edge, in
// the order in which it is given, takes the first colour that neither of its bodies has. Bodies that
// cannot be moved do not count: nothing is written to them, so all contacts with a floor may share
// it.
// Why the first that fits and no better: when an edge is coloured, each of its two bodies has at
// most d - 1 others that are, so 2d - 1 colours are always enough. The best possible is d or d + 1,
// and to tell which of the two is hard.
// Source: greedy edge colouring; Vizing 1964 for the best; for solvers Harada 2011.
// Not handled: in which order colours are solved (graph_colors.hpp).

#include <cstdint>
#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// A contact as an edge. \ingroup solver
struct ColorEdge {
  std::int32_t a = 0;  ///< number of one body
  std::int32_t b = 0;  ///< of the other
};

/// Colours contacts so that no two of one colour have a movable body in common.
/// \param edges the contacts
/// \param movable bodies with smaller numbers than this can be moved; the others may be shared
/// \return a colour for each contact, from zero without gaps; at most 2 d - 1 of them, when no
/// movable body has more than d contacts
/// \throws InvalidInput if a number is negative, or a contact joins a movable body with itself
/// \ingroup solver
std::vector<std::int32_t> colorGraph(std::span<const ColorEdge> edges, std::int32_t movable);

}  // namespace carom

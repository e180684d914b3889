#pragma once
// How do thousands of contacts get their colours in every step?
//
// Method: colorGraph()'s, with memory that is kept and the colours of a body as bits of a number. A
// body with all of 64 counts on from there. Contacts with what cannot be moved come last, in colours
// of their own, so that what cannot give way has the last word in a sweep.
// Source: color_graph.hpp; the bits and the order: Catto 2025 (Box3D).
// Not handled: keeping colours from step to step: made anew they cost some nanoseconds per contact.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/solver/color_graph.hpp"

namespace carom {

/// Gives colours to contacts, and keeps its memory. \ingroup solver
class GraphColors {
 public:
  /// Colours edges. \param edges the contacts \param movable bodies with smaller numbers than this
  /// can be moved; the others may be shared \param colors receives a colour per edge, from zero
  /// \return how many colours there are
  int color(std::span<const ColorEdge> edges, std::int32_t movable,
            std::vector<std::int32_t>& colors);

 private:
  std::vector<std::uint64_t> taken_;  // bit c: the body has colour c
  std::vector<std::int32_t> next_;    // of a body with all of these: its next colour
};

}  // namespace carom

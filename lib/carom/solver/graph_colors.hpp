#pragma once
// Which contacts can be solved at the same time?
//
// Method: contacts are edges of a graph whose nodes are bodies; edges that share a body get
// different colours, and what has one colour can be solved in any order, or at once. Each edge, in
// the order in which it is given, takes the first colour that neither of its bodies has. Bodies that
// cannot be moved do not count: a floor may be shared. Contacts with them come last, in colours of
// their own, so that what cannot give way has the last word in a sweep.
// Why the first that fits and no better: a body has few contacts, and with d of them at most 2d - 1
// colours are used; looking for fewer costs more than it saves.
// Source: greedy edge colouring; for solvers Harada 2011, Catto 2025 (Box3D).
// Not handled: keeping colours from step to step: made anew they cost some nanoseconds per contact.

#include <cstdint>
#include <span>
#include <vector>

namespace carom {

/// A contact as an edge. \ingroup solver
struct ColorEdge {
  std::int32_t a = 0;  ///< number of one body
  std::int32_t b = 0;  ///< of the other
};

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

#pragma once
// Clipping with names: Sutherland and Hodgman in fixed memory.
//
// Method: that of clipPolygon(), in the plane of the reference face, with a height per corner and a
// label per edge. The label says which edge of which body an edge of the loop lies on; a corner
// between two labels is named by them, and keeps its name when it moves.
// Why in the plane: a side plane of a rectangle is a comparison with one coordinate, and areas are
// products of two numbers. Why fixed memory: a step must not allocate.
// Not handled: loops that outgrow the memory of the caller; a cut adds at most one corner.

#include <cmath>
#include <cstdint>

#include "carom/core/real.hpp"

namespace carom::detail {

/// A corner of a clipped loop. Without initial values, because loops lie on the stack.
/// \ingroup manifold
struct ClipCorner {
  Real x;              ///< first coordinate in the reference plane [m]
  Real y;              ///< second coordinate in the reference plane [m]
  Real height;         ///< over the reference plane, negative below [m]
  std::int32_t label;  ///< edge that leaves this corner: see the clipper
};

/// Cuts a loop and keeps what has value(corner) <= 0.
/// \tparam Value callable: signed height of a corner over the cutting plane
/// \param in corners in order \param count how many \param label of the edge that the cut makes
/// \param value signed height over the cut, linear in the corner
/// \param snap corners this close to the cut lie on it: so that corners that coincide but for
///   rounding keep their names [unit of value]
/// \param out receives the corners that are left; not `in`
/// \return how many are left
/// \ingroup manifold
template <class Value>
inline int clipLoop(const ClipCorner* in, int count, std::int32_t label, const Value& value,
                    Real snap, ClipCorner* out) {
  int kept = 0;
  if (count == 0) return 0;
  const auto snapped = [&](const ClipCorner& corner) {
    const Real height = value(corner);
    return std::abs(height) <= snap ? 0 : height;
  };
  Real height = snapped(in[0]);
  for (int i = 0; i < count; ++i) {
    const ClipCorner& from = in[i];
    const ClipCorner& to = in[i + 1 < count ? i + 1 : 0];
    const Real next = snapped(to);
    if (height <= 0) out[kept++] = from;
    // Always from the corner that is kept, so that an edge is cut alike both ways round.
    if (height < 0 && next > 0) {
      const Real part = height / (height - next);
      out[kept++] = {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                     from.height + part * (to.height - from.height), label};
    } else if (height > 0 && next < 0) {
      const Real part = next / (next - height);
      out[kept++] = {to.x + part * (from.x - to.x), to.y + part * (from.y - to.y),
                     to.height + part * (from.height - to.height), from.label};
    } else if (height == 0 && next > 0) {
      // The loop leaves through this corner: what follows it runs along the cut.
      out[kept - 1].label = label;
    }
    height = next;
  }
  // A loop that is only a line is cut twice at the same place.
  if (kept > 1 && out[kept - 1].x == out[0].x && out[kept - 1].y == out[0].y) --kept;
  return kept;
}

}  // namespace carom::detail

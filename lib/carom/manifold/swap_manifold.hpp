#pragma once
// The same contact, with A and B called the other way round.

#include "carom/manifold/contact_ids.hpp"
#include "carom/manifold/manifold.hpp"

namespace carom::detail {

/// Turns the normal and swaps the names; points, separations and area stay.
/// \param manifold is changed \ingroup manifold
inline void swapBodies(Manifold& manifold) {
  manifold.normal = -manifold.normal;
  for (int k = 0; k < manifold.count; ++k) {
    manifold.points[k].id = swappedId(manifold.points[k].id);
  }
}

}  // namespace carom::detail

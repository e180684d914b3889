#pragma once
// How are coordinates brought into a range in which products of them are exact?
//
// A product of doubles is exactly the sum of two doubles only if it neither overflows nor has digits
// below the smallest one. Signs of areas and volumes do not change when all coordinates are
// multiplied by a power of two, which rounds nothing.

#include <array>
#include <cmath>
#include <string>

#include "carom/core/checks.hpp"

namespace carom::detail {

/// Multiplies points by one power of two so that their largest coordinate has a given size.
/// \param points to scale
/// \param exponent of the largest coordinate afterwards, which is in [2^(exponent-1), 2^exponent)
/// \param range coordinates other than 0 must be at least 2^-range times the largest
/// \throws InvalidInput if a coordinate is not finite or too small beside the largest
/// \ingroup precision
template <std::size_t Count>
void scaleTo(std::array<Vector2, Count>& points, int exponent, int range) {
  Real largest = 0;
  for (const Vector2& p : points) {
    for (const Real x : p) {
      requireFinite(x, "coordinate");
      largest = std::max(largest, std::abs(x));
    }
  }
  if (largest == 0) return;
  const int e = std::ilogb(largest) + 1;
  for (Vector2& p : points) {
    for (Real& x : p) {
      if (x != 0 && std::ilogb(x) < e - range) {
        reject("coordinate", toText(x),
               "must be 0, or at least 2^-" + std::to_string(range) + " times the largest, " +
                   toText(largest));
      }
      x = std::scalbn(x, exponent - e);
    }
  }
}

}  // namespace carom::detail

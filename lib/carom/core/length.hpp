#pragma once
// How long is a vector, also a very long or a very short one?
//
// The square of 1e200 is infinite and the square of 1e-200 is zero, although both lengths are
// ordinary doubles. Outside the range where squares are safe the vector is first scaled by a power
// of two, which costs no digit. Eigen's stableNorm scales by the largest component, and so rounds
// where nothing had to be rounded.

#include <cmath>

#include "carom/core/real.hpp"

namespace carom {

/// The vector times a power of two such that its largest component is in [1/2, 1): the direction is
/// kept exactly, save for components 300 orders of magnitude smaller. Zero and vectors that are not
/// finite come back as they are.
/// \param v any vector [any unit]
/// \param exponent if given, receives e with v = result * 2^e
/// \return the scaled vector [1]
/// \ingroup core
Vector3 scaledToOne(const Vector3& v, int* exponent = nullptr);

/// The length |v|, without overflow or underflow on the way; error below 2 ulp.
/// \param v any vector [any unit]
/// \return its length [the same unit]; infinite only if the length itself is beyond the doubles
/// \ingroup core
inline Real length(const Vector3& v) {
  const Real squared = v.squaredNorm();
  // Between these limits no square that matters has left the range of the normal doubles.
  if (squared > 1e-250 && squared < 1e300) return std::sqrt(squared);
  int exponent = 0;
  const Real scaled = scaledToOne(v, &exponent).norm();
  return std::ldexp(scaled, exponent);
}

}  // namespace carom

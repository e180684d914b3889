#pragma once
// How many floats lie between two floats?
//
// ulp_distance.hpp for the shorter type: floats of one sign are ordered as their 32 bits are, read
// as integers. The name says float, because ulpDistance(0.1f, 0.3f) would silently compare doubles.
// In floats 0.1 + 0.2 and 0.3 are the same number.

#include <cstdint>

namespace carom {

/// The number of steps from one float to the next that lead from a to b. The source has 0.2 + 0.1
/// differ from 0.3 in 32 bits; there they are zero steps apart.
/// \erratum{8.2}
/// \param a first number, also infinite
/// \param b second number, also infinite
/// \return steps, 0 if a == b
/// \throws InvalidInput if a or b is not a number
/// \ingroup precision
std::uint32_t floatUlpDistance(float a, float b);

}  // namespace carom

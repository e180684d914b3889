#pragma once
// How many doubles lie between two doubles?
//
// An honest measure of a rounding error: 0 is the same number, 1 its neighbour, whatever their
// size. Doubles of one sign are ordered as their bits are, read as integers (IEEE 754), so the
// distance is a difference of integers once the negative ones are mirrored. +0 and -0 are one
// place.

#include <cstdint>

#include "carom/core/real.hpp"

namespace carom {

/// The number of steps from one double to the next that lead from a to b.
/// \param a first number, also infinite
/// \param b second number, also infinite
/// \return steps, 0 if a == b
/// \throws InvalidInput if a or b is not a number
/// \ingroup precision
std::uint64_t ulpDistance(Real a, Real b);

}  // namespace carom

#pragma once
// What does each digit of a search cost that never steps past a contact?
//
// Method: a gap of 1 m that closes at 1 m/s, and a bound that says it closes at no more than c
// times that. Let conservativeAdvancement search with several tolerances, and count its steps.
// Why: each step closes 1/c of the gap, so steps = log(1/tolerance) / log(c / (c - 1)), to the next
// whole number: a straight line over the logarithm of the tolerance, steep where the bound is bad.
// Source: Mirtich 1996.
// Not handled: tolerances so small that a step is lost when it is added to the time.

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// What a search took. \ingroup toi
struct AdvanceCost {
  Real tolerance = 0;  ///< gap that counts as contact [m]
  int steps = 0;       ///< advances until then
};

/// Counts the steps of conservative advancement for a gap of 1 m that closes at 1 m/s.
/// \param caution the bound on the closing speed, divided by the true one; at least 1 [1]
/// \param tolerances gaps that count as contact, each below 1 m and at least 1e-15 m times caution
/// \return one row for each tolerance, in the order given
/// \throws InvalidInput if caution is below 1 or not finite, or a tolerance out of its range
/// \ingroup toi
std::vector<AdvanceCost> advanceCost(Real caution, std::span<const Real> tolerances);

}  // namespace carom

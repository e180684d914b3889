#pragma once
// When do two polyhedra touch that turn while they move? The plain way.
//
// Method: conservative advancement with the distance by GJK. The gap cannot close faster than the
// centres approach along its normal, plus what turning can add: |w| times the distance of the
// farthest corner from the centre, for each body.
//   fastest = -n.(vB - vA) + |wA| rA + |wB| rB
// Why: it is short and safe. Why not: the farthest corner is seldom the one that hits, and the
// bound does not shrink as contact comes near, so each step closes only a part of the gap.
// first_contact.hpp is safe too and squares the gap with each step.
// Source: Mirtich, Impulse-based Dynamic Simulation, 1996, section 2.3.
// Not handled: round bodies, half-spaces.

#include <span>

#include "carom/toi/sweep.hpp"
#include "carom/toi/time_of_impact.hpp"

namespace carom {

/// The first contact of the hulls of two sets of corners that move and turn.
/// \param a corners of A, at least one [m, body A] \param A motion of A
/// \param b corners of B, at least one [m, body B] \param B motion of B
/// \param duration until when to look, zero or positive [s]
/// \param tolerance gap that counts as contact, positive [m]
/// \param maxSteps advances, after which it gives up
/// \return status, time, point, normal and gap; the time of a hit is not later than the first
///   contact, and its gap at most the tolerance. Bodies that overlap at the start have gap zero
/// \throws InvalidInput if a set is empty, a number not finite, a pose not rigid, the tolerance not
///   positive, the duration negative, or maxSteps not positive
/// \ingroup toi
TimeOfImpact toiRotating(std::span<const Vector3> a, const Sweep& A, std::span<const Vector3> b,
                         const Sweep& B, Real duration, Real tolerance, int maxSteps = 10000);

}  // namespace carom

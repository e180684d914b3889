#pragma once
// When do two solids of any kind touch for the first time, while they move and turn?
//
// Method: conservative advancement of second order. Let n be the normal at some time and s the gap
// along it. For every point of a body n . x(t) is known to second order: a straight line in time,
// less at most K t^2 / 2, where K is what turning can bend it. The least of all those lines over
// all points of a body is one support point, in a direction that leans over as time goes on:
//   n . (w x r) t + n . r = (n + t n x w) . r.
// So "the gap cannot be less than g(t)" is cheap to ask, and g is concave: where it is positive at
// both ends of an interval it is positive inside. The search steps to where g ends, asks for the
// new normal, and goes on until the gap is a rounding.
// Why it is never late: no step is made that g does not cover. Why it is fast: g touches the true
// gap to first order, so each step squares what is left; for solids that do not turn, g is exact
// along its normal, and polyhedra need as many steps as the normal changes.
// Why not the usual bound |v| + |w| r alone: it counts the fastest point of the body against the
// nearest one, so that each step closes a part of the gap only: two to four times the steps for a
// nanometre, and ever more for less. Far away it is the better one, and is asked as well.
// Source: Mirtich, Impulse-based Dynamic Simulation, 1996, for the idea and the bound of first
// order; Hairer, Nørsett and Wanner 1993, I.2, for Taylor with remainder.
// Not handled: half-spaces that turn, and a pair of them; bodies that start in touch and part at
// once are a hit at time zero.

#include "carom/detection/shapes.hpp"
#include "carom/toi/sweep.hpp"
#include "carom/toi/time_of_impact.hpp"

namespace carom {

/// What a search for the first contact has to reach. \ingroup toi
struct ContactSearch {
  Real tolerance = 0;   ///< gap that counts as contact; zero: as small as rounding allows [m]
  int maxSteps = 1000;  ///< advances, after which it gives up with ImpactStatus::kLimit
};

/// The first contact of two moving solids. Touching counts.
/// \param a usable shape of A \param A its motion
/// \param b usable shape of B \param B its motion
/// \param duration until when to look [s]
/// \param search what it has to reach
/// \return status, time, point, normal and gap. The time of a hit is never later than the first
///   contact; the gap at that time is at most the tolerance, or what rounding makes of the pair's
///   coordinates, or less than what closes within one unit in the last place of the time
/// \throws InvalidInput if a number is not finite, a pose not rigid, the duration negative, a
///   half-space turns, both are half-spaces, or a body goes further than 1e40 m or turns faster
///   than 1e40 rad/s
/// \erratum{8.6}
/// \ingroup toi
TimeOfImpact firstContact(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B,
                          Real duration, const ContactSearch& search = {});

}  // namespace carom

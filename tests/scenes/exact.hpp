#pragma once
// What should come out? The answers that the scenes are measured against.
//
// Closed forms that the library has already (a bouncing ball, a sliding block, a rolling ball, a
// free rotor) are taken from there; here are the others: balls that are hit one after the other,
// without steps, bodies that turn about an edge, by quadrature, and stones that stand, by statics.
// All in long double: 64 bits of mantissa, so that what they lose is below what a double can say.

#include <array>
#include <vector>

#include "carom/core/real.hpp"

namespace carom::scenes {

/// A hard ball without friction.
struct HardBall {
  std::array<long double, 3> x;  ///< centre [m]
  std::array<long double, 3> v;  ///< [m/s]
  long double radius;            ///< [m]
  long double mass;              ///< [kg]
};

/// What hard balls are in: walls across the axes, and gravity along -z.
struct HardRoom {
  std::array<long double, 3> low;   ///< lower walls; -infinity: none [m]
  std::array<long double, 3> high;  ///< upper walls; infinity: none [m]
  long double gravity = 0;          ///< if positive, there must be no upper wall along z [m/s^2]
};

/// Elastic balls from impact to impact: the motion between two impacts is known, so the next impact
/// is computed and the balls go there. Every pair is looked at for every impact.
/// Source: Alder and Wainwright 1959.
/// \param balls at the start; changed to those at the end
/// \param room walls and gravity \param duration [s]
/// \return number of impacts
long hardBalls(std::vector<HardBall>& balls, const HardRoom& room, long double duration);

/// A box that tips over its lower edge, standing upright at the start.
struct Tipping {
  Real height = 1;       ///< h [m]
  Real thickness = 0.2;  ///< d [m]
  Real spin = 1.2;       ///< omega0 about the edge [rad/s]
  Real gravity = 9.81;   ///< [m/s^2]
};

/// Angular velocity at an angle, from the energy:
/// omega^2 = omega0^2 + 2 g/I (h/2 (1 - cos) - d/2 sin), I = (h^2 + d^2)/3. \return [rad/s]
Real tippingSpin(const Tipping& box, Real angle);

/// Time from upright to an angle: the integral of 1/omega, which has no singularity if the box goes
/// over. \return [s]
Real tippingTime(const Tipping& box, Real angle);

/// A block that rocks from edge to edge (Housner, Bulletin of the Seismological Society of America
/// 53, 1963).
struct Rocking {
  Real halfWidth = 0.2;  ///< b [m]
  Real halfHeight = 1;   ///< h [m]
  Real gravity = 9.81;   ///< [m/s^2]
};

/// What a rocking block does that is released at an angle on one edge.
struct RockingAnswer {
  Real alpha = 0;       ///< from the vertical to the diagonal: the angle of balance [rad]
  Real impactTime = 0;  ///< when the other edge comes down [s]
  Real before = 0;      ///< angular velocity just before [rad/s]
  Real after = 0;       ///< just after: angular momentum about the new edge is kept [rad/s]
  Real nextAngle = 0;   ///< the largest on the other side [rad]
};

/// \param block its measures \param part of alpha at which it is released \return what it does
RockingAnswer rockingAnswer(const Rocking& block, Real part = 0.5);

/// What statics says of half a circle of stones without mortar that do not slide.
struct ArchAnswer {
  Real thickness = 0;  ///< the least that stands, over the radius [1]
  int joint = 0;       ///< of the haunch's hinge, counted from the crown
};

/// The thinnest arch of equal wedges that stands: the line of thrust goes through the outer edge of
/// the crown and of the springings, and must not leave the stones at the haunches (Milankovitch
/// 1907; Heyman 1966). \param stones even, at least 4 \return its thickness
ArchAnswer archAnswer(int stones);

/// The least friction with which two leaning cards stand: a horizontal force at the top holds each
/// of them, which the floor has to return. \param angle from the vertical [rad] \return [1]
Real cardFriction(Real angle);

/// What carries a pyramid whose boxes touch in the middle of where they overlap: a box rests on its
/// two quarter points and is loaded over them, so every load goes straight down.
/// \param rows at least 1 \return forces under the left and the right half of each box of the lowest
/// row, in weights of a box
std::vector<std::array<Real, 2>> pyramidLoads(int rows);

}  // namespace carom::scenes

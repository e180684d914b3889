#pragma once
// Where do the bodies of a planar world touch, and when do they next?
//
// Discs say when they will touch, by a quadratic equation. Everything else says only whether it
// touches now, by collidePlanar().

#include <vector>

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/impact_law.hpp"
#include "planar_world.hpp"

namespace carom {

/// Discs this near count as touching: they are moved to where they touch, up to rounding [m].
inline constexpr Real kTouching = 1e-9;

/// Polygons this near count as touching: as far as gravity moves a corner that nothing holds in a
/// step of 1/60 s. A smaller value makes boxes rock, a larger one makes them float [m].
inline constexpr Real kNearlyTouching = 3e-3;

/// Two bodies that touch. The walls are one more body, behind the last.
struct PlanarTouch {
  int a = 0;              ///< number of body A
  int b = 0;              ///< number of body B
  PlanarContact contact;  ///< normal from A to B, and arms
  Real separation = 0;    ///< along the normal, negative inside [m]
  ImpactLaw law;          ///< restitution and friction of the pair
};

/// Says when a disc next touches a wall or another disc, if all go straight on.
/// \param world any world \return time from now [s]; infinite if none ever does
Real timeToNextTouch(const PlanarWorld& world);

/// Finds what touches now.
/// \param world any world \return a touch for each point, in the order of the bodies
std::vector<PlanarTouch> findTouches(const PlanarWorld& world);

/// Pushes bodies apart that overlap, the lighter one further. Of a pair the deepest point counts.
/// \param world is changed \param touches what findTouches() has found
void pushApart(PlanarWorld& world, const std::vector<PlanarTouch>& touches);

}  // namespace carom

#pragma once
// Where do the bodies of a spatial world touch?
//
// Asked by collide(), with a margin: a box that is braked tilts a little, and must be held at all
// its corners all the same.

#include <vector>

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/impact_law.hpp"
#include "spatial_world.hpp"

namespace carom {

/// Bodies this near count as touching: as far as gravity moves a corner that nothing holds in a
/// step of 1/60 s. A smaller value makes boxes rock, a larger one makes them float [m].
inline constexpr Real kNearlyTouching = 3e-3;

/// Two bodies that touch at one or more points.
struct SpatialTouch {
  SpatialWorldBody* a = nullptr;  ///< body A
  SpatialWorldBody* b = nullptr;  ///< body B
  std::vector<Contact> points;    ///< all with the same normal
  Real separation = 0;            ///< of the deepest point, negative inside [m]
  ImpactLaw law;                  ///< restitution and friction of the pair
};

/// Finds what touches now.
/// \param world any world \return a touch for each pair of parts, in the order of the bodies
std::vector<SpatialTouch> findTouches(SpatialWorld& world);

/// Pushes bodies apart that overlap, the lighter one further.
/// \param world is changed
void pushApart(SpatialWorld& world);

}  // namespace carom

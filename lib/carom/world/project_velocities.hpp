#pragma once
// How does a step end exactly where contacts let it?
//
// Method: a phase looks at its contacts as they will be at its end, but where that is it only knows
// to the second power of its length. So places and velocities come off what contacts allow by a
// little in each step, and the next one begins with taking it away. That is right to the order of
// the method, but it is a memory: the first step has nothing to take away, the second less than
// the third. Ends of one, two and three steps then do not lie on one polynomial, and nothing can be
// extrapolated. So at the end of each step places are put right (project_positions.hpp), and after
// them velocities: points that are held neither part nor approach, and where friction holds they
// do not slip. Rows push and pull alike, since what is taken away is an error of either sign.
// Source: projection onto the constraints after each step of a half-explicit method: Lubich 1991;
// Hairer, Lubich and Wanner, Geometric numerical integration, IV.4.
// Not handled: what was not held at the end of the step; it is an event, or free.

#include <span>

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Puts places and velocities of an island right at the end of a step. \param state of the world,
/// all bodies of the island at the end \param bodies dynamic ones \param pairs of these
/// \param end of the step [s] \ingroup world
void projectEnd(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                Real end);

}  // namespace carom::world

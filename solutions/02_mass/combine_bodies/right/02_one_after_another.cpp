// Two bodies at a time: the reduced mass turns about the common centre.
#include "carom/core/errors.hpp"
#include "carom/mass/combine_bodies.hpp"
#include "carom/mass/parallel_axis.hpp"

namespace carom {

MassProperties combineBodies(std::span<const MassProperties> parts) {
  Real mass = 0;
  for (const MassProperties& part : parts) mass += part.mass;
  if (!(mass > 0)) throw InvalidInput("the parts weigh nothing together");
  MassProperties whole = parts[0];
  for (const MassProperties& next : parts.subspan(1)) {
    const Real both = whole.mass + next.mass;
    const Vector3 between = next.center - whole.center;
    whole.inertia =
        parallelAxis(whole.inertia + next.inertia, whole.mass * next.mass / both, between);
    whole.center += next.mass / both * between;
    whole.mass = both;
    whole.volume += next.volume;
  }
  return whole;
}

}  // namespace carom

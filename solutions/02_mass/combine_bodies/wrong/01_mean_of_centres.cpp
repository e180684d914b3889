#include "carom/mass/combine_bodies.hpp"

#include "carom/core/errors.hpp"
#include "carom/mass/parallel_axis.hpp"

namespace carom {

MassProperties combineBodies(std::span<const MassProperties> parts) {
  MassProperties whole;
  Vector3 moment = Vector3::Zero();
  for (const MassProperties& part : parts) {
    whole.volume += part.volume;
    whole.mass += part.mass;
    moment += part.center;
  }
  if (!(whole.mass > 0)) {
    throw InvalidInput("combineBodies: the parts must have a positive mass together");
  }
  whole.center = moment / static_cast<Real>(parts.size());

  for (const MassProperties& part : parts) {
    whole.inertia += parallelAxis(part.inertia, part.mass, part.center - whole.center);
  }
  return whole;
}

}  // namespace carom

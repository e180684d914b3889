#include "carom/mass/combine_bodies.hpp"

#include <cmath>
#include <string>

#include "carom/core/errors.hpp"
#include "carom/mass/parallel_axis.hpp"

namespace carom {

MassProperties combineBodies(std::span<const MassProperties> parts) {
  MassProperties whole;
  Vector3 moment = Vector3::Zero();
  for (const MassProperties& part : parts) {
    whole.volume += part.volume;
    whole.mass += part.mass;
    moment += part.mass * part.center;
  }
  if (!(whole.mass > 0) || !std::isfinite(whole.mass)) {
    throw InvalidInput("combineBodies: the parts must have a positive mass together, but " +
                       std::to_string(parts.size()) + " parts weigh " + std::to_string(whole.mass) +
                       " kg");
  }
  whole.center = moment / whole.mass;

  // Inertias add only about one and the same point.
  for (const MassProperties& part : parts) {
    whole.inertia += parallelAxis(part.inertia, part.mass, part.center - whole.center);
  }
  return whole;
}

}  // namespace carom

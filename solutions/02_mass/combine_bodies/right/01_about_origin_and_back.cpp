// Everything about the origin first, then back to the common centre.
#include "carom/mass/combine_bodies.hpp"

#include "carom/core/errors.hpp"

namespace carom {

MassProperties combineBodies(std::span<const MassProperties> parts) {
  const auto point = [](const Vector3& d) -> Matrix3 {
    return d.squaredNorm() * Matrix3::Identity() - d * d.transpose();
  };
  MassProperties whole;
  for (const auto& part : parts) {
    whole.mass += part.mass;
    whole.volume += part.volume;
    whole.center += part.mass * part.center;
    whole.inertia += part.inertia + part.mass * point(part.center);
  }
  if (!(whole.mass > 0)) throw InvalidInput("the parts weigh nothing together");
  whole.center /= whole.mass;
  whole.inertia -= whole.mass * point(whole.center);
  return whole;
}

}  // namespace carom

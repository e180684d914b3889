#pragma once
// Can a solid be weighed by throwing darts?
//
// Method: draw points in the bounding box, keep those inside the solid (a ray upwards crosses the
// skin once more outwards than inwards), and take sums over them: volume = box volume times the
// share of hits, centre = mean, inertia = mean of |r|² E - r rᵀ times the mass.
// Why: needs nothing but a test "inside?", so it works for solids without a mesh, and it checks the
// exact way by another road. The price: the error falls as 1/√N, a hundred times the points for one
// more digit.
// Source: the source text's method 2. Steiner's theorem is not what makes the tensor; the sum is.
// Not handled: speed (every point meets every triangle); points that lie exactly on the skin.

#include <cstdint>

#include "carom/core/real.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// An estimate of mass properties and how far to trust it. \ingroup mass
struct MonteCarloMass {
  MassProperties body;  ///< the estimate, as massProperties() gives it
  int samples = 0;      ///< points drawn in the bounding box
  int inside = 0;       ///< points that fell into the solid
  Real relativeError =
      0;  ///< expected standard deviation of volume / volume: √((1-p)/(pN)), p = inside/N
};

/// Estimates the mass properties of a closed mesh from random points.
/// \param mesh a closed surface that looks outwards [m]
/// \param density mass per volume, positive [kg/m^3]
/// \param samples number of points, positive
/// \param seed of the generator; the same seed gives the same answer on every machine
/// \return the estimate; all zero but `samples` if no point fell inside
/// \throws InvalidInput if the mesh is unusable (requireUsable()), or samples or density is not
/// positive
/// \erratum{3.4} \ingroup mass
MonteCarloMass monteCarloMass(const TriangleMesh& mesh, Real density, int samples,
                              std::uint64_t seed);

}  // namespace carom

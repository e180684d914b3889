#include "carom/mass/mass_properties.hpp"

#include <cmath>
#include <string>

#include "carom/core/errors.hpp"
#include "carom/core/variant.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mesh_bounds.hpp"
#include "carom/mass/quick_mesh_check.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom/mass/tetrahedron_sums.hpp"

namespace carom {
namespace {

void requireDensity(Real density) {
  if (!(density > 0) || !std::isfinite(density)) {
    throw InvalidInput("massProperties: density must be positive and finite, but is " +
                       std::to_string(density));
  }
}

// The way of the chapter, and of a program in which a student's functions replace the library's.
MassProperties plainMassProperties(const TriangleMesh& mesh, Real density) {
  MassProperties body;
  body.volume = signedVolume(mesh);
  body.mass = density * body.volume;
  body.center = centerOfMass(mesh);
  body.inertia = inertiaTensor(mesh, density);
  return body;
}

// The common corner of all tetrahedra, and the size of the box around the mesh.
struct Place {
  Vector3 origin;
  Real boxVolume = 0;
};

Place placeOf(const TriangleMesh& mesh) {
  const auto [low, high] = boundsOf(mesh);
  // The middle of the box, rounded to a coarse power of two: then differences of vertices to it are
  // exact or nearly so, wherever the mesh is, and a mesh around the world's origin is not moved at
  // all.
  const Vector3 size = high - low;
  const Real grid = std::ldexp(Real(1), std::ilogb(size.maxCoeff()));
  Place place;
  for (int k = 0; k < 3; ++k) {
    place.origin[k] = std::nearbyint((low[k] / 2 + high[k] / 2) / grid) * grid;
  }
  place.boxVolume = size.x() * size.y() * size.z();
  return place;
}

Real rounded(Real number) {
  return number;
}
Real rounded(const DoubleDouble& number) {
  return number.value();
}

// From the sums about `origin` to the solid about its own centre. S carries the digits that the
// shift cancels.
template <class S>
MassProperties bodyFrom(const TetrahedronSums<S>& sums, const Vector3& origin, Real density) {
  // Centre relative to the origin; the sums are 6 V, 24 V r and 120 ∫ r rᵀ.
  const S x = sums.x / (Real(4) * sums.v);
  const S y = sums.y / (Real(4) * sums.v);
  const S z = sums.z / (Real(4) * sums.v);
  const S twentyV = Real(20) * sums.v;
  const S xx = sums.xx - twentyV * x * x;
  const S yy = sums.yy - twentyV * y * y;
  const S zz = sums.zz - twentyV * z * z;
  const S xy = sums.xy - twentyV * x * y;
  const S yz = sums.yz - twentyV * y * z;
  const S zx = sums.zx - twentyV * z * x;

  MassProperties body;
  body.volume = rounded(sums.v) / 6;
  body.mass = density * body.volume;
  body.center = {rounded(origin.x() + x), rounded(origin.y() + y), rounded(origin.z() + z)};
  // clang-format off
  body.inertia << rounded(yy + zz), -rounded(xy),     -rounded(zx),
                  -rounded(xy),     rounded(xx + zz), -rounded(yz),
                  -rounded(zx),     -rounded(yz),     rounded(xx + yy);
  // clang-format on
  body.inertia *= density / 120;
  return body;
}

}  // namespace

MassProperties massProperties(const TriangleMesh& mesh, Real density) {
  requireDensity(density);
  if (takesPlainPath() || !isClearlyGood(mesh)) {
    const std::vector<MeshProblem> problems = checkMesh(mesh);
    if (!problems.empty()) throw InvalidInput("massProperties: " + problems.front().message);
  }
  return massPropertiesOfGoodMesh(mesh, density);
}

MassProperties massPropertiesOfGoodMesh(const TriangleMesh& mesh, Real density) {
  requireDensity(density);
  if (mesh.triangles.empty() || mesh.vertices.empty()) requireUsable(mesh);

  MassProperties body;
  if (takesPlainPath()) {
    body = plainMassProperties(mesh, density);
  } else {
    const Place place = placeOf(mesh);
    body = bodyFrom(sumTetrahedra(mesh, place.origin), place.origin, density);
    // Thin solids cancel; so does a volume that rounding made negative.
    if (!(body.volume > kThinSolid * place.boxVolume)) {
      body = bodyFrom(sumTetrahedraExactly(mesh, place.origin), place.origin, density);
    }
  }
  if (!(body.volume > 0) || !std::isfinite(body.volume) || !body.center.allFinite() ||
      !body.inertia.allFinite()) {
    requireUsable(mesh);
    throw InvalidInput("massProperties: the mesh has no positive finite volume, but " +
                       std::to_string(body.volume) + " m^3");
  }
  return body;
}

}  // namespace carom

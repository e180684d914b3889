#pragma once
// The sums behind massProperties(): over the tetrahedra that a common corner spans with each
// triangle.
//
// Two ways with the same formulas, both on four triangles side by side. The quick one runs in
// blocks and adds the sums of blocks with compensation. The exact one computes with twice the
// digits, in 15 times the time.
// Source: Tonon 2004; compensation after Knuth and Ogita, Rump and Oishi 2005.
// Not handled: meshes that are not closed. This header is for the library and its tests.

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {

/// Integrals over a solid about a common corner, each times a factor that keeps the formulas free
/// of division.
/// \tparam S the number they are held in
/// \ingroup mass
template <class S>
struct TetrahedronSums {
  S v{};   ///< 6 times the volume [m^3]
  S x{};   ///< 24 times ∫ x dV [m^4]
  S y{};   ///< 24 times ∫ y dV [m^4]
  S z{};   ///< 24 times ∫ z dV [m^4]
  S xx{};  ///< 120 times ∫ x² dV [m^5]
  S yy{};  ///< 120 times ∫ y² dV [m^5]
  S zz{};  ///< 120 times ∫ z² dV [m^5]
  S xy{};  ///< 120 times ∫ x y dV [m^5]
  S yz{};  ///< 120 times ∫ y z dV [m^5]
  S zx{};  ///< 120 times ∫ z x dV [m^5]
};

/// The sums in double, compensated: a few units in the last place of the largest tetrahedra.
/// \param mesh a closed mesh with at least one triangle [m]
/// \param origin the common corner; near the mesh [m]
/// \return the sums about origin
/// \throws InvalidInput if an index names no vertex
/// \ingroup mass
TetrahedronSums<Real> sumTetrahedra(const TriangleMesh& mesh, const Vector3& origin);

/// The same sums with about 32 digits, for solids whose tetrahedra cancel against each other.
/// \param mesh a closed mesh with at least one triangle [m]
/// \param origin the common corner [m]
/// \return the sums about origin
/// \throws InvalidInput if an index names no vertex
/// \ingroup mass
TetrahedronSums<DoubleDouble> sumTetrahedraExactly(const TriangleMesh& mesh, const Vector3& origin);

}  // namespace carom

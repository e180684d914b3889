#pragma once
// Other libraries that weigh meshes, each behind one function, so that the suite knows nothing of
// their types. Each lives in a shared library of its own: they are compiled with their own flags,
// and what they inline must not be mixed with ours.

#include <functional>

#include "carom/mass/mass_properties.hpp"

#define CAROM_PEER __attribute__((visibility("default")))

namespace carom::bench {

/// libigl's igl::moments. Copying the mesh into its matrices is not timed.
/// \return a call that weighs the mesh
CAROM_PEER std::function<MassProperties()> libiglMoments(const TriangleMesh& mesh);

/// CGAL's PMP::volume with numbers that are exact. \return a call that gives the volume
CAROM_PEER std::function<Real()> cgalExactVolume(const TriangleMesh& mesh);

/// CGAL's PMP::volume with doubles. \return a call that gives the volume
CAROM_PEER std::function<Real()> cgalInexactVolume(const TriangleMesh& mesh);

/// Distance from the exact values of a mesh.
struct MassErrors {
  Real volume = 0;   ///< relative
  Real center = 0;   ///< relative to the longest side of the box around the mesh
  Real inertia = 0;  ///< relative to its largest entry
};

/// Weighs a mesh in rational numbers.
/// \return a function that says how far from that an answer is
CAROM_PEER std::function<MassErrors(const MassProperties&)> exactJudge(const TriangleMesh& mesh);

}  // namespace carom::bench

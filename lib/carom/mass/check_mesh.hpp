#pragma once
// Is this mesh the skin of a solid at all?
//
// Method: look at vertices and indices first, then at each triangle, then at edges: in a closed
// skin whose triangles all look outwards, two neighbours run along their common edge in opposite
// directions, so every directed edge occurs once and its reverse once. Last, the volume must be
// positive.
// Why first: the volume integral gives a number for every input, right or not. An open mesh gives
// another number for every choice of origin, a flipped one a negative mass, and both would only be
// noticed much later, as a body that accelerates against the force.
// Source: Mäntylä 1988 on manifold surfaces. Each stage runs only if the stages before it found
// nothing, since their problems would show up again as others.
// Not handled: surfaces that cut themselves (exact arithmetic is needed: the oracle test and CGAL
// do it), and a cavity that should have been reversed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// What can be wrong with a mesh. \ingroup mass
enum class MeshProblemKind {
  empty,               ///< no triangles
  notANumber,          ///< a coordinate is infinite or not a number
  indexOutOfRange,     ///< a triangle names a vertex that does not exist
  degenerateTriangle,  ///< a corner twice, or three corners on a line: no area
  openEdge,            ///< an edge with a triangle on one side only: a hole
  nonManifoldEdge,     ///< an edge with more than two triangles
  partlyFlipped,       ///< two neighbours that look to opposite sides
  flipped              ///< the whole mesh looks inwards: its volume is not positive
};

/// One problem of a mesh and where it is. Numbers count from zero; -1 where one does not apply.
/// \ingroup mass
struct MeshProblem {
  MeshProblemKind kind = MeshProblemKind::empty;  ///< what is wrong
  std::int32_t vertex = -1;                       ///< the vertex, if the problem is one of a vertex
  std::int32_t triangle = -1;                     ///< the triangle, or the first one at the edge
  std::array<std::int32_t, 2> edge = {-1, -1};    ///< the edge, from vertex to vertex
  std::string message;                            ///< a sentence that names the place and the rule
};

/// The name of a kind as a short phrase, e.g. "open edge".
/// \param kind the kind
/// \return the phrase
/// \ingroup mass
const char* nameOf(MeshProblemKind kind);

/// At most this many problems are listed: a broken file can have millions. \ingroup mass
inline constexpr std::size_t kMaxMeshProblems = 100;

/// Looks for everything that would make the volume integrals meaningless.
/// \param mesh any mesh, however broken
/// \return the problems found, empty for a good mesh; at most kMaxMeshProblems, in ascending order
/// of triangles or edges
/// \ingroup mass
std::vector<MeshProblem> checkMesh(const TriangleMesh& mesh);

}  // namespace carom

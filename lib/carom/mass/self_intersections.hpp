#pragma once
// Does a surface cut or touch itself?
//
// A closed and evenly oriented surface can still pass through itself: every edge is in order, and
// the part that is inside twice counts twice. No formula for the volume notices.
// Method: a tree of boxes over the triangles, ordered along a space-filling curve (Morton 1966),
// leaves the pairs that are near each other. A pair is decided by the signs of determinants alone
// (after Guigue and Devillers, Journal of Graphics Tools 8(1), 2003): on which side of a triangle's
// plane the other's corners are, and whether an edge passes through it. The signs are exact
// (orientation()), so there is no tolerance, and no pair is missed or invented by rounding.
// Neighbours may meet at the corners they share and nowhere else.
// Why exact: neighbours always touch. With rounding they would nearly all be called crossing, or a
// tolerance would have to be chosen, and every choice is wrong for some mesh.
// Measured (g++ 12 -O3): 1 to 2 us a triangle on curved surfaces, up to 20 on turned flat ones.
// Not handled: a fan of very many triangles round one corner, all of whose pairs are near each
// other; triangles without area (checkMesh() finds them); two vertices in one place are two
// vertices, so triangles that meet there without sharing a number touch.

#include <cstddef>
#include <vector>

#include "carom/mass/mesh_problem.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// Two triangles of a mesh. \ingroup mass
struct TrianglePair {
  std::int32_t first = 0;   ///< the smaller number
  std::int32_t second = 0;  ///< the larger number

  /// Same two triangles. \param other the other pair \return whether both numbers agree
  bool operator==(const TrianglePair& other) const = default;
};

/// Pairs of triangles that have a point in common beyond the corners and edges that they share.
/// \param mesh without triangles that have no area
/// \param most at most this many pairs are looked for: two copies of a mesh in one place have as
/// many pairs as triangles, and more
/// \return the pairs, in ascending order; empty for a surface that neither cuts nor touches itself
/// \throws InvalidInput if the mesh is unusable (requireUsable()), or if its coordinates are
/// further apart in size than orientation() can take
/// \ingroup mass
std::vector<TrianglePair> selfIntersections(const TriangleMesh& mesh,
                                            std::size_t most = kMaxMeshProblems);

/// The same as problems of the mesh.
/// \param mesh as for selfIntersections()
/// \return a problem for each pair found, naming both triangles; at most kMaxMeshProblems
/// \throws InvalidInput as selfIntersections()
/// \ingroup mass
std::vector<MeshProblem> checkSelfIntersections(const TriangleMesh& mesh);

/// Whether two triangles have a point in common beyond the corners that they share.
/// \param mesh the mesh of both
/// \param first number of a triangle
/// \param second number of another triangle
/// \return true if they cut or touch each other
/// \throws InvalidInput as orientation()
/// \ingroup mass
bool trianglesMeet(const TriangleMesh& mesh, std::int32_t first, std::int32_t second);

}  // namespace carom

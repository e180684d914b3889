#pragma once
// If a skin is in several pieces, does each of them look to the right side?
//
// A hollow solid has two: the outer one looks outwards, the cavity's looks into the cavity, so its
// own volume is negative. Seen alone, both orientations of a closed piece are possible; what is
// right depends on where it lies.
// Method: pieces are found by joining the corners of each triangle (union-find). For each piece the
// winding number of all others around one of its vertices says how often that place is inside the
// solid already. A piece with a positive volume must lie outside of the solid, 0; one with a
// negative volume inside, 1. The winding number is the sum of the solid angles of triangles over 4
// pi (van Oosterom and Strackee, IEEE Transactions on Biomedical Engineering 30, 1983), which needs
// no ray that might hit an edge.
// Why: a cavity that looks outwards adds to the volume what it should take away, and every edge of
// the mesh is in order all the same.
// Not handled: pieces that cut each other (self_intersections.hpp), and a piece whose vertices all
// lie on another one: they are passed over.

#include <vector>

#include "carom/mass/mesh_problem.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// The piece that each triangle belongs to: two triangles with a common vertex are of one piece.
/// \ingroup mass
struct MeshPieces {
  std::vector<std::int32_t> pieceOf;  ///< by triangle: number of its piece, counted from zero
  std::int32_t count = 0;             ///< how many pieces there are
};

/// Finds the pieces of a mesh, in the order of their first triangles.
/// \param mesh any mesh
/// \return the pieces
/// \throws InvalidInput if the mesh is unusable (requireUsable())
/// \ingroup mass
MeshPieces piecesOf(const TriangleMesh& mesh);

/// Looks for pieces that look to the wrong side.
/// \param mesh closed and evenly oriented: checkMesh() calls this last
/// \return a problem for each such piece, naming its first triangle; at most kMaxMeshProblems
/// \throws InvalidInput if the mesh is unusable (requireUsable())
/// \ingroup mass
std::vector<MeshProblem> checkPieces(const TriangleMesh& mesh);

}  // namespace carom

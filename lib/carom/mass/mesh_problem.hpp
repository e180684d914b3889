#pragma once
// What can be wrong with a mesh, and where.
//
// Method: a problem is a kind, a place, and a sentence for people.
// Why: a program decides by the kind, a person by the sentence; neither has to read the other.
// Source: none needed.
// Not handled: repair.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

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
  flipped,             ///< the whole mesh looks inwards: its volume is not positive
  flippedPiece,        ///< one of several pieces looks to the wrong side, e.g. a cavity outwards
  selfIntersection     ///< two triangles cut or touch each other where they should not
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

}  // namespace carom

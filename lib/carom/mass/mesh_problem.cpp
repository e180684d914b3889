#include "carom/mass/mesh_problem.hpp"

namespace carom {

const char* nameOf(MeshProblemKind kind) {
  switch (kind) {
    case MeshProblemKind::empty:
      return "empty";
    case MeshProblemKind::notANumber:
      return "not a number";
    case MeshProblemKind::indexOutOfRange:
      return "index out of range";
    case MeshProblemKind::degenerateTriangle:
      return "degenerate triangle";
    case MeshProblemKind::openEdge:
      return "open edge";
    case MeshProblemKind::nonManifoldEdge:
      return "non-manifold edge";
    case MeshProblemKind::partlyFlipped:
      return "partly flipped";
    case MeshProblemKind::flipped:
      return "flipped";
    case MeshProblemKind::flippedPiece:
      return "flipped piece";
    case MeshProblemKind::selfIntersection:
      return "self-intersection";
  }
  return "unknown problem";
}

}  // namespace carom

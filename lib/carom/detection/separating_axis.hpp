#pragma once
// The answer of the separating-axis tests.
//
// Two convex bodies are apart exactly if their shadows on some axis leave a gap, and for polygons
// and polyhedra it is enough to try the axes on which a face of their Minkowski difference can lie:
// the normals of the faces of both, and in space the cross products of one edge of each. The axis
// with the largest signed gap is the answer for all three cases: it separates, or it is the
// direction of the least displacement.
// For bodies that are apart the gap on the best axis is at most their distance: equal if a face or
// a pair of crossing edges is nearest, less if a corner is. distances come from GJK.

#include <utility>

#include "carom/core/real.hpp"
#include "carom/detection/verdict.hpp"

namespace carom {

/// What an axis of a separating-axis test is made of.
/// \ingroup detection
enum class AxisKind {
  faceOfA,  ///< normal of a face (in the plane: an edge) of A
  faceOfB,  ///< normal of a face (in the plane: an edge) of B
  edges,    ///< cross product of an edge of A and an edge of B
};

/// The axis on which two convex bodies are farthest apart, or overlap least.
/// \ingroup detection
struct SeparatingAxis {
  Verdict verdict = Verdict::overlapping;  ///< apart, touching or overlapping
  Real separation = 0;                     ///< gap on the axis; negative: depth of the overlap [m]
  Vector3 axis = Vector3::UnitZ();         ///< unit, from A to B [1, world]; planar: z = 0
  AxisKind kind = AxisKind::faceOfA;       ///< what the axis is made of
  int featureA = -1;  ///< number of A's face or edge (of a box: of its axis); -1: none
  int featureB = -1;  ///< number of B's face or edge (of a box: of its axis); -1: none
};

/// The verdict that belongs to a signed gap.
/// \param separation gap on the best axis, or distance [m]
/// \return separated above zero, touching at zero, overlapping below
/// \ingroup detection
inline Verdict verdictOf(Real separation) {
  if (separation > 0) return Verdict::separated;
  return separation < 0 ? Verdict::overlapping : Verdict::touching;
}

/// The same answer when A and B are called the other way round.
/// \param answer for (A, B) \return the answer for (B, A) \ingroup detection
inline SeparatingAxis swapped(SeparatingAxis answer) {
  answer.axis = -answer.axis;
  std::swap(answer.featureA, answer.featureB);
  if (answer.kind != AxisKind::edges) {
    answer.kind = answer.kind == AxisKind::faceOfA ? AxisKind::faceOfB : AxisKind::faceOfA;
  }
  return answer;
}

/// Which of two faces that look at each other is taken where gap and area tie: the one whose
/// outward normal scores higher. The direction is like no other, so that rounding does not decide
/// between bodies that stand straight on each other, as the order of their positions would.
/// \param normal outward unit normal [1, world]
/// \return score; opposite normals have opposite ones
/// \ingroup detection
inline Real tieScore(const Vector3& normal) {
  return normal.dot(Vector3(0.3127, 0.5431, 0.7793));
}

/// Axes whose gaps differ by less than this, relative to the size of the bodies, are equally good:
/// a few hundred roundings. Then a face wins over a pair of edges, so that a body that lies flat is
/// held at all its corners, and not at one crossing of edges that rounding chose.
/// \ingroup detection
inline constexpr Real kAxisTie = 1e-12;

}  // namespace carom

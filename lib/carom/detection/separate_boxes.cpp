#include "carom/detection/separate_boxes.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/variant.hpp"
#include "carom/detection/box_axes.hpp"
#include "carom/detection/exact_vector.hpp"
#include "carom/detection/sat_boxes.hpp"

namespace carom {
namespace {

using detail::BoxAxis;
using detail::BoxPair;

// The gap of two boxes on an axis, times the axis's length: no rounding at all.
struct ExactGap {
  ExactNumber scaled;
  Vector3 axis;
};

ExactGap exactGap(const BoxPair& pair, int axisNumber) {
  std::array<ExactVector, 3> a, b;
  for (int k = 0; k < 3; ++k) {
    a[k] = exact(pair.A->R_WB.col(k));
    b[k] = exact(pair.B->R_WB.col(k));
  }
  // Normals of the faces are cross products of the other two edges: the columns of a rounded
  // rotation matrix are not quite at right angles.
  ExactVector axis;
  if (axisNumber < 3) {
    axis = cross(a[(axisNumber + 1) % 3], a[(axisNumber + 2) % 3]);
  } else if (axisNumber < 6) {
    axis = cross(b[(axisNumber + 1) % 3], b[(axisNumber + 2) % 3]);
  } else {
    axis = cross(a[(axisNumber - 6) / 3], b[(axisNumber - 6) % 3]);
  }
  ExactNumber gap = absolute(dot(exact(pair.B->p_WB) - exact(pair.A->p_WB), axis));
  for (int k = 0; k < 3; ++k) {
    gap = gap - ExactNumber(pair.hA[k]) * absolute(dot(a[k], axis));
    gap = gap - ExactNumber(pair.hB[k]) * absolute(dot(b[k], axis));
  }
  return {gap, rounded(axis)};
}

// Only axes whose gap may be zero or positive can decide; the largest of their exact gaps does.
Real decideExactly(const BoxPair& pair, Real size, Real approximate) {
  const Vector3 onA = detail::gapsOnA(pair);
  const Vector3 onB = detail::gapsOnB(pair);
  const Real rounding = detail::kEdgeRounding * size;
  bool found = false;
  Real best = approximate;
  for (int k = 0; k < 15; ++k) {
    Real bound = 0;  // no gap is larger than this
    if (k < 6) {
      bound = (k < 3 ? onA[k] : onB[k - 3]) + rounding;
    } else {
      // Taken anew in world coordinates, where small sines keep their digits; parallel edges go
      // on to the exact numbers, for which an axis of length zero shows a gap of zero.
      const Vector3 axis =
          cross(Vector3(pair.A->R_WB.col((k - 6) / 3)), Vector3(pair.B->R_WB.col((k - 6) % 3)));
      const Real sine = axis.norm();
      bound = detail::gapOn(pair, axis) + rounding;
      if (sine == 0) continue;
    }
    if (bound < 0) continue;
    const ExactGap gap = exactGap(pair, k);
    const Real length = gap.axis.norm();
    if (length == 0) continue;
    const Real value = gap.scaled.value() / length;
    if (!found || value > best) best = value;
    found = true;
  }
  return best;
}

SeparatingAxis separateOrdered(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  const BoxPair pair = detail::boxPair(a, A, b, B);
  const BoxAxis best = detail::bestBoxAxis(pair, std::numeric_limits<Real>::infinity());
  SeparatingAxis result;
  result.separation = best.separation;
  result.axis = detail::worldAxis(pair, best.axis);
  if (best.axis < 3) {
    result.kind = AxisKind::faceOfA;
    result.featureA = best.axis;
  } else if (best.axis < 6) {
    result.kind = AxisKind::faceOfB;
    result.featureB = best.axis - 3;
  } else {
    result.kind = AxisKind::edges;
    result.featureA = (best.axis - 6) / 3;
    result.featureB = (best.axis - 6) % 3;
  }
  // Far from the origin the difference of positions rounds by an ulp of the coordinates at most.
  const Real size = detail::sizeOf(pair) + pair.t.cwiseAbs().sum();
  if (std::abs(best.separation) <= detail::kEdgeRounding * size) {
    result.separation = decideExactly(pair, size, best.separation);
  }
  result.verdict = verdictOf(result.separation);
  return result;
}

}  // namespace

SeparatingAxis separateBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  if (takesPlainPath()) return satBoxes(a, A, b, B);
  if (detail::comesSecond(a, A, b, B)) return swapped(separateOrdered(b, B, a, A));
  return separateOrdered(a, A, b, B);
}

bool witnessSeparates(const Box& a, const Pose& A, const Box& b, const Pose& B, Real margin,
                      const WitnessAxis& witness) {
  const int axis = witness.axis;
  const Vector3 between = B.p_WB - A.p_WB;
  // Within rounding of the margin the search for the best axis has the word, not the witness.
  const Real size = a.halfExtents.sum() + b.halfExtents.sum() + between.cwiseAbs().sum();
  const Real rounding = detail::kEdgeRounding * size;
  if (axis < 3) {
    const Vector3 n = A.R_WB.col(axis);
    const Vector3 onB = B.R_WB.transpose() * n;
    return std::abs(between.dot(n)) - a.halfExtents[axis] - b.halfExtents.dot(onB.cwiseAbs()) >
           margin + rounding;
  }
  if (axis < 6) {
    const Vector3 n = B.R_WB.col(axis - 3);
    const Vector3 onA = A.R_WB.transpose() * n;
    return std::abs(between.dot(n)) - b.halfExtents[axis - 3] - a.halfExtents.dot(onA.cwiseAbs()) >
           margin + rounding;
  }
  const int i = (axis - 6) / 3, j = (axis - 6) % 3;
  const Vector3 n = cross(A.R_WB.col(i), B.R_WB.col(j));
  const Vector3 onA = A.R_WB.transpose() * n;
  const Vector3 onB = B.R_WB.transpose() * n;
  const Real gap = std::abs(between.dot(n)) - a.halfExtents.dot(onA.cwiseAbs()) -
                   b.halfExtents.dot(onB.cwiseAbs());
  // Of length sine, so the margin is scaled; a sine near zero only shows rounding.
  const Real sine = n.norm();
  return sine > detail::kParallelSine && gap > margin * sine + rounding;
}

bool boxesAreApart(const Box& a, const Pose& A, const Box& b, const Pose& B, Real margin,
                   WitnessAxis& witness) {
  if (takesPlainPath()) return satBoxes(a, A, b, B).separation > margin;
  if (witness.axis >= 0 && witnessSeparates(a, A, b, B, margin, witness)) return true;
  const BoxPair pair = detail::boxPair(a, A, b, B);
  const BoxAxis best = detail::bestBoxAxis(pair, margin);
  witness.axis = best.separation > margin ? best.axis : -1;
  return best.separation > margin;
}

}  // namespace carom

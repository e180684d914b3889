#pragma once
// The fifteen axes of two boxes, fast and to the last digits.
//
// Method: everything in the frame of A, where A's normals are unit vectors: with R = R_AB and t =
// p_AB the gaps on the normals are sums of |R_ij| (Gottschalk, Lin and Manocha 1996), and the nine
// cross products have two entries of R each. All fifteen gaps are computed without a branch; then
// the largest wins by one rule that knows neither history nor the order of the arguments.
// Nearly parallel edges: their cross product is a difference of nearly equal numbers and shows the
// rounding of R, magnified by 1/sine. Where that could change the answer the product is taken anew
// from the columns of both matrices with error-free products (Dekker 1971); then its direction is
// right to rounding, and so is the gap.
// Why a header of its own: the test for separation and the maker of manifolds share it.
// Not handled: the exact sign within rounding of touching; separateBoxes() adds that.

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/real.hpp"
#include "carom/core/two_sum.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/detection/shapes.hpp"

namespace carom::detail {

/// A pair of boxes as A sees it. \ingroup detection
struct BoxPair {
  Matrix3 R;                ///< rotation of B in the frame of A
  Matrix3 absR;             ///< its entries without their signs
  Vector3 t;                ///< B's centre [m, frame of A]
  Vector3 tB;               ///< the same vector in the frame of B [m]
  Vector3 hA;               ///< half extents of A [m]
  Vector3 hB;               ///< half extents of B [m]
  const Pose* A = nullptr;  ///< pose of A
  const Pose* B = nullptr;  ///< pose of B
};

/// The frame of A, in which all axes are tried.
/// \param a first box \param A its pose \param b second box \param B its pose
/// \return the pair; it points to the poses
/// \ingroup detection
inline BoxPair boxPair(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  BoxPair pair;
  pair.R.noalias() = A.R_WB.transpose() * B.R_WB;
  pair.absR = pair.R.cwiseAbs();
  pair.hA = a.halfExtents;
  pair.hB = b.halfExtents;
  // The positions are subtracted before anything is turned: far from the origin their digits go.
  const Vector3 between = B.p_WB - A.p_WB;
  pair.t.noalias() = A.R_WB.transpose() * between;
  pair.tB.noalias() = B.R_WB.transpose() * between;
  pair.A = &A;
  pair.B = &B;
  return pair;
}

/// The best axis of two boxes. \ingroup detection
struct BoxAxis {
  Real separation = 0;  ///< largest signed gap [m]
  Real faceGap = 0;     ///< largest gap on a face normal [m]
  int axis = 0;         ///< 0-2 normal of A, 3-5 normal of B, 6 + 3 i + j edges i and j
  int face = 0;         ///< best face: 0-2 of A, 3-5 of B
};

/// Length of both boxes' half diagonals together, roughly: what roundings are measured by.
/// \param pair the boxes \return sum of all half extents [m] \ingroup detection
inline Real sizeOf(const BoxPair& pair) {
  return pair.hA.sum() + pair.hB.sum();
}

/// Gaps on the normals of A. \param pair the boxes \return three signed gaps [m]
/// \ingroup detection
inline Vector3 gapsOnA(const BoxPair& pair) {
  return pair.t.cwiseAbs() - pair.hA - pair.absR * pair.hB;
}

/// Gaps on the normals of B. \param pair the boxes \return three signed gaps [m]
/// \ingroup detection
inline Vector3 gapsOnB(const BoxPair& pair) {
  return pair.tB.cwiseAbs() - pair.hB - pair.absR.transpose() * pair.hA;
}

/// Sines below this are recomputed from the columns if they matter. \ingroup detection
inline constexpr Real kSmallSine = 0.125;
/// Edges at a smaller sine are parallel. \ingroup detection
inline constexpr Real kParallelSine = 1e-15;
/// A gap that never is the largest [m]. \ingroup detection
inline constexpr Real kNoGap = 1e300;
/// No gap on a cross product is off by more than this times the size over the sine: 16 roundings of
/// numbers below the size, doubled. \ingroup detection
inline constexpr Real kEdgeRounding = 32 * 1.1102230246251565e-16;

/// x y - z w with one rounding of the result, for nearly equal products.
/// \param x first factor \param y second factor \param z third factor \param w fourth factor
/// \return the difference \ingroup detection
inline Real differenceOfProducts(Real x, Real y, Real z, Real w) {
  const TwoProduct first = twoProduct(x, y);
  const TwoProduct second = twoProduct(z, w);
  const TwoSum difference = twoSum(first.product, -second.product);
  return difference.sum + (difference.error + (first.error - second.error));
}

/// The unit cross product of an edge of A with one of B in world coordinates, every component right
/// to a few roundings also for nearly parallel edges; sign not fixed.
/// \param A pose of A \param i edge of A \param B pose of B \param j edge of B
/// \return unit vector [1, world] \ingroup detection
inline Vector3 edgeAxis(const Pose& A, int i, const Pose& B, int j) {
  const Vector3 a = A.R_WB.col(i);
  const Vector3 b = B.R_WB.col(j);
  const Vector3 plain = cross(a, b);
  const Real square = plain.squaredNorm();
  if (square >= kSmallSine * kSmallSine) return plain / std::sqrt(square);
  const Vector3 axis(differenceOfProducts(a.y(), b.z(), a.z(), b.y()),
                     differenceOfProducts(a.z(), b.x(), a.x(), b.z()),
                     differenceOfProducts(a.x(), b.y(), a.y(), b.x()));
  return axis / axis.norm();
}

/// The gap on a unit axis given in world coordinates. \param pair the boxes
/// \param axis unit [1, world] \return signed gap [m] \ingroup detection
inline Real gapOn(const BoxPair& pair, const Vector3& axis) {
  const Vector3 between = pair.B->p_WB - pair.A->p_WB;
  const Vector3 onA = pair.A->R_WB.transpose() * axis;
  const Vector3 onB = pair.B->R_WB.transpose() * axis;
  return std::abs(between.dot(axis)) - pair.hA.dot(onA.cwiseAbs()) - pair.hB.dot(onB.cwiseAbs());
}

/// The nine gaps on cross products, first quickly; those whose rounding could matter then exactly.
/// \param pair the boxes \param size sizeOf(pair)
/// \param toBeat gaps at or below this need not be exact [m]
/// \return gap of edges i and j at 3 i + j; -kNoGap where it cannot win [m] \ingroup detection
inline std::array<Real, 9> gapsOnEdges(const BoxPair& pair, Real size, Real toBeat) {
  std::array<Real, 9> gaps;
  std::array<Real, 9> squares;
  const Matrix3& R = pair.R;
  const Matrix3& Q = pair.absR;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const Real between = std::abs(pair.t[i2] * R(i1, j) - pair.t[i1] * R(i2, j));
      const Real onA = pair.hA[i1] * Q(i2, j) + pair.hA[i2] * Q(i1, j);
      const Real onB = pair.hB[j1] * Q(i, j2) + pair.hB[j2] * Q(i, j1);
      squares[3 * i + j] = R(i1, j) * R(i1, j) + R(i2, j) * R(i2, j);
      gaps[3 * i + j] = between - (onA + onB);
    }
  }
  // Parallel edges divide by more than nothing, and are corrected below.
  Real smallest = 1;
  for (int k = 0; k < 9; ++k) {
    smallest = std::min(smallest, squares[k]);
    gaps[k] /= std::sqrt(std::max(squares[k], kParallelSine * kParallelSine));
  }
  if (smallest < kSmallSine * kSmallSine) {
    for (int k = 0; k < 9; ++k) {
      if (squares[k] >= kSmallSine * kSmallSine) continue;
      const Real sine = std::sqrt(squares[k]);
      // No better than a face by more than a turn by the angle between the edges would make it;
      // if that is less than a tie, the face is taken anyway, unless the verdict hangs on it.
      const bool face = 2 * sine * size <= kAxisTie * size && std::abs(toBeat) > kAxisTie * size;
      if (face || sine <= kParallelSine || gaps[k] + kEdgeRounding * size / sine <= toBeat) {
        gaps[k] = -kNoGap;
        continue;
      }
      gaps[k] = gapOn(pair, edgeAxis(*pair.A, k / 3, *pair.B, k % 3));
    }
  }
  return gaps;
}

/// Chooses the best of six faces: of those within a tie of the best axis the largest; of equally
/// large ones of both bodies that with the higher tieScore(), of one body the first.
/// \param pair the boxes \param onA gaps on A's normals \param onB gaps on B's normals
/// \param threshold smallest gap that still ties [m] \return 0-2 of A, 3-5 of B
/// \ingroup detection
inline int bestFace(const BoxPair& pair, const Vector3& onA, const Vector3& onB, Real threshold) {
  const auto largest = [threshold](const Vector3& gaps, const Vector3& h, Real& area) {
    int best = -1;
    area = 0;
    for (int k = 0; k < 3; ++k) {
      const Real size = h[(k + 1) % 3] * h[(k + 2) % 3];
      if (gaps[k] < threshold || !(size > area * (1 + kAxisTie))) continue;
      area = size;
      best = k;
    }
    return best;
  };
  Real areaA, areaB;
  const int a = largest(onA, pair.hA, areaA), b = largest(onB, pair.hB, areaB);
  if (b < 0) return a;
  if (a < 0) return b + 3;
  if (std::abs(areaA - areaB) > kAxisTie * areaA) return areaA > areaB ? a : b + 3;
  // Outward of A is towards B, outward of B away from where A sees it.
  const Real scoreA = tieScore(pair.A->R_WB.col(a)) * (pair.t[a] < 0 ? -1 : 1);
  const Real scoreB = tieScore(pair.B->R_WB.col(b)) * (pair.tB[b] < 0 ? 1 : -1);
  return scoreA >= scoreB ? a : b + 3;
}

/// The best of the fifteen axes. \param pair the boxes
/// \param enough the search may end with any gap on a face normal above this; such an answer is
///   above it, but need not be the largest [m]
/// \return the best axis \ingroup detection
inline BoxAxis bestBoxAxis(const BoxPair& pair, Real enough) {
  const Vector3 onA = gapsOnA(pair);
  const Vector3 onB = gapsOnB(pair);
  BoxAxis best;
  best.faceGap = std::max(onA.maxCoeff(), onB.maxCoeff());
  const Real size = sizeOf(pair);
  const Real tie = kAxisTie * size;
  best.face = bestFace(pair, onA, onB, best.faceGap - tie);
  best.separation = best.face < 3 ? onA[best.face] : onB[best.face - 3];
  best.axis = best.face;
  if (best.faceGap > enough) return best;

  const std::array<Real, 9> gaps = gapsOnEdges(pair, size, best.faceGap);
  Real largest = gaps[0];
  for (int k = 1; k < 9; ++k) largest = std::max(largest, gaps[k]);
  // A gap that separates is never given up for a face that does not.
  if (largest > best.faceGap + tie || (largest > 0 && best.faceGap <= 0)) {
    int k = 0;
    while (gaps[k] < largest - tie) ++k;
    best.axis = 6 + k;
    best.separation = gaps[k];
  }
  return best;
}

/// The unit axis of a choice, from A to B. \param pair the boxes \param axis number of the axis
/// \return unit vector [1, world] \ingroup detection
inline Vector3 worldAxis(const BoxPair& pair, int axis) {
  const Pose& A = *pair.A;
  const Pose& B = *pair.B;
  if (axis < 3) return pair.t[axis] < 0 ? Vector3(-A.R_WB.col(axis)) : Vector3(A.R_WB.col(axis));
  if (axis < 6) {
    const int j = axis - 3;
    return pair.tB[j] < 0 ? Vector3(-B.R_WB.col(j)) : Vector3(B.R_WB.col(j));
  }
  const Vector3 unit = edgeAxis(A, (axis - 6) / 3, B, (axis - 6) % 3);
  return unit.dot(B.p_WB - A.p_WB) < 0 ? Vector3(-unit) : unit;
}

/// The number of an axis when A and B are called the other way round.
/// \param axis number \return its number for the swapped pair \ingroup detection
inline int swappedAxis(int axis) {
  if (axis < 6) return axis < 3 ? axis + 3 : axis - 3;
  return 6 + 3 * ((axis - 6) % 3) + (axis - 6) / 3;
}

/// Whether the pair is to be treated as (B, A), so that swapping the arguments swaps the answer to
/// the last bit: by pose, then by size.
/// \param a first box \param A its pose \param b second box \param B its pose
/// \return true if b comes first \ingroup detection
inline bool comesSecond(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  if (const int order = comparePoses(A, B); order != 0) return order > 0;
  for (int k = 0; k < 3; ++k) {
    if (a.halfExtents[k] != b.halfExtents[k]) return a.halfExtents[k] > b.halfExtents[k];
  }
  return false;
}

}  // namespace carom::detail

#pragma once
// The truth about two boxes, in quadruple precision: all fifteen axes, every product and sum with
// 33 digits. Slow and without any cleverness, so that it shares no idea with what it judges.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"

namespace carom_test {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
using Quad = long double;
#endif

using QuadVector = std::array<Quad, 3>;

inline Quad quadAbs(Quad a) {
  return a < 0 ? -a : a;
}

inline Quad quadSqrt(Quad a) {
  if (!(a > 0)) return 0;
  // Heron's rule doubles the digits each time: 16, 32, 64.
  Quad root = std::sqrt(static_cast<double>(a));
  for (int i = 0; i < 3; ++i) root = (root + a / root) / 2;
  return root;
}

inline Quad quadDot(const QuadVector& a, const QuadVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline QuadVector quadCross(const QuadVector& a, const QuadVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline QuadVector column(const carom::Matrix3& m, int k) {
  return {m(0, k), m(1, k), m(2, k)};
}

// One axis: its gap, and its direction from A to B.
struct TrueAxis {
  double gap = 0;
  carom::Vector3 normal = carom::Vector3::Zero();
};

// All axes, best first. Cross products of edges whose sine is below 1e-15 are left out.
inline std::vector<TrueAxis> trueAxes(const carom::Box& a, const carom::Pose& A,
                                      const carom::Box& b, const carom::Pose& B) {
  std::vector<QuadVector> directions;
  for (int k = 0; k < 3; ++k) directions.push_back(column(A.R_WB, k));
  for (int k = 0; k < 3; ++k) directions.push_back(column(B.R_WB, k));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) directions.push_back(quadCross(directions[i], directions[3 + j]));
  }
  QuadVector between;
  for (int k = 0; k < 3; ++k) between[k] = Quad(B.p_WB[k]) - Quad(A.p_WB[k]);
  std::vector<TrueAxis> axes;
  for (const QuadVector& direction : directions) {
    const Quad length = quadSqrt(quadDot(direction, direction));
    if (length < Quad(1e-15)) continue;
    const Quad along = quadDot(between, direction);
    Quad gap = quadAbs(along);
    for (int k = 0; k < 3; ++k) {
      gap -= Quad(a.halfExtents[k]) * quadAbs(quadDot(column(A.R_WB, k), direction));
      gap -= Quad(b.halfExtents[k]) * quadAbs(quadDot(column(B.R_WB, k), direction));
    }
    TrueAxis axis;
    axis.gap = static_cast<double>(gap / length);
    for (int k = 0; k < 3; ++k) {
      axis.normal[k] = static_cast<double>((along < 0 ? -direction[k] : direction[k]) / length);
    }
    axes.push_back(axis);
  }
  std::stable_sort(axes.begin(), axes.end(),
                   [](const TrueAxis& x, const TrueAxis& y) { return x.gap > y.gap; });
  return axes;
}

// The smallest angle that changes the one unit vector to the other [degrees], right also for tiny
// angles.
inline double degreesBetween(const carom::Vector3& a, const carom::Vector3& b) {
  const double half = (a - b).norm() / 2;
  return 2 * std::asin(std::min(1.0, half)) * 57.29577951308232;
}

}  // namespace carom_test

#include "carom/detection/segment_segment.hpp"

#include <limits>

#include "carom/core/cross.hpp"

namespace carom {

Vector3 closestOnSegment(const Vector3& point, const Vector3& a, const Vector3& b) {
  const Vector3 edge = b - a;
  const Real fromA = (point - a).dot(edge), fromB = (b - point).dot(edge);
  if (!(fromA > 0)) return a;
  if (!(fromB > 0)) return b;
  // From the nearer end, so that the rounding error goes with the shorter way.
  const Real whole = edge.squaredNorm();
  return fromA < fromB ? Vector3(a + (fromA / whole) * edge) : Vector3(b - (fromB / whole) * edge);
}

SegmentPair closestPoints(const Vector3& a0, const Vector3& a1, const Vector3& b0,
                          const Vector3& b1) {
  SegmentPair best{a0, b0, std::numeric_limits<Real>::infinity(), false, false};
  const auto tryPair = [&](const Vector3& onA, const Vector3& onB) {
    const Real squared = (onB - onA).squaredNorm();
    if (!(squared <= best.squared)) return;  // of equals the later, which is more often inside
    best = {onA, onB, squared, onA != a0 && onA != a1, onB != b0 && onB != b1};
  };
  tryPair(a0, closestOnSegment(a0, b0, b1));
  tryPair(a1, closestOnSegment(a1, b0, b1));
  tryPair(closestOnSegment(b0, a0, a1), b0);
  tryPair(closestOnSegment(b1, a0, a1), b1);

  // Both inside: the gap is square to u and v. By cross products, whose error grows with one over
  // the sine, not its square.
  const Vector3 u = a1 - a0, v = b1 - b0, r = b0 - a0;
  const Vector3 n = cross(u, v);
  const Real nn = n.squaredNorm();
  const Real s = cross(r, v).dot(n), t = cross(r, u).dot(n);
  if (s > 0 && s < nn && t > 0 && t < nn) tryPair(a0 + (s / nn) * u, b0 + (t / nn) * v);
  return best;
}

Vector3 closestOnTriangle(const Vector3& point, const Vector3& a, const Vector3& b,
                          const Vector3& c) {
  const Vector3 u = b - a, v = c - a, r = point - a;
  const Vector3 n = cross(u, v);
  const Real nn = n.squaredNorm();
  const Real ofB = cross(r, v).dot(n), ofC = cross(u, r).dot(n);
  if (ofB >= 0 && ofC >= 0 && ofB + ofC <= nn && nn > 0) return point - (r.dot(n) / nn) * n;
  Vector3 best = closestOnSegment(point, a, b);
  for (const Vector3& other : {closestOnSegment(point, b, c), closestOnSegment(point, c, a)}) {
    if ((point - other).squaredNorm() < (point - best).squaredNorm()) best = other;
  }
  return best;
}

}  // namespace carom

#include "carom/manifold/collide_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/variant.hpp"
#include "carom/detection/box_axes.hpp"
#include "carom/detection/separate_boxes.hpp"
#include "carom/manifold/clip_loop.hpp"
#include "carom/manifold/feature_name.hpp"
#include "carom/manifold/loop_manifold.hpp"
#include "carom/manifold/plain_manifold.hpp"
#include "carom/manifold/swap_manifold.hpp"

namespace carom {
namespace {

using detail::BoxAxis;
using detail::BoxPair;
using detail::ClipCorner;
using detail::nameOf;

// Two faces closer than this to the normal (8 degrees) are clipped although edges cross.
constexpr Real kNearlyFlat = 0.99;

// Names of a box's features, from the signs of its axes.
constexpr std::uint32_t faceName(int axis, Real sign) {
  return nameOf(FeatureKind::face, 2 * axis + (sign > 0 ? 1 : 0));
}
// The edge along an axis; of `corner`, bit k of which is set where axis k is positive, the bit of
// the axis itself does not count.
constexpr std::uint32_t edgeName(int axis, int corner) {
  return nameOf(FeatureKind::edge, 8 * axis + (corner & ~(1 << axis)));
}

std::uint32_t idOf(bool referenceIsFirst, std::uint32_t reference, std::uint32_t incident) {
  return referenceIsFirst ? (reference << 16) | incident : (incident << 16) | reference;
}

// Clips the face of the incident box that looks at the reference face, and fills the manifold.
// `face` is 0-2 for A, 3-5 for B; `normal` points from A to B; `alongFace` says that it is that
// face's own, and then there is a point.
void fillFromFaces(const BoxPair& pair, int face, const Vector3& normal, bool alongFace, Real limit,
                   Manifold& manifold) {
  const bool ofA = face < 3;
  const int r = ofA ? face : face - 3;
  const int k1 = (r + 1) % 3, k2 = (r + 2) % 3;
  const Pose& pose = ofA ? *pair.A : *pair.B;
  const Vector3& h = ofA ? pair.hA : pair.hB;
  const Vector3& hi = ofA ? pair.hB : pair.hA;
  // The incident box in the frame of the reference box: columns of R_AB, or of its transpose.
  const Matrix3 M = ofA ? pair.R : Matrix3(pair.R.transpose());
  const Vector3 place = ofA ? pair.t : Vector3(-pair.tB);
  const Real side = ofA ? (pair.t[r] < 0 ? -1 : 1) : (pair.tB[r] < 0 ? 1 : -1);

  // The incident face looks against the normal as much as any; equal ones: the first.
  int j = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(M(r, k)) > std::abs(M(r, j)) + kAxisTie) j = k;
  }
  const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  const Real towards = M(r, j) * side > 0 ? -1 : 1;

  // Its centre and half edges in the reference plane (x, y) and above it.
  const Vector3 center = place + towards * hi[j] * M.col(j);
  const Vector3 half1 = hi[j1] * M.col(j1), half2 = hi[j2] * M.col(j2);
  ClipCorner c{center[k1], center[k2], side * center[r] - h[r], 0};
  ClipCorner e1{half1[k1], half1[k2], side * half1[r], 0};
  ClipCorner e2{half2[k1], half2[k2], side * half2[r], 0};
  const Vector3 out = ofA ? normal : Vector3(-normal);
  if (!alongFace) {
    // Linear, so what moves a corner moves centre and half edges.
    const detail::Shear shear(side * pose.R_WB.col(r), pose.R_WB.col(k1), pose.R_WB.col(k2), out);
    c = shear(c);
    e1 = shear(e1);
    e2 = shear(e2);
  }
  ClipCorner first[12];
  first[0] = {c.x + e1.x + e2.x, c.y + e1.y + e2.y, c.height + e1.height + e2.height, 0};
  first[1] = {c.x - e1.x + e2.x, c.y - e1.y + e2.y, c.height - e1.height + e2.height, 1};
  first[2] = {c.x - e1.x - e2.x, c.y - e1.y - e2.y, c.height - e1.height - e2.height, 2};
  first[3] = {c.x + e1.x - e2.x, c.y + e1.y - e2.y, c.height + e1.height - e2.height, 3};
  ClipCorner second[12];
  ClipCorner* loop = first;
  ClipCorner* spare = second;
  int count = 4;

  // Cut by the sides of the rectangle that it reaches beyond.
  const Real wide = std::abs(e1.x) + std::abs(e2.x), high = std::abs(e1.y) + std::abs(e2.y);
  const Real hx = h[k1], hy = h[k2];
  const Real snap = kAxisTie * detail::sizeOf(pair);
  const auto cut = [&](int label, const auto& value) {
    count = detail::clipLoop(loop, count, label, value, snap, spare);
    std::swap(loop, spare);
  };
  if (c.x + wide > hx + snap) cut(4, [hx](const ClipCorner& p) { return p.x - hx; });
  if (c.y + high > hy + snap) cut(5, [hy](const ClipCorner& p) { return p.y - hy; });
  if (c.x - wide < -hx - snap) cut(6, [hx](const ClipCorner& p) { return -p.x - hx; });
  if (c.y - high < -hy - snap) cut(7, [hy](const ClipCorner& p) { return -p.y - hy; });

  // A corner is named by the edges that meet in it.
  const int incidentBase = towards > 0 ? 1 << j : 0;
  const int incidentCorner[4] = {incidentBase | 1 << j1 | 1 << j2, incidentBase | 1 << j2,
                                 incidentBase, incidentBase | 1 << j1};
  const int referenceBase = side > 0 ? 1 << r : 0;
  const int referenceCorner[4] = {referenceBase | 1 << k1 | 1 << k2, referenceBase | 1 << k2,
                                  referenceBase, referenceBase | 1 << k1};
  const auto name = [&](int before, int after) -> std::uint32_t {
    if (before < 4 && after < 4) {
      return idOf(ofA, faceName(r, side), nameOf(FeatureKind::vertex, incidentCorner[after]));
    }
    if (before >= 4 && after >= 4) {
      // Between sides x = hx and y = hy, y = hy and x = -hx, and so on.
      const int corner = (before - 4 == 0 && after - 4 == 3) || (before - 4 == 3 && after - 4 == 0)
                             ? 3
                             : std::min(before, after) - 4;
      return idOf(ofA, nameOf(FeatureKind::vertex, referenceCorner[corner]), faceName(j, towards));
    }
    const int incident = std::min(before, after), reference = std::max(before, after) - 4;
    // Edge i of the loop runs from its corner i along the first or second half edge; side 0 of the
    // rectangle runs through its corners 3 and 0 along y.
    return idOf(ofA, edgeName(reference % 2 == 0 ? k2 : k1, referenceCorner[reference]),
                edgeName(incident % 2 == 0 ? j1 : j2, incidentCorner[incident]));
  };
  const detail::ReferencePlane plane{pose.p_WB + side * h[r] * pose.R_WB.col(r), pose.R_WB.col(k1),
                                     pose.R_WB.col(k2), out};
  detail::fillFromLoop(plane, loop, count, limit, name, manifold);
  if (manifold.count > 0 || !alongFace) return;

  // Two corners that just meet: rounding has cut the deepest one off. It is put back.
  const Real sign1[4] = {1, -1, -1, 1}, sign2[4] = {1, 1, -1, -1};
  int deepest = 0;
  for (int k = 1; k < 4; ++k) {
    const Real lower = sign1[k] * e1.height + sign2[k] * e2.height;
    if (lower < sign1[deepest] * e1.height + sign2[deepest] * e2.height) deepest = k;
  }
  const Real s1 = sign1[deepest], s2 = sign2[deepest];
  const ClipCorner corner{std::clamp(c.x + s1 * e1.x + s2 * e2.x, -hx, hx),
                          std::clamp(c.y + s1 * e1.y + s2 * e2.y, -hy, hy),
                          c.height + s1 * e1.height + s2 * e2.height, deepest};
  detail::fillFromLoop(plane, &corner, 1, corner.height, name, manifold);
}

// The point where edge i of A crosses edge j of B.
void fillFromEdges(const BoxPair& pair, int i, int j, const Vector3& normal, Manifold& manifold) {
  const Pose& A = *pair.A;
  const Pose& B = *pair.B;
  // The edges that are farthest towards each other.
  const Vector3 onA = A.R_WB.transpose() * normal;
  const Vector3 onB = B.R_WB.transpose() * normal;
  Vector3 cornerA, cornerB;
  int bitsA = 0, bitsB = 0;
  for (int k = 0; k < 3; ++k) {
    cornerA[k] = k == i ? 0 : (onA[k] > 0 ? pair.hA[k] : -pair.hA[k]);
    cornerB[k] = k == j ? 0 : (onB[k] > 0 ? -pair.hB[k] : pair.hB[k]);
    if (k != i && onA[k] > 0) bitsA |= 1 << k;
    if (k != j && onB[k] <= 0) bitsB |= 1 << k;
  }
  // Both relative to A's centre; s and t are measured from the middles of the edges.
  const Vector3 middleA = A.R_WB * cornerA;
  const Vector3 middleB = (B.p_WB - A.p_WB) + B.R_WB * cornerB;
  const Vector3 a = A.R_WB.col(i), b = B.R_WB.col(j);
  const Vector3 between = middleB - middleA;
  const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
  const Real cosine = pair.R(i, j);
  const Real square = pair.R(i1, j) * pair.R(i1, j) + pair.R(i2, j) * pair.R(i2, j);
  const Real along = between.dot(a), across = between.dot(b);
  const Real s = std::clamp((along - cosine * across) / square, -pair.hA[i], pair.hA[i]);
  const Real t = std::clamp((cosine * along - across) / square, -pair.hB[j], pair.hB[j]);
  const Vector3 pointA = middleA + s * a;
  const Vector3 pointB = middleB + t * b;

  manifold.count = 1;
  manifold.points[0].position = A.p_WB + (pointA + pointB) / 2;
  manifold.points[0].separation = (pointB - pointA).dot(normal);
  manifold.points[0].id = (edgeName(i, bitsA) << 16) | edgeName(j, bitsB);
  manifold.area = 0;
  manifold.areaCentroid = manifold.points[0].position;
}

void collideOrdered(const BoxPair& pair, const BoxAxis& best, Real margin, Manifold& manifold) {
  manifold.normal = detail::worldAxis(pair, best.axis);
  // Corners within rounding of the deepest one count also where a margin of zero would drop them.
  const Real limit = std::max(margin, best.separation + kAxisTie * detail::sizeOf(pair));
  if (best.axis < 6) {
    fillFromFaces(pair, best.axis, manifold.normal, true, limit, manifold);
    return;
  }
  const Pose& A = *pair.A;
  const Pose& B = *pair.B;
  const Real flatA = (A.R_WB.transpose() * manifold.normal).cwiseAbs().maxCoeff();
  const Real flatB = (B.R_WB.transpose() * manifold.normal).cwiseAbs().maxCoeff();
  if (flatA > kNearlyFlat && flatB > kNearlyFlat) {
    const int f = best.face;
    const Vector3 faceNormal = f < 3 ? A.R_WB.col(f) : B.R_WB.col(f - 3);
    if (std::abs(faceNormal.dot(manifold.normal)) > kNearlyFlat) {
      fillFromFaces(pair, f, manifold.normal, false, limit, manifold);
      if (manifold.count > 0) return;
    }
  }
  fillFromEdges(pair, (best.axis - 6) / 3, (best.axis - 6) % 3, manifold.normal, manifold);
}

// Apart from the fast way, which would otherwise make room for two hulls on every call.
[[gnu::noinline]] Manifold plainly(const Box& a, const Pose& A, const Box& b, const Pose& B,
                                   Real margin) {
  return plainManifold(boxHull(a.halfExtents), A, boxHull(b.halfExtents), B, margin);
}

}  // namespace

Manifold collideBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B,
                      ManifoldCache* cache, Real margin) {
  if (takesPlainPath()) return plainly(a, A, b, B, margin);
  Manifold manifold;
  WitnessAxis witness;
  if (cache != nullptr && cache->axis >= 0) {
    witness.axis = cache->axis;
    if (witnessSeparates(a, A, b, B, margin, witness)) return manifold;
  }
  const bool swap = detail::comesSecond(a, A, b, B);
  const BoxPair pair = swap ? detail::boxPair(b, B, a, A) : detail::boxPair(a, A, b, B);
  const BoxAxis best = detail::bestBoxAxis(pair, margin);
  const bool apart = best.separation > margin;
  if (cache != nullptr)
    cache->axis = !apart ? -1 : swap ? detail::swappedAxis(best.axis) : best.axis;
  if (apart) return manifold;
  collideOrdered(pair, best, margin, manifold);
  if (swap) detail::swapBodies(manifold);
  return manifold;
}

}  // namespace carom

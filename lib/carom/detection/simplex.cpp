#include "carom/detection/simplex.hpp"

#include <algorithm>
#include <limits>

#include "carom/core/cross.hpp"

namespace carom {
namespace {

template <int Dim>
using Nearest = detail::NearestPoint<Dim>;

template <int Dim>
const auto& at(const Simplex<Dim>& simplex, int i) {
  return simplex.vertices[static_cast<std::size_t>(i)].difference;
}

// Each function below looks at one face of the simplex and takes its nearest point over as the best
// if it is nearer than the best so far. (Returning candidates and comparing them reads no better and
// copies a hundred bytes per face.)

template <int Dim>
void tryPoint(const Simplex<Dim>& simplex, int i, Nearest<Dim>& best) {
  const Real squared = at(simplex, i).squaredNorm();
  if (!(squared < best.squared)) return;
  best.point = at(simplex, i);
  best.squared = squared;
  best.corners[0] = i;
  best.weights[0] = 1;
  best.count = 1;
}

template <int Dim>
void trySegment(const Simplex<Dim>& simplex, int i, int j, Nearest<Dim>& best) {
  const Eigen::Matrix<Real, Dim, 1>&a = at(simplex, i), &b = at(simplex, j);
  const Eigen::Matrix<Real, Dim, 1> edge = b - a;
  // Lengths along the edge from the origin's foot to each end.
  const Real ofA = b.dot(edge), ofB = -a.dot(edge);
  if (!(ofB > 0)) return tryPoint(simplex, i, best);
  if (!(ofA > 0)) return tryPoint(simplex, j, best);
  const Real one = 1 / edge.squaredNorm();
  // From the nearer end, so that the rounding error goes with the shorter way, and with weights that
  // add to one: for a short edge far from the origin the two ratios by themselves would not.
  const bool nearA = ofA > ofB;
  const Real wa = nearA ? 1 - ofB * one : ofA * one;
  const Real wb = nearA ? ofB * one : 1 - wa;
  Eigen::Matrix<Real, Dim, 1> point = b - wa * edge;
  if (nearA) point = a + wb * edge;
  const Real squared = point.squaredNorm();
  if (!(squared < best.squared)) return;
  best.point = point;
  best.squared = squared;
  best.corners[0] = i;
  best.corners[1] = j;
  best.weights[0] = wa;
  best.weights[1] = wb;
  best.count = 2;
}

// Below this sine an angle of a triangle (or the relative volume of a tetrahedron) is no judge of on
// which side the origin lies: rounding has eaten half of its digits.
constexpr Real kFlat = 0x1p-26;

void tryTriangle(const Simplex<3>& simplex, int i, int j, int k, Nearest<3>& best) {
  const Vector3 &a = at(simplex, i), &b = at(simplex, j), &c = at(simplex, k);
  const Vector3 u = a - c, v = b - c;
  const Vector3 normal = cross(u, v);
  const Real whole = normal.squaredNorm();
  // Areas over the edges opposite to a and b, of the origin's shadow on the plane.
  const Real ofA = normal.dot(cross(v, c)), ofB = normal.dot(cross(c, u));
  const Real ofC = whole - ofA - ofB;
  // Its smallest height against its sides, and against the coordinates, whose rounding error the
  // sides carry: on curved bodies GJK ends with triangles a millionth of the body in size.
  const Real longest = std::max(u.squaredNorm(), v.squaredNorm());
  const bool flat = !(whole > kFlat * kFlat * longest * std::max(longest, c.squaredNorm()));
  if (ofA > 0 && ofB > 0 && ofC > 0) {
    const Real one = 1 / whole;
    const Real wa = ofA * one, wb = ofB * one, wc = ofC * one;
    // Mixed from the corners, and not projected onto the plane: the normal of a thin triangle leans,
    // and its projection would be nearer than any point of the triangle is.
    const Vector3 point = wa * a + wb * b + wc * c;
    const Real squared = point.squaredNorm();
    if (squared < best.squared) {
      best.point = point;
      best.squared = squared;
      best.corners = {i, j, k, 0};
      best.weights = {wa, wb, wc, 0};
      best.count = 3;
    }
    if (!flat) return;
  }
  // A flat triangle is its edges, whatever the signs of its areas.
  if (flat || !(ofA > 0)) trySegment(simplex, j, k, best);
  if (flat || !(ofB > 0)) trySegment(simplex, i, k, best);
  if (flat || !(ofC > 0)) trySegment(simplex, i, j, best);
}

void tryTetrahedron(const Simplex<3>& simplex, Nearest<3>& best) {
  const Vector3& d = at(simplex, 3);
  const Vector3 a = at(simplex, 0) - d, b = at(simplex, 1) - d, c = at(simplex, 2) - d;
  const Vector3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const Real whole = a.dot(bc);
  // Volumes over the faces opposite to the corners, with the sign that makes the whole positive.
  const Real sign = whole < 0 ? -1 : 1;
  const Real ofA = -sign * d.dot(bc), ofB = -sign * d.dot(ca), ofC = -sign * d.dot(ab);
  const Real ofD = sign * whole - ofA - ofB - ofC;
  // As for triangles: against its sides, and the height over its largest side against rounding.
  constexpr Real kRounding = 0x1p-46;
  const Real largest = std::max({bc.squaredNorm(), ca.squaredNorm(), ab.squaredNorm()});
  const Real sides = kFlat * kFlat * a.squaredNorm() * b.squaredNorm() * c.squaredNorm();
  const Real rounding = kRounding * kRounding * largest * d.squaredNorm();
  const bool flat = !(whole * whole > std::max(sides, rounding));
  const bool inside = ofA > 0 && ofB > 0 && ofC > 0 && ofD > 0;
  if (!inside || flat) {
    if (flat || !(ofA > 0)) tryTriangle(simplex, 1, 2, 3, best);
    if (flat || !(ofB > 0)) tryTriangle(simplex, 0, 2, 3, best);
    if (flat || !(ofC > 0)) tryTriangle(simplex, 0, 1, 3, best);
    if (flat || !(ofD > 0)) tryTriangle(simplex, 0, 1, 2, best);
  }
  if (!inside) return;
  std::array<Real, 4> weights{};
  if (flat) {
    // The ratios of volumes are noise, but the nearest face is near.
    for (int n = 0; n < best.count; ++n) {
      const auto from = static_cast<std::size_t>(n);
      weights[static_cast<std::size_t>(best.corners[from])] = best.weights[from];
    }
  } else {
    const Real one = 1 / (sign * whole);
    weights = {ofA * one, ofB * one, ofC * one, ofD * one};
  }
  best.point.setZero();
  best.squared = 0;
  best.corners = {0, 1, 2, 3};
  best.weights = weights;
  best.count = 4;
}

// In the plane a triangle is the full simplex.
void tryTriangle(const Simplex<2>& simplex, Nearest<2>& best) {
  const auto turn = [](const Vector2& p, const Vector2& q) {
    return p.x() * q.y() - p.y() * q.x();
  };
  const Vector2& c = at(simplex, 2);
  const Vector2 a = at(simplex, 0) - c, b = at(simplex, 1) - c;
  const Real whole = turn(a, b);
  const Real sign = whole < 0 ? -1 : 1;
  const Real ofA = sign * turn(b, c), ofB = sign * turn(c, a), ofC = sign * whole - ofA - ofB;
  if (ofA > 0 && ofB > 0 && ofC > 0) {
    const Real one = 1 / (sign * whole);
    best.point.setZero();
    best.squared = 0;
    best.corners = {0, 1, 2};
    best.weights = {ofA * one, ofB * one, ofC * one};
    best.count = 3;
    return;
  }
  if (!(ofA > 0)) trySegment(simplex, 1, 2, best);
  if (!(ofB > 0)) trySegment(simplex, 0, 2, best);
  if (!(ofC > 0)) trySegment(simplex, 0, 1, best);
}

}  // namespace

namespace detail {

template <>
void nearestToOrigin(const Simplex<2>& simplex, NearestPoint<2>& nearest) {
  nearest.squared = std::numeric_limits<Real>::infinity();
  if (simplex.count == 1) return tryPoint(simplex, 0, nearest);
  if (simplex.count == 2) return trySegment(simplex, 0, 1, nearest);
  tryTriangle(simplex, nearest);
}

template <>
void nearestToOrigin(const Simplex<3>& simplex, NearestPoint<3>& nearest) {
  nearest.squared = std::numeric_limits<Real>::infinity();
  if (simplex.count == 1) return tryPoint(simplex, 0, nearest);
  if (simplex.count == 2) return trySegment(simplex, 0, 1, nearest);
  if (simplex.count == 3) return tryTriangle(simplex, 0, 1, 2, nearest);
  tryTetrahedron(simplex, nearest);
}

}  // namespace detail
}  // namespace carom

#include "carom/detection/simplex.hpp"

#include <algorithm>
#include <limits>

#include "carom/core/cross.hpp"

namespace carom {
namespace {

// The nearest point of one face: its corners, their weights, and how far it is.
template <int Dim>
struct Nearest {
  Eigen::Matrix<Real, Dim, 1> point;
  Real squared = std::numeric_limits<Real>::infinity();
  std::array<int, Dim + 1> corners{};
  std::array<Real, Dim + 1> weights{};
  int count = 0;
};

template <int Dim>
const auto& at(const Simplex<Dim>& simplex, int i) {
  return simplex.vertices[static_cast<std::size_t>(i)].difference;
}

template <int Dim>
Nearest<Dim> onPoint(const Simplex<Dim>& simplex, int i) {
  return {at(simplex, i), at(simplex, i).squaredNorm(), {i}, {1}, 1};
}

template <int Dim>
Nearest<Dim> onSegment(const Simplex<Dim>& simplex, int i, int j) {
  const Eigen::Matrix<Real, Dim, 1>&a = at(simplex, i), &b = at(simplex, j);
  const Eigen::Matrix<Real, Dim, 1> edge = b - a;
  // Lengths along the edge from the origin's foot to each end.
  const Real ofA = b.dot(edge), ofB = -a.dot(edge);
  if (!(ofB > 0)) return onPoint(simplex, i);
  if (!(ofA > 0)) return onPoint(simplex, j);
  const Real whole = edge.squaredNorm();
  const Real wa = ofA / whole, wb = ofB / whole;
  // From the nearer end, so that the rounding error goes with the shorter way.
  const Eigen::Matrix<Real, Dim, 1> point =
      wa > wb ? (a + wb * edge).eval() : (b - wa * edge).eval();
  return {point, point.squaredNorm(), {i, j}, {wa, wb}, 2};
}

template <int Dim>
void keepNearer(Nearest<Dim>& best, const Nearest<Dim>& other) {
  if (other.squared < best.squared) best = other;
}

// Below this sine an angle of a triangle (or the relative volume of a tetrahedron) is no judge of on
// which side the origin lies: rounding has eaten half of its digits.
constexpr Real kFlat = 0x1p-26;

Nearest<3> onTriangle(const Simplex<3>& simplex, int i, int j, int k) {
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
  Nearest<3> best;
  if (ofA > 0 && ofB > 0 && ofC > 0) {
    const std::array<Real, 4> weights = {ofA / whole, ofB / whole, ofC / whole};
    // Mixed from the corners, and not projected onto the plane: the normal of a thin triangle leans,
    // and its projection would be nearer than any point of the triangle is.
    const Vector3 point = weights[0] * a + weights[1] * b + weights[2] * c;
    best = {point, point.squaredNorm(), {i, j, k}, weights, 3};
    if (!flat) return best;
  }
  // A flat triangle is its edges, whatever the signs of its areas.
  if (flat || !(ofA > 0)) keepNearer(best, onSegment(simplex, j, k));
  if (flat || !(ofB > 0)) keepNearer(best, onSegment(simplex, i, k));
  if (flat || !(ofC > 0)) keepNearer(best, onSegment(simplex, i, j));
  return best;
}

Nearest<3> onTetrahedron(const Simplex<3>& simplex) {
  const Vector3& d = at(simplex, 3);
  const Vector3 a = at(simplex, 0) - d, b = at(simplex, 1) - d, c = at(simplex, 2) - d;
  const Vector3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const Real whole = a.dot(bc);
  // Volumes over the faces opposite to the corners, with the sign that makes the whole positive.
  const Real sign = whole < 0 ? -1 : 1;
  const Real ofA = -sign * d.dot(bc), ofB = -sign * d.dot(ca), ofC = -sign * d.dot(ab);
  const Real one = sign * whole, ofD = one - ofA - ofB - ofC;
  // As for triangles: against its sides, and the height over its largest side against rounding.
  constexpr Real kRounding = 0x1p-46;
  const Real largest = std::max({bc.squaredNorm(), ca.squaredNorm(), ab.squaredNorm()});
  const bool flat =
      !(whole * whole > kFlat * kFlat * a.squaredNorm() * b.squaredNorm() * c.squaredNorm()) ||
      !(whole * whole > kRounding * kRounding * largest * d.squaredNorm());
  const bool inside = ofA > 0 && ofB > 0 && ofC > 0 && ofD > 0;
  if (inside && !flat) {
    return {Vector3::Zero(), 0, {0, 1, 2, 3}, {ofA / one, ofB / one, ofC / one, ofD / one}, 4};
  }
  Nearest<3> best;
  if (flat || !(ofA > 0)) keepNearer(best, onTriangle(simplex, 1, 2, 3));
  if (flat || !(ofB > 0)) keepNearer(best, onTriangle(simplex, 0, 2, 3));
  if (flat || !(ofC > 0)) keepNearer(best, onTriangle(simplex, 0, 1, 3));
  if (flat || !(ofD > 0)) keepNearer(best, onTriangle(simplex, 0, 1, 2));
  // Inside a flat tetrahedron the ratios of volumes are noise, but the nearest face is near.
  if (inside) {
    Nearest<3> all{Vector3::Zero(), 0, {0, 1, 2, 3}, {}, 4};
    for (int n = 0; n < best.count; ++n) {
      const auto from = static_cast<std::size_t>(n);
      all.weights[static_cast<std::size_t>(best.corners[from])] = best.weights[from];
    }
    return all;
  }
  return best;
}

// In the plane a triangle is the full simplex.
Nearest<2> onTriangle(const Simplex<2>& simplex) {
  const auto turn = [](const Vector2& p, const Vector2& q) {
    return p.x() * q.y() - p.y() * q.x();
  };
  const Vector2& c = at(simplex, 2);
  const Vector2 a = at(simplex, 0) - c, b = at(simplex, 1) - c;
  const Real whole = turn(a, b);
  const Real sign = whole < 0 ? -1 : 1;
  const Real ofA = sign * turn(b, c), ofB = sign * turn(c, a), ofC = sign * whole - ofA - ofB;
  if (ofA > 0 && ofB > 0 && ofC > 0) {
    const Real one = sign * whole;
    return {Vector2::Zero(), 0, {0, 1, 2}, {ofA / one, ofB / one, ofC / one}, 3};
  }
  Nearest<2> best;
  if (!(ofA > 0)) keepNearer(best, onSegment(simplex, 1, 2));
  if (!(ofB > 0)) keepNearer(best, onSegment(simplex, 0, 2));
  if (!(ofC > 0)) keepNearer(best, onSegment(simplex, 0, 1));
  return best;
}

Nearest<2> onAll(const Simplex<2>& simplex) {
  if (simplex.count == 1) return onPoint(simplex, 0);
  if (simplex.count == 2) return onSegment(simplex, 0, 1);
  return onTriangle(simplex);
}

Nearest<3> onAll(const Simplex<3>& simplex) {
  if (simplex.count == 1) return onPoint(simplex, 0);
  if (simplex.count == 2) return onSegment(simplex, 0, 1);
  if (simplex.count == 3) return onTriangle(simplex, 0, 1, 2);
  return onTetrahedron(simplex);
}

}  // namespace

template <int Dim>
Eigen::Matrix<Real, Dim, 1> closestToOrigin(Simplex<Dim>& simplex) {
  const Nearest<Dim> nearest = onAll(simplex);
  // The corners kept are in rising order, so each moves down or stays.
  for (int i = 0; i < nearest.count; ++i) {
    const auto to = static_cast<std::size_t>(i);
    const auto from = static_cast<std::size_t>(nearest.corners[to]);
    if (from != to) simplex.vertices[to] = simplex.vertices[from];
    simplex.weights[to] = nearest.weights[to];
  }
  simplex.count = nearest.count;
  return nearest.point;
}

template Vector2 closestToOrigin<2>(Simplex<2>& simplex);
template Vector3 closestToOrigin<3>(Simplex<3>& simplex);

}  // namespace carom

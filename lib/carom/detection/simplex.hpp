#pragma once
// A point, a segment, a triangle or a tetrahedron: which of its points is nearest to the origin?
//
// Method: signed volumes (Montanari, Petrinic and Barbieri, ACM Transactions on Graphics 36, 2017):
// the origin's barycentric weights are ratios of volumes (areas, lengths); if one is not positive,
// the nearest point lies on the face opposite to that corner, and the question is asked again
// there. Of several such faces the nearest wins.
// Why not the distances to all 15 faces with Johnson's determinants: their signs contradict each
// other for flat simplices, and GJK meets those at every touching pair.
// Not handled: which of two equally near faces is taken; the first.

#include <array>
#include <cstdint>

#include "carom/core/real.hpp"

namespace carom {

/// A corner of a simplex in the difference of two bodies: a point of A minus a point of B. Its
/// vectors are not set by default: a simplex is made for every pair, and clearing corners that are
/// never used took a tenth of GJK's time.
/// \tparam Dim 2 or 3
/// \ingroup detection
template <int Dim>
struct SimplexVertex {
  /// A column of Dim numbers.
  using Vector = Eigen::Matrix<Real, Dim, 1>;
  Vector difference;      ///< pointA - pointB [m]
  Vector pointA;          ///< point of A [m, common frame]
  Vector pointB;          ///< point of B [m, common frame]
  std::int32_t idA = -1;  ///< number of the corner of A, if it has corners
  std::int32_t idB = -1;  ///< number of the corner of B, if it has corners
};

/// Up to Dim + 1 corners, and the weights that make the point nearest to the origin.
/// \tparam Dim 2 or 3
/// \ingroup detection
template <int Dim>
struct Simplex {
  std::array<SimplexVertex<Dim>, Dim + 1> vertices;  ///< the first `count` are used
  std::array<Real, Dim + 1> weights{};               ///< positive, they add to 1
  int count = 0;                                     ///< number of corners
};

namespace detail {

/// The nearest point of a simplex to the origin, and the corners that hold it.
/// \tparam Dim 2 or 3
/// \ingroup detection
template <int Dim>
struct NearestPoint {
  Eigen::Matrix<Real, Dim, 1> point;  ///< the nearest point [m]
  Real squared;                       ///< its squared distance [m^2]
  std::array<int, Dim + 1> corners;   ///< numbers of the corners that hold it, rising
  std::array<Real, Dim + 1> weights;  ///< their weights
  int count;                          ///< how many
};

/// Finds the nearest point and leaves the simplex as it is, see closestToOrigin().
/// \tparam Dim 2 or 3 \param simplex at least one corner \param nearest receives the nearest point
template <int Dim>
void nearestToOrigin(const Simplex<Dim>& simplex, NearestPoint<Dim>& nearest);

/// Keeps only the corners that hold a nearest point.
/// \tparam Dim 2 or 3 \param simplex the simplex \param nearest of this simplex
template <int Dim>
void keepOnly(Simplex<Dim>& simplex, const NearestPoint<Dim>& nearest) {
  // They are in rising order, so each moves down or stays.
  for (int i = 0; i < nearest.count; ++i) {
    const auto to = static_cast<std::size_t>(i);
    const auto from = static_cast<std::size_t>(nearest.corners[to]);
    if (from != to) simplex.vertices[to] = simplex.vertices[from];
    simplex.weights[to] = nearest.weights[to];
  }
  simplex.count = nearest.count;
}

}  // namespace detail

/// Keeps of a simplex only the corners that hold its point nearest to the origin, and sets their
/// weights. All Dim + 1 are kept only if the origin lies inside.
/// \tparam Dim 2 or 3
/// \param simplex at least one corner
/// \return the nearest point [m]; zero if the origin lies inside
/// \ingroup detection
template <int Dim>
Eigen::Matrix<Real, Dim, 1> closestToOrigin(Simplex<Dim>& simplex) {
  detail::NearestPoint<Dim> nearest;
  detail::nearestToOrigin(simplex, nearest);
  detail::keepOnly(simplex, nearest);
  return nearest.point;
}

/// The points of A and B that the weights of a simplex mix.
/// \tparam Dim 2 or 3
/// \param simplex with weights as closestToOrigin() leaves them
/// \param pointA receives the point of A [m, common frame]
/// \param pointB receives the point of B [m, common frame]
/// \ingroup detection
template <int Dim>
void witnessPoints(const Simplex<Dim>& simplex, Eigen::Matrix<Real, Dim, 1>& pointA,
                   Eigen::Matrix<Real, Dim, 1>& pointB) {
  pointA.setZero();
  pointB.setZero();
  for (int i = 0; i < simplex.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    pointA += simplex.weights[k] * simplex.vertices[k].pointA;
    pointB += simplex.weights[k] * simplex.vertices[k].pointB;
  }
}

}  // namespace carom

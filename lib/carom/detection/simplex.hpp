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

/// A corner of a simplex in the difference of two bodies: a point of A minus a point of B.
/// \tparam Dim 2 or 3
/// \ingroup detection
template <int Dim>
struct SimplexVertex {
  /// A column of Dim numbers.
  using Vector = Eigen::Matrix<Real, Dim, 1>;
  Vector difference = Vector::Zero();  ///< pointA - pointB [m]
  Vector pointA = Vector::Zero();      ///< point of A [m, common frame]
  Vector pointB = Vector::Zero();      ///< point of B [m, common frame]
  std::int32_t idA = -1;               ///< number of the corner of A, if it has corners
  std::int32_t idB = -1;               ///< number of the corner of B, if it has corners
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

/// Keeps of a simplex only the corners that hold its point nearest to the origin, and sets their
/// weights. All Dim + 1 are kept only if the origin lies inside.
/// \tparam Dim 2 or 3
/// \param simplex at least one corner
/// \return the nearest point [m]; zero if the origin lies inside
/// \ingroup detection
template <int Dim>
Eigen::Matrix<Real, Dim, 1> closestToOrigin(Simplex<Dim>& simplex);

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

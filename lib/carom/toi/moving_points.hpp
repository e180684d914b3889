#pragma once
// When can a vertex meet a face, or an edge an edge, if all points move in straight lines?
//
// Only when the four points lie in one plane. Seen from one of them, the three others are at A, B
// and C, each linear in time, and A . (B x C) is zero: a cubic equation (Provot 1997). At such a
// time the plane is looked at along a coordinate axis, in which the four signed areas
//   B x C,  C x A,  A x B,  and their sum, the area of the triangle ABC
// say who is where, and these are quadratic in time. If all areas vanish along all three axes the
// points lie on one line, and differences of coordinates decide, which are linear.
// The same polynomials serve a vertex (the origin) against a face ABC, and an edge AB against an
// edge from C to the origin; and the same code makes them of doubles, of numbers with twice the
// digits, and of whole numbers.
// Why not the source's "every face against every face" (section 8.3): two planes meet always or
// never. First contacts of faces are those of a vertex with a face or of two edges.
// Not handled: points on curved paths.

#include <array>

#include "carom/core/real.hpp"

namespace carom {

/// Which of four points belong together. \ingroup toi
enum class FeaturePair {
  kVertexFace,  ///< point 0 against the triangle of points 1, 2, 3
  kEdgeEdge,    ///< the edge from point 0 to 1 against the edge from point 2 to 3
};

/// Four points that move in straight lines for a unit of time, each at a steady speed.
/// \ingroup toi
struct MovingPoints {
  std::array<Vector3, 4> start;  ///< where they are at time 0 [m, world]
  std::array<Vector3, 4> end;    ///< where they are at time 1 [m, world]
};

/// Where the points are. \param points and their motion \param time from 0 to 1
/// \return four points [m, world] \ingroup toi
inline std::array<Vector3, 4> placesAt(const MovingPoints& points, Real time) {
  std::array<Vector3, 4> places;
  for (std::size_t i = 0; i < 4; ++i) {
    places[i] = (1 - time) * points.start[i] + time * points.end[i];
  }
  return places;
}

/// The three moving points A, B, C seen from the fourth, as numbers into MovingPoints.
/// \ingroup toi
struct SeenFrom {
  std::size_t origin = 0;                  ///< the point that is looked from
  std::array<std::size_t, 3> points = {};  ///< A, B and C
};

/// From where a pair of features is looked at: the vertex, or the end of the second edge.
/// \param pair kind of the pair \return origin and A, B, C \ingroup toi
constexpr SeenFrom seenFrom(FeaturePair pair) {
  if (pair == FeaturePair::kVertexFace) return {0, {1, 2, 3}};
  return {3, {0, 1, 2}};
}

/// A vector that is linear in time, x first + y second: with x = 1 - t and y = t these are its
/// values at the start and the end, with x = 1 and y = t its start and its velocity. Products come
/// out in the same powers of x and y. \tparam Number Real, DoubleDouble or WholeNumber
/// \ingroup toi
template <class Number>
struct LinearVector {
  std::array<Number, 3> first;   ///< factors of x
  std::array<Number, 3> second;  ///< factors of y
};

/// Coefficients of x^2, x y and y^2. \ingroup toi
template <class Number>
using Quadratic = std::array<Number, 3>;
/// Coefficients of x^3, x^2 y, x y^2 and y^3. \ingroup toi
template <class Number>
using Cubic = std::array<Number, 4>;

/// Component k of the cross product of two moving vectors: twice a signed area, seen along axis k.
/// \param v first vector \param w second vector \param k 0, 1 or 2 \return (v x w)_k
/// \ingroup toi
template <class Number>
Quadratic<Number> crossComponent(const LinearVector<Number>& v, const LinearVector<Number>& w,
                                 std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return {v.first[i] * w.first[j] - v.first[j] * w.first[i],
          (v.first[i] * w.second[j] - v.first[j] * w.second[i]) +
              (v.second[i] * w.first[j] - v.second[j] * w.first[i]),
          v.second[i] * w.second[j] - v.second[j] * w.second[i]};
}

/// A . n, for n = B x C: six times the signed volume of the four points.
/// \param a a moving vector \param n the three components of a cross product
/// \return the cubic that is zero when the points lie in one plane
/// \ingroup toi
template <class Number>
Cubic<Number> dotProduct(const LinearVector<Number>& a, const std::array<Quadratic<Number>, 3>& n) {
  const auto sum = [](const auto& term) { return (term(0) + term(1)) + term(2); };
  return {sum([&](std::size_t k) { return a.first[k] * n[k][0]; }),
          sum([&](std::size_t k) { return a.first[k] * n[k][1]; }) +
              sum([&](std::size_t k) { return a.second[k] * n[k][0]; }),
          sum([&](std::size_t k) { return a.first[k] * n[k][2]; }) +
              sum([&](std::size_t k) { return a.second[k] * n[k][1]; }),
          sum([&](std::size_t k) { return a.second[k] * n[k][2]; })};
}

/// What the signs of the areas say of four points in a plane. With signs that are not known (0
/// also stands for these) it is still right to say kApart, and kMeet.
/// \ingroup toi
enum class PlanarVerdict {
  kApart,    ///< the features do not meet
  kMeet,     ///< they meet, and stay so under small changes
  kUnclear,  ///< they touch, or a sign is missing
};

/// Do two features in a plane meet, as the signs of areas tell?
/// \param pair kind of the pair \param bc sign of B x C \param ca sign of C x A
/// \param ab sign of A x B \param abc sign of the sum of the three
/// \return a verdict that holds whatever the signs are that are given as zero
/// \ingroup toi
constexpr PlanarVerdict judgeAreas(FeaturePair pair, int bc, int ca, int ab, int abc) {
  if (pair == FeaturePair::kVertexFace) {
    // Inside: left of all edges, or right of all.
    if (bc * ca < 0 || ca * ab < 0 || ab * bc < 0) return PlanarVerdict::kApart;
    return bc * ca * ab != 0 ? PlanarVerdict::kMeet : PlanarVerdict::kUnclear;
  }
  // C and the origin on different sides of the line AB; A and B on different sides of the line
  // from C to the origin.
  if (abc * ab > 0 || ca * bc < 0) return PlanarVerdict::kApart;
  return abc * ab < 0 && ca * bc > 0 ? PlanarVerdict::kMeet : PlanarVerdict::kUnclear;
}

}  // namespace carom

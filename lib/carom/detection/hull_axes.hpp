#pragma once
// The best axis of two polyhedra, without trying most of them.
//
// Method: the answer is that of satHulls(), the largest of all signed gaps; but a gap on the normal
// of a face of A is at most the height of any point of B over that face. One well-chosen point of B
// therefore rules out all faces that it lies deeper below than the best gap known, and an edge of
// A whose two faces are both ruled out cannot make the best axis either: every direction of its
// arc on the Gauss map lies between their normals. What is left of two shallowly overlapping bodies
// are the few faces and edges around the contact. Of those, two edges make a face of the Minkowski
// difference only if their arcs cross (Gregorius, GDC 2013). Of the 2988 axes of two hulls of 20
// points that overlap by 4 % of their radius six or seven are computed, and with a hint two.
// Why it is not an approximation: what is left out is left out by proof, so the answer does not
// depend on the point, on hints from the last step, or on the order of the search. Ties are broken
// by a rule on the gaps themselves.
// The chosen point: B's farthest point against the direction of the hint, or of the centroids; for
// A the same point, pulled into A towards its centroid if it lies outside.
// Source: Gregorius 2013 for the Gauss map; the bound is our own.
// Not handled: the exact sign next to touching (separateHulls()).

#include <cstdint>
#include <optional>

#include "carom/core/real.hpp"
#include "carom/detection/hull_view.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separating_axis.hpp"

namespace carom::detail {

/// Two polyhedra as A sees them. \ingroup detection
struct HullPair {
  HullView a;      ///< first
  HullView b;      ///< second
  Matrix3 R;       ///< rotation of B in the frame of A
  Vector3 t;       ///< B's origin [m, frame of A]
  Matrix3 R_WA;    ///< rotation of A in the world
  Real size = 0;   ///< sum of the bounding radii [m]
  Real reach = 0;  ///< no coordinate in the computation is larger, roughly [m]
};

/// The pair in the frame of A. \param a first \param A its pose \param b second \param B its pose
/// \return the pair \ingroup detection
HullPair hullPair(const HullView& a, const Pose& A, const HullView& b, const Pose& B);

/// The best axis of two polyhedra. \ingroup detection
struct HullAxis {
  Real separation = 0;                ///< largest signed gap [m]
  Vector3 normal = Vector3::UnitZ();  ///< unit, from A to B [1, frame of A]
  AxisKind kind = AxisKind::faceOfA;  ///< what it is made of
  std::int32_t featureA = -1;         ///< face or edge of A; for a face of B its lowest vertex
  std::int32_t featureB = -1;         ///< face or edge of B; for a face of A its lowest vertex
  Real error = 0;   ///< bound on the rounding of the gaps that could be larger than this one [m]
  bool all = true;  ///< false if the search ended at the first gap above `enough`
};

/// Where to begin a search. \ingroup detection
struct HullHint {
  AxisKind kind = AxisKind::faceOfA;  ///< what the last axis was made of
  std::int32_t featureA = -1;         ///< its face or edge of A
  std::int32_t featureB = -1;         ///< its face or edge of B
};

/// The best axis of two polyhedra.
/// \param pair the polyhedra
/// \param hint features of the last answer, or null; changes the time, never the result, unless
///   the result is above `enough`
/// \param enough the search may end with any gap above this [m]
/// \return the best axis \ingroup detection
HullAxis bestHullAxis(const HullPair& pair, const HullHint* hint, Real enough);

/// The axis of features that were the best ones before, whether they still are or not.
/// \param pair the polyhedra \param hint the features
/// \return their axis; nothing if they do not face each other any more \ingroup detection
std::optional<HullAxis> axisOfFeatures(const HullPair& pair, const HullHint& hint);

/// The vertex farthest in a direction, the first of several.
/// \param hull the polyhedron \param direction [any unit, body] \return its number
/// \ingroup detection
int farthestVertex(const HullView& hull, const Vector3& direction);

}  // namespace carom::detail

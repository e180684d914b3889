#pragma once
// How the types of chapter 3 cross the pipe, and how verdicts are worded in a message.

#include <string>

#include "carom/detection/aabb.hpp"
#include "carom/detection/ball_ball.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/gjk_distance.hpp"
#include "carom/detection/interval.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/detection/verdict.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<BallGap> {
  static constexpr auto list =
      fieldList("separation", &BallGap::separation, "verdict", &BallGap::verdict);
};

template <int Dim>
struct Fields<Aabb<Dim>> {
  static constexpr auto list = fieldList("low", &Aabb<Dim>::low, "high", &Aabb<Dim>::high);
};

template <>
struct Fields<Interval> {
  static constexpr auto list = fieldList("low", &Interval::low, "high", &Interval::high);
};

template <>
struct Fields<SeparatingAxis> {
  static constexpr auto list =
      fieldList("verdict", &SeparatingAxis::verdict, "separation", &SeparatingAxis::separation,
                "axis", &SeparatingAxis::axis, "kind", &SeparatingAxis::kind, "featureA",
                &SeparatingAxis::featureA, "featureB", &SeparatingAxis::featureB);
};

template <>
struct Fields<Pose> {
  static constexpr auto list = fieldList("R_WB", &Pose::R_WB, "p_WB", &Pose::p_WB);
};

template <>
struct Fields<Box> {
  static constexpr auto list = fieldList("halfExtents", &Box::halfExtents);
};

template <>
struct Fields<HullFace> {
  static constexpr auto list =
      fieldList("normal", &HullFace::normal, "offset", &HullFace::offset, "firstHalfEdge",
                &HullFace::firstHalfEdge, "count", &HullFace::count);
};

template <>
struct Fields<HullHalfEdge> {
  static constexpr auto list =
      fieldList("origin", &HullHalfEdge::origin, "next", &HullHalfEdge::next, "twin",
                &HullHalfEdge::twin, "face", &HullHalfEdge::face, "edge", &HullHalfEdge::edge);
};

template <>
struct Fields<HullEdge> {
  static constexpr auto list =
      fieldList("from", &HullEdge::from, "to", &HullEdge::to, "leftFace", &HullEdge::leftFace,
                "rightFace", &HullEdge::rightFace);
};

template <>
struct Fields<ConvexHull> {
  static constexpr auto list = fieldList(
      "vertices", &ConvexHull::vertices, "x", &ConvexHull::x, "y", &ConvexHull::y, "z",
      &ConvexHull::z, "faces", &ConvexHull::faces, "halfEdges", &ConvexHull::halfEdges, "edges",
      &ConvexHull::edges, "anyHalfEdge", &ConvexHull::anyHalfEdge, "centroid",
      &ConvexHull::centroid, "volume", &ConvexHull::volume, "boundingRadius",
      &ConvexHull::boundingRadius);
};

template <>
struct Fields<PointDistance> {
  static constexpr auto list =
      fieldList("distance", &PointDistance::distance, "pointA", &PointDistance::pointA, "pointB",
                &PointDistance::pointB, "iterations", &PointDistance::iterations);
};

/// The verdict as a word, so that a message can be read.
inline std::string inWords(Verdict verdict) {
  switch (verdict) {
    case Verdict::separated:
      return "separated";
    case Verdict::touching:
      return "touching";
    case Verdict::overlapping:
      return "overlapping";
  }
  return "no verdict";
}

/// What an axis is made of, as words.
inline std::string inWords(AxisKind kind) {
  switch (kind) {
    case AxisKind::faceOfA:
      return "a face of A";
    case AxisKind::faceOfB:
      return "a face of B";
    case AxisKind::edges:
      return "a pair of edges";
  }
  return "no kind";
}

}  // namespace carom::grading

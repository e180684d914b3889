#pragma once
// How the types of chapter 4 cross the pipe.

#include "carom/manifold/contact_ids.hpp"
#include "carom/manifold/edge_contact.hpp"
#include "carom/manifold/face_contact.hpp"
#include "carom/manifold/least_displacement.hpp"
#include "carom/manifold/polygon_centroid.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<LeastDisplacement> {
  static constexpr auto list =
      fieldList("normal", &LeastDisplacement::normal, "separation", &LeastDisplacement::separation,
                "axis", &LeastDisplacement::axis);
};

template <>
struct Fields<FacePoint> {
  static constexpr auto list =
      fieldList("position", &FacePoint::position, "separation", &FacePoint::separation);
};

template <>
struct Fields<EdgeContact> {
  static constexpr auto list =
      fieldList("normal", &EdgeContact::normal, "separation", &EdgeContact::separation, "pointA",
                &EdgeContact::pointA, "pointB", &EdgeContact::pointB, "s", &EdgeContact::s, "t",
                &EdgeContact::t);
};

template <>
struct Fields<PolygonArea> {
  static constexpr auto list =
      fieldList("area", &PolygonArea::area, "centroid", &PolygonArea::centroid);
};

template <>
struct Fields<Feature> {
  static constexpr auto list = fieldList("kind", &Feature::kind, "index", &Feature::index);
};

template <>
struct Fields<FeaturePair> {
  static constexpr auto list = fieldList("onA", &FeaturePair::onA, "onB", &FeaturePair::onB);
};

}  // namespace carom::grading

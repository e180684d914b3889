#pragma once
// Where does a ray first meet a body?
//
// Method: in body coordinates, each shape its own: the quadratic of a ball in the form that does
// not cancel, slabs for boxes, a disc between two planes for cylinders, clipping by all face planes
// for hulls. t runs from 0 to `reach` in units of the direction, so a ray from a to b has direction
// b - a and reach 1.
// Why a ray that starts inside is told apart: what it hits has no outward normal, and callers (a
// wheel, a sensor, a bullet) want different things.
// Source: Haines 1991 (hulls); Ericson 2005, section 5.3.
// Not handled: rays with a width (a swept ball is a ray against a rounded shape; chapter 7).

#include <limits>

#include "carom/core/real.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// A half-line, or a piece of one. \ingroup detection
struct Ray {
  Vector3 origin = Vector3::Zero();                    ///< where it starts [m, world]
  Vector3 direction = Vector3::UnitX();                ///< any length but zero [m, world]
  Real reach = std::numeric_limits<Real>::infinity();  ///< largest t, in units of direction [1]
};

/// Where a ray meets a body. \ingroup detection
struct RayHit {
  bool hit = false;                  ///< false: nothing within reach; the rest says nothing
  bool startsInside = false;         ///< the ray starts inside: t = 0, normal zero
  Real t = 0;                        ///< point = origin + t direction [1]
  Vector3 point = Vector3::Zero();   ///< first common point [m, world]
  Vector3 normal = Vector3::Zero();  ///< outward normal of the surface there [1, world]
};

/// The first point of a closed body on a ray.
/// \param shape usable shape \param pose of the body
/// \param ray with a direction that is not zero
/// \return the hit, if there is one
/// \throws InvalidInput if the ray's numbers are not finite (reach may be infinite), its direction
///   is zero or its reach negative
/// \ingroup detection
RayHit castRay(const Shape& shape, const Pose& pose, const Ray& ray);

/// A half-line in the plane, or a piece of one. \ingroup detection
struct PlanarRay {
  Vector2 origin = Vector2::Zero();                    ///< where it starts [m, world]
  Vector2 direction = Vector2::UnitX();                ///< any length but zero [m, world]
  Real reach = std::numeric_limits<Real>::infinity();  ///< largest t, in units of direction [1]
};

/// Where a ray meets a planar body. \ingroup detection
struct PlanarRayHit {
  bool hit = false;                  ///< false: nothing within reach; the rest says nothing
  bool startsInside = false;         ///< the ray starts inside: t = 0, normal zero
  Real t = 0;                        ///< point = origin + t direction [1]
  Vector2 point = Vector2::Zero();   ///< first common point [m, world]
  Vector2 normal = Vector2::Zero();  ///< outward normal of the outline there [1, world]
};

/// The first point of a closed planar body on a ray.
/// \param shape usable shape \param pose of the body
/// \param ray with a direction that is not zero
/// \return the hit, if there is one
/// \throws InvalidInput as for castRay() in space
/// \ingroup detection
PlanarRayHit castRay(const PlanarShape& shape, const PlanarPose& pose, const PlanarRay& ray);

}  // namespace carom

#pragma once
// A convex shape as a core without roundness, and a radius around it.
//
// Method: a ball is a point with a radius, a capsule a segment with a radius; boxes, cylinders and
// hulls have radius zero. Distance and overlap are computed for the cores and the radii subtracted,
// so a ball is exact and shallow overlaps of round bodies are still distances between cores.
// Why one struct with a switch and not a variant: GJK asks for support points in its innermost
// loop, one branch on the kind is all it costs, and one loop serves all pairs.
// Source: van den Bergen 2003, section 4.3; the idea is in every engine.
// Not handled: an artificial margin around boxes and hulls. It rounds their corners, and measured
// distances with it are wrong by centimetres.

#include <cmath>
#include <cstdint>

#include "carom/core/real.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/detection/simplex.hpp"
#include "carom/detection/support.hpp"

namespace carom::detail {

/// What a core is. \ingroup detection
enum class CoreKind : std::uint8_t { point, segment, box, cylinder, hull };

/// A core in its body's frame. \ingroup detection
struct CoreShape {
  CoreKind kind = CoreKind::point;    ///< what it is
  Real radius = 0;                    ///< the roundness around it [m]
  Vector3 extents = Vector3::Zero();  ///< box: half extents; segment, cylinder: z; cylinder: x = r
  const ConvexHull* hull = nullptr;   ///< for hulls; must outlive the core

  /// The farthest point of the core. \param d direction, any length [body]
  /// \param start corner where the search begins, for hulls
  /// \return the point and its number; -1 for cylinders, which have no corners
  Support support(const Vector3& d, std::int32_t start) const {
    switch (kind) {
      case CoreKind::point:
        return {Vector3::Zero(), 0};
      case CoreKind::segment:
        return d.z() >= 0 ? Support{{0, 0, extents.z()}, 1} : Support{{0, 0, -extents.z()}, 0};
      case CoreKind::box: {
        const Vector3 point(std::copysign(extents.x(), d.x()), std::copysign(extents.y(), d.y()),
                            std::copysign(extents.z(), d.z()));
        return {point, static_cast<std::int32_t>(point.x() > 0) + 2 * (point.y() > 0) +
                           4 * (point.z() > 0)};
      }
      case CoreKind::cylinder:
        return supportOf(Cylinder{extents.x(), extents.z()}, d);
      case CoreKind::hull:
        return supportOf(*hull, d, start);
    }
    return {};
  }

  /// The corner with a number, if there is one. \param id as support() gave it
  /// \param point receives the corner [m, body] \return false if no corner has this number
  bool corner(std::int32_t id, Vector3& point) const {
    if (id < 0) return false;
    switch (kind) {
      case CoreKind::point:
        point.setZero();
        return id == 0;
      case CoreKind::segment:
        point = {0, 0, id == 1 ? extents.z() : -extents.z()};
        return id <= 1;
      case CoreKind::box:
        point = {(id & 1) != 0 ? extents.x() : -extents.x(),
                 (id & 2) != 0 ? extents.y() : -extents.y(),
                 (id & 4) != 0 ? extents.z() : -extents.z()};
        return id < 8;
      case CoreKind::cylinder:
        return false;
      case CoreKind::hull:
        if (static_cast<std::size_t>(id) >= hull->vertices.size()) return false;
        point = hull->vertices[static_cast<std::size_t>(id)];
        return true;
    }
    return false;
  }
};

/// The core of a ball. \param ball the ball \return a point \ingroup detection
inline CoreShape coreOf(const Ball& ball) {
  return {CoreKind::point, ball.radius, Vector3::Zero(), nullptr};
}
/// The core of a capsule. \param capsule the capsule \return a segment \ingroup detection
inline CoreShape coreOf(const Capsule& capsule) {
  return {CoreKind::segment, capsule.radius, {0, 0, capsule.halfLength}, nullptr};
}
/// The core of a box. \param box the box \return itself \ingroup detection
inline CoreShape coreOf(const Box& box) {
  return {CoreKind::box, 0, box.halfExtents, nullptr};
}
/// The core of a cylinder. \param cylinder the cylinder \return itself \ingroup detection
inline CoreShape coreOf(const Cylinder& cylinder) {
  return {CoreKind::cylinder, 0, {cylinder.radius, 0, cylinder.halfHeight}, nullptr};
}
/// The core of a hull. \param hull must outlive the core \return itself \ingroup detection
inline CoreShape coreOf(const ConvexHull& hull) {
  return {CoreKind::hull, 0, Vector3::Zero(), &hull};
}

/// Support points of the difference of two placed cores, A - B, measured from A's origin along the
/// world's axes. The positions are subtracted first, so nothing is lost far from the origin; the
/// matrices are used as they are, so a matrix that is a rounding away from a rotation stands for
/// exactly the solid that it makes. \ingroup detection
struct CorePair {
  const CoreShape& a;               ///< core of A
  const CoreShape& b;               ///< core of B
  const Matrix3& R_WA;              ///< rotation of A
  const Matrix3& R_WB;              ///< rotation of B
  Vector3 p_AB;                     ///< B's origin from A's [m, world axes]
  mutable std::int32_t startA = 0;  ///< hull corner found last
  mutable std::int32_t startB = 0;  ///< hull corner found last

  /// The farthest difference of a point of A and a point of B.
  /// \param d direction, any length [world] \return the vertex
  SimplexVertex<3> operator()(const Vector3& d) const {
    const Support onA = a.support(R_WA.transpose() * d, startA);
    const Support onB = b.support(R_WB.transpose() * -d, startB);
    if (onA.id > 0) startA = onA.id;
    if (onB.id > 0) startB = onB.id;
    return made(onA.point, onA.id, onB.point, onB.id);
  }

  /// The difference of two corners by number. \param idA corner of A \param idB corner of B
  /// \param vertex receives it \return false if one of them has no such corner
  bool corners(std::int32_t idA, std::int32_t idB, SimplexVertex<3>& vertex) const {
    Vector3 onA, onB;
    if (!a.corner(idA, onA) || !b.corner(idB, onB)) return false;
    vertex = made(onA, idA, onB, idB);
    return true;
  }

  /// A vertex from points of both bodies. \param onA point of A [m, A] \param idA its number
  /// \param onB point of B [m, B] \param idB its number \return the vertex
  SimplexVertex<3> made(const Vector3& onA, std::int32_t idA, const Vector3& onB,
                        std::int32_t idB) const {
    const Vector3 p = R_WA * onA;
    const Vector3 q = R_WB * onB + p_AB;
    return {p - q, p, q, idA, idB};
  }
};

}  // namespace carom::detail

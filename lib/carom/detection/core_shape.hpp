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

#include "carom/core/length.hpp"
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
  Vector3 extents = Vector3::Zero();  ///< half sizes; cylinder: radius twice; segment: z only [m]
  const ConvexHull* hull = nullptr;   ///< for hulls; must outlive the core
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
  return {CoreKind::cylinder, 0, {cylinder.radius, cylinder.radius, cylinder.halfHeight}, nullptr};
}
/// The core of a hull. \param hull must outlive the core \return itself \ingroup detection
inline CoreShape coreOf(const ConvexHull& hull) {
  return {CoreKind::hull, 0, Vector3::Zero(), &hull};
}

/// A core turned as its body is, measured from the body's origin along the world's axes. The
/// columns of the matrix times the half sizes are kept, so that a corner of a box is a sum of three
/// columns, and no product with the matrix is left in the loop. \ingroup detection
struct PlacedCore {
  CoreKind kind;           ///< what it is
  const ConvexHull* hull;  ///< for hulls
  Matrix3 R_WB;            ///< rotation, body to world
  Matrix3 arms;            ///< R_WB times the half sizes: columns from the centre to the faces [m]

  /// Turns a core. \param core the core \param rotation body to world
  PlacedCore(const CoreShape& core, const Matrix3& rotation)
      : kind(core.kind),
        hull(core.hull),
        R_WB(rotation),
        arms(rotation * core.extents.asDiagonal()) {}

  /// The farthest point of the core. \param d direction, any length [world axes]
  /// \param start corner where the search begins, for hulls
  /// \return the point and its number; -1 for cylinders, which have no corners
  Support support(const Vector3& d, std::int32_t start) const {
    switch (kind) {
      case CoreKind::point:
        return {Vector3::Zero(), 0};
      case CoreKind::segment: {
        const bool up = d.dot(arms.col(2)) >= 0;
        return {up ? Vector3(arms.col(2)) : Vector3(-arms.col(2)), up};
      }
      case CoreKind::box: {
        const Real x = d.dot(arms.col(0)), y = d.dot(arms.col(1)), z = d.dot(arms.col(2));
        const Vector3 point = std::copysign(Real(1), x) * arms.col(0) +
                              std::copysign(Real(1), y) * arms.col(1) +
                              std::copysign(Real(1), z) * arms.col(2);
        return {point, !std::signbit(x) + 2 * !std::signbit(y) + 4 * !std::signbit(z)};
      }
      case CoreKind::cylinder: {
        const Real x = d.dot(R_WB.col(0)), y = d.dot(R_WB.col(1)), z = d.dot(arms.col(2));
        // Along the axis the end's centre: then no side is preferred.
        const Real rho = length({x, y, 0});
        Vector3 point = std::copysign(Real(1), z) * arms.col(2);
        if (rho > 0) point += (x / rho) * arms.col(0) + (y / rho) * arms.col(1);
        return {point, -1};
      }
      case CoreKind::hull: {
        const Support found = supportOf(*hull, R_WB.transpose() * d, start);
        return {R_WB * found.point, found.id};
      }
    }
    return {};
  }

  /// The corner with a number, if there is one. \param id as support() gave it
  /// \param point receives the corner [m, world axes] \return false if there is none
  bool corner(std::int32_t id, Vector3& point) const {
    if (id < 0) return false;
    // Computed, not chosen: the processor cannot guess which corners a pair of boxes had.
    const auto sign = [id](int bit) { return static_cast<Real>(2 * (id >> bit & 1) - 1); };
    switch (kind) {
      case CoreKind::point:
        point.setZero();
        return id == 0;
      case CoreKind::segment:
        point = sign(0) * arms.col(2);
        return id <= 1;
      case CoreKind::box:
        point = sign(0) * arms.col(0) + sign(1) * arms.col(1) + sign(2) * arms.col(2);
        return id < 8;
      case CoreKind::cylinder:
        return false;
      case CoreKind::hull:
        if (static_cast<std::size_t>(id) >= hull->vertices.size()) return false;
        point = R_WB * hull->vertices[static_cast<std::size_t>(id)];
        return true;
    }
    return false;
  }
};

/// Support points of the difference of two placed cores, A - B, measured from A's origin along the
/// world's axes. The positions are subtracted first, so nothing is lost far from the origin; the
/// matrices are used as they are, so a matrix that is a rounding away from a rotation stands for
/// exactly the solid that it makes. \ingroup detection
struct CorePair {
  PlacedCore a;                     ///< core of A
  PlacedCore b;                     ///< core of B
  Vector3 p_AB;                     ///< B's origin from A's [m, world axes]
  mutable std::int32_t startA = 0;  ///< hull corner found last
  mutable std::int32_t startB = 0;  ///< hull corner found last

  /// Turns both cores. \param coreA core of A \param R_WA its rotation
  /// \param coreB core of B \param R_WB its rotation
  /// \param offset B's origin from A's [m, world axes]
  CorePair(const CoreShape& coreA, const Matrix3& R_WA, const CoreShape& coreB, const Matrix3& R_WB,
           const Vector3& offset)
      : a(coreA, R_WA), b(coreB, R_WB), p_AB(offset) {}

  /// The farthest difference of a point of A and a point of B.
  /// \param d direction, any length [world axes] \return the vertex
  SimplexVertex<3> operator()(const Vector3& d) const {
    const Support onA = a.support(d, startA);
    const Support onB = b.support(-d, startB);
    if (onA.id > 0) startA = onA.id;
    if (onB.id > 0) startB = onB.id;
    const Vector3 q = onB.point + p_AB;
    return {onA.point - q, onA.point, q, onA.id, onB.id};
  }

  /// The difference of two corners by number. \param idA corner of A \param idB corner of B
  /// \param vertex receives it \return false if one of them has no such corner
  bool corners(std::int32_t idA, std::int32_t idB, SimplexVertex<3>& vertex) const {
    Vector3 onA, onB;
    if (!a.corner(idA, onA) || !b.corner(idB, onB)) return false;
    const Vector3 q = onB + p_AB;
    vertex = {onA - q, onA, q, idA, idB};
    return true;
  }
};

}  // namespace carom::detail

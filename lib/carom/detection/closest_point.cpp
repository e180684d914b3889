#include "carom/detection/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/gap_sign.hpp"

namespace carom {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

// The surface of a ball of some radius about `core`, seen from x; `sideways` where x is the core.
SurfacePoint aroundCore(const Vector3& x, const Vector3& core, Real radius,
                        const Vector3& sideways) {
  const Vector3 way = x - core;
  const Real distance = length(way);
  const Vector3 normal = distance > 0 ? (way / distance).eval() : sideways;
  return {distance - radius, core + radius * normal, normal};
}

Vector3 axisPoint(const Capsule& capsule, const Vector3& x) {
  return {0, 0, std::clamp(x.z(), -capsule.halfLength, capsule.halfLength)};
}

// The nearest point of a segment.
template <class Vector>
Vector onSegment(const Vector& x, const Vector& a, const Vector& b) {
  const Vector edge = b - a;
  const Real along = (x - a).dot(edge);
  if (!(along > 0)) return a;
  const Real whole = edge.squaredNorm();
  if (along >= whole) return b;
  return a + (along / whole) * edge;
}

// Everything in body coordinates.
struct Closest {
  const Vector3& x;

  SurfacePoint operator()(const Ball& ball) const {
    return aroundCore(x, Vector3::Zero(), ball.radius, Vector3::UnitZ());
  }
  SurfacePoint operator()(const Capsule& capsule) const {
    return aroundCore(x, axisPoint(capsule, x), capsule.radius, Vector3::UnitX());
  }
  SurfacePoint operator()(const Box& box) const {
    const Vector3& h = box.halfExtents;
    const Vector3 clamped = x.cwiseMax(-h).cwiseMin(h);
    if (clamped != x) return aroundCore(x, clamped, 0, Vector3::UnitZ());
    // Inside: out through the face with the shortest way.
    int k = 0;
    for (int i = 1; i < 3; ++i) {
      if (h(i) - std::abs(x(i)) < h(k) - std::abs(x(k))) k = i;
    }
    const Real sign = x(k) >= 0 ? 1 : -1;
    SurfacePoint result{std::abs(x(k)) - h(k), x, sign * Vector3::Unit(k)};
    result.point(k) = sign * h(k);
    return result;
  }
  SurfacePoint operator()(const Cylinder& cylinder) const {
    const Vector3 sideways(x.x(), x.y(), 0);
    const Real rho = length(sideways);
    const Vector3 radial = rho > 0 ? (sideways / rho).eval() : Vector3(Vector3::UnitX());
    const Real up = x.z() >= 0 ? 1 : -1;
    const Real past = rho - cylinder.radius, above = std::abs(x.z()) - cylinder.halfHeight;
    if (past > 0 && above > 0) {
      Vector3 rim = cylinder.radius * radial;
      rim.z() = up * cylinder.halfHeight;
      // In the plane of the axis and the point, so that rounding cannot turn it along the rim.
      const Vector3 way = past * radial + above * up * Vector3::UnitZ();
      const Real distance = length(way);
      return {distance, rim, way / distance};
    }
    if (past > above) {
      Vector3 wall = cylinder.radius * radial;
      wall.z() = x.z();
      return {past, wall, radial};
    }
    return {above, {x.x(), x.y(), up * cylinder.halfHeight}, up * Vector3::UnitZ()};
  }
  SurfacePoint operator()(const ConvexHull& hull) const {
    std::size_t highest = 0;
    Real height = -kInfinity;
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
      const Real over = hull.faces[f].normal.dot(x) - hull.faces[f].offset;
      if (over > height) {
        height = over;
        highest = f;
      }
    }
    const Vector3& normal = hull.faces[highest].normal;
    if (height <= 0) return {height, x - height * normal, normal};
    return outside(hull, normal);
  }
  SurfacePoint operator()(const HalfSpace& space) const {
    const Real height = space.normal.dot(x) - space.offset;
    return {height, x - height * space.normal, space.normal};
  }
  SurfacePoint operator()(const Compound& compound) const {
    SurfacePoint best;
    best.distance = kInfinity;
    for (const CompoundPart& part : compound.parts) {
      const SurfacePoint found = closestPoint(part.shape, part.pose, x);
      if (found.distance < best.distance) best = found;
    }
    return best;
  }

  // Of a point outside a hull: over the inside of a face that sees it, or at one of their edges.
  SurfacePoint outside(const ConvexHull& hull, const Vector3& fallback) const {
    const auto vertex = [&](std::int32_t side) -> const Vector3& {
      return hull.vertices[static_cast<std::size_t>(
          hull.halfEdges[static_cast<std::size_t>(side)].origin)];
    };
    Vector3 best = vertex(0);
    Vector3 along = Vector3::Zero();  // of the edge, if its inside is nearest
    Real squared = kInfinity;
    for (const HullFace& face : hull.faces) {
      const Real over = face.normal.dot(x) - face.offset;
      if (over <= 0) continue;
      bool above = true;
      for (std::int32_t i = 0; i < face.count; ++i) {
        const Vector3& a = vertex(face.firstHalfEdge + i);
        const Vector3& b = vertex(face.firstHalfEdge + (i + 1) % face.count);
        if (cross(b - a, x - a).dot(face.normal) >= 0) continue;
        above = false;
        const Vector3 point = onSegment(x, a, b);
        if ((x - point).squaredNorm() < squared) {
          squared = (x - point).squaredNorm();
          best = point;
          along = point != a && point != b ? Vector3((b - a).normalized()) : Vector3::Zero();
        }
      }
      if (above) return {over, x - over * face.normal, face.normal};
    }
    // What a tiny gap leans along its edge is rounding; one of the size of rounding has no
    // direction.
    Vector3 gap = x - best;
    gap -= gap.dot(along) * along;
    const Real distance = length(gap);
    const Real noise = 8 * std::numeric_limits<Real>::epsilon() * best.cwiseAbs().maxCoeff();
    return {distance, best, distance > noise ? Vector3(gap / distance) : fallback};
  }
};

struct Holds {
  const Vector3& x;

  bool operator()(const Ball& ball) const {
    return gapSign(x, 0, Vector3::Zero(), ball.radius) <= 0;
  }
  bool operator()(const Capsule& capsule) const {
    return gapSign(x, 0, axisPoint(capsule, x), capsule.radius) <= 0;
  }
  bool operator()(const Box& box) const {
    return (x.array().abs() <= box.halfExtents.array()).all();
  }
  bool operator()(const Cylinder& cylinder) const {
    return std::abs(x.z()) <= cylinder.halfHeight &&
           gapSign({x.x(), x.y(), 0}, 0, Vector3::Zero(), cylinder.radius) <= 0;
  }
  bool operator()(const ConvexHull& hull) const {
    return std::all_of(hull.faces.begin(), hull.faces.end(),
                       [&](const HullFace& face) { return face.normal.dot(x) <= face.offset; });
  }
  bool operator()(const HalfSpace& space) const {
    return space.normal.dot(x) <= space.offset;
  }
  bool operator()(const Compound& compound) const {
    return std::any_of(compound.parts.begin(), compound.parts.end(), [&](const CompoundPart& p) {
      const Vector3 local = pointToBody(p.pose, x);
      return std::visit(Holds{local}, p.shape);
    });
  }
};

SurfacePoint toWorld(const SurfacePoint& found, const Pose& pose) {
  return {found.distance, pointToWorld(pose, found.point), directionToWorld(pose, found.normal)};
}

// The flat siblings, in body coordinates.
struct PlanarClosest {
  const Vector2& x;

  OutlinePoint operator()(const Disc& disc) const {
    const SurfacePoint found =
        aroundCore({x.x(), x.y(), 0}, Vector3::Zero(), disc.radius, Vector3::UnitY());
    return {found.distance, found.point.head<2>(), found.normal.head<2>()};
  }
  OutlinePoint operator()(const Polygon& polygon) const {
    const std::size_t count = polygon.vertices.size();
    std::size_t highest = 0;
    Real height = -kInfinity;
    for (std::size_t i = 0; i < count; ++i) {
      const Real over = polygon.normals[i].dot(x - polygon.vertices[i]);
      if (over > height) {
        height = over;
        highest = i;
      }
    }
    const Vector2& normal = polygon.normals[highest];
    if (height <= 0) return {height, x - height * normal, normal};
    Vector2 best = polygon.vertices[0];
    Real squared = kInfinity;
    for (std::size_t i = 0; i < count; ++i) {
      const Vector2& a = polygon.vertices[i];
      const Vector2& b = polygon.vertices[(i + 1) % count];
      const Real over = polygon.normals[i].dot(x - a);
      if (over <= 0) continue;
      const Vector2 point = onSegment(x, a, b);
      if (point != a && point != b)
        return {over, x - over * polygon.normals[i], polygon.normals[i]};
      if ((x - point).squaredNorm() < squared) {
        squared = (x - point).squaredNorm();
        best = point;
      }
    }
    const Vector2 way = x - best;
    const Real distance = length(Vector3(way.x(), way.y(), 0));
    return {distance, best, distance > 0 ? Vector2(way / distance) : normal};
  }
  OutlinePoint operator()(const PlanarCompound& compound) const {
    OutlinePoint best;
    best.distance = kInfinity;
    for (const PlanarCompoundPart& part : compound.parts) {
      const Vector2 local = pointToBody(part.pose, x);
      const OutlinePoint found = std::visit(PlanarClosest{local}, part.shape);
      if (found.distance < best.distance) {
        best = {found.distance, pointToWorld(part.pose, found.point),
                directionToWorld(part.pose, found.normal)};
      }
    }
    return best;
  }
};

struct PlanarHolds {
  const Vector2& x;

  bool operator()(const Disc& disc) const {
    return gapSign({x.x(), x.y(), 0}, 0, Vector3::Zero(), disc.radius) <= 0;
  }
  bool operator()(const Polygon& polygon) const {
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      if (polygon.normals[i].dot(x - polygon.vertices[i]) > 0) return false;
    }
    return true;
  }
  bool operator()(const PlanarCompound& compound) const {
    return std::any_of(compound.parts.begin(), compound.parts.end(),
                       [&](const PlanarCompoundPart& part) {
                         const Vector2 local = pointToBody(part.pose, x);
                         return std::visit(PlanarHolds{local}, part.shape);
                       });
  }
};

}  // namespace

namespace detail {

SurfacePoint closestInBody(const Ball& ball, const Vector3& x) {
  return Closest{x}(ball);
}
SurfacePoint closestInBody(const Box& box, const Vector3& x) {
  return Closest{x}(box);
}
SurfacePoint closestInBody(const Capsule& capsule, const Vector3& x) {
  return Closest{x}(capsule);
}
SurfacePoint closestInBody(const Cylinder& cylinder, const Vector3& x) {
  return Closest{x}(cylinder);
}
SurfacePoint closestInBody(const ConvexHull& hull, const Vector3& x) {
  return Closest{x}(hull);
}

}  // namespace detail

SurfacePoint closestPoint(const Shape& shape, const Pose& pose, const Vector3& point) {
  const Vector3 local = pointToBody(pose, point);
  return toWorld(std::visit(Closest{local}, shape), pose);
}

SurfacePoint closestPoint(const ConvexShape& shape, const Pose& pose, const Vector3& point) {
  const Vector3 local = pointToBody(pose, point);
  return toWorld(std::visit(Closest{local}, shape), pose);
}

OutlinePoint closestPoint(const PlanarShape& shape, const PlanarPose& pose, const Vector2& point) {
  const Vector2 local = pointToBody(pose, point);
  const OutlinePoint found = std::visit(PlanarClosest{local}, shape);
  return {found.distance, pointToWorld(pose, found.point), directionToWorld(pose, found.normal)};
}

bool contains(const Shape& shape, const Pose& pose, const Vector3& point) {
  const Vector3 local = pointToBody(pose, point);
  return std::visit(Holds{local}, shape);
}

bool contains(const PlanarShape& shape, const PlanarPose& pose, const Vector2& point) {
  const Vector2 local = pointToBody(pose, point);
  return std::visit(PlanarHolds{local}, shape);
}

}  // namespace carom

#include "carom/detection/cast_ray.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

// A ray in body coordinates with a direction of length one; its piece [enter, leave] that is inside
// so far, and the normal where it enters.
struct Piece {
  Real enter = 0;
  Real leave = kInfinity;
  Vector3 normal = Vector3::Zero();  // zero: it starts inside

  bool empty() const {
    return !(enter <= leave);
  }
  void makeEmpty() {
    leave = -kInfinity;
  }
  // Keeps what is below a plane, from the height above it at the start and the height gained per
  // length.
  void clip(Real height, Real slope, const Vector3& outward) {
    if (slope == 0) {
      if (height > 0) makeEmpty();
      return;
    }
    const Real t = -height / slope;
    if (slope < 0 && height > 0 && t >= enter) {
      enter = t;
      normal = outward;
    }
    if (slope > 0) leave = height > 0 ? -kInfinity : std::min(leave, t);
  }
};

// Times at which |m + t d| = r, for |d|^2 = dd, in the order found; false if never. The smaller is
// written as c / (...) where the larger would cancel against the root.
bool roundTimes(Real md, Real dd, Real gap, Real missSquared, Real radius, Real& first,
                Real& last) {
  const Real under = radius * radius - missSquared;
  if (!(under >= 0) || !(dd > 0)) return false;
  const Real root = std::sqrt(under * dd);
  // Roots of dd t^2 + 2 md t + gap = 0.
  const Real q = md > 0 ? -(md + root) : root - md;
  const Real one = q / dd, other = q != 0 ? gap / q : 0;
  first = std::min(one, other);
  last = std::max(one, other);
  return true;
}

struct Caster {
  const Vector3& o;  // origin, body coordinates
  const Vector3& d;  // direction of length one

  Piece round(const Vector3& center, Real radius) const {
    const Vector3 m = o - center;
    const Real along = m.dot(d), far = m.norm();
    const Vector3 miss = m - along * d;  // square to the ray: how far it passes the centre
    Piece piece;
    Real first = 0, last = 0;
    if (!roundTimes(along, 1, (far - radius) * (far + radius), miss.squaredNorm(), radius, first,
                    last)) {
      piece.makeEmpty();
      return piece;
    }
    piece.leave = last;
    if (far > radius) {
      if (last < 0) piece.makeEmpty();
      piece.enter = first;
      piece.normal = (m + first * d).normalized();
    }
    return piece;
  }
  // The wall of an endless cylinder along z.
  Piece wall(Real radius) const {
    const Real dd = d.x() * d.x() + d.y() * d.y();
    const Real md = o.x() * d.x() + o.y() * d.y();
    const Real rho = std::sqrt(o.x() * o.x() + o.y() * o.y());
    Piece piece;
    if (dd == 0) {
      if (rho > radius) piece.makeEmpty();
      return piece;
    }
    const Real turn = o.x() * d.y() - o.y() * d.x();
    Real first = 0, last = 0;
    if (!roundTimes(md, dd, (rho - radius) * (rho + radius), turn * turn / dd, radius, first,
                    last) ||
        last < 0) {
      if (rho > radius) piece.makeEmpty();
      return piece;
    }
    piece.leave = last;
    if (rho > radius) {
      piece.enter = first;
      const Vector3 at = o + first * d;
      piece.normal = Vector3(at.x(), at.y(), 0).normalized();
    }
    return piece;
  }

  Piece operator()(const Ball& ball) const {
    return round(Vector3::Zero(), ball.radius);
  }
  Piece operator()(const Box& box) const {
    Piece piece;
    for (int k = 0; k < 3; ++k) {
      piece.clip(o(k) - box.halfExtents(k), d(k), Vector3::Unit(k));
      piece.clip(-o(k) - box.halfExtents(k), -d(k), -Vector3::Unit(k));
    }
    return piece;
  }
  Piece operator()(const Cylinder& cylinder) const {
    Piece piece = wall(cylinder.radius);
    if (piece.empty()) return piece;
    piece.clip(o.z() - cylinder.halfHeight, d.z(), Vector3::UnitZ());
    piece.clip(-o.z() - cylinder.halfHeight, -d.z(), -Vector3::UnitZ());
    return piece;
  }
  // The union of two balls and the wall between them: the first entry of the three.
  Piece operator()(const Capsule& capsule) const {
    const Vector3 end(0, 0, capsule.halfLength);
    Piece best;
    best.makeEmpty();
    for (const Piece& piece : {(*this)(Cylinder{capsule.radius, capsule.halfLength}),
                               round(end, capsule.radius), round(-end, capsule.radius)}) {
      if (piece.empty()) continue;
      if (best.empty() || piece.enter < best.enter) best = piece;
    }
    return best;
  }
  Piece operator()(const ConvexHull& hull) const {
    Piece piece;
    for (const HullFace& face : hull.faces) {
      piece.clip(face.normal.dot(o) - face.offset, face.normal.dot(d), face.normal);
    }
    return piece;
  }
  Piece operator()(const HalfSpace& space) const {
    Piece piece;
    piece.clip(space.normal.dot(o) - space.offset, space.normal.dot(d), space.normal);
    return piece;
  }
  Piece operator()(const Compound& compound) const {
    Piece best;
    best.makeEmpty();
    for (const CompoundPart& part : compound.parts) {
      const Vector3 origin = pointToBody(part.pose, o), direction = directionToBody(part.pose, d);
      Piece piece = std::visit(Caster{origin, direction}, part.shape);
      if (piece.empty() || (!best.empty() && piece.enter >= best.enter)) continue;
      piece.normal = directionToWorld(part.pose, piece.normal);
      best = piece;
    }
    return best;
  }
};

RayHit hitOf(const Piece& piece, const Pose& pose, const Ray& ray, Real lengthOfDirection) {
  RayHit hit;
  const Real t = piece.enter / lengthOfDirection;
  if (piece.empty() || t > ray.reach) return hit;
  hit.hit = true;
  hit.startsInside = piece.normal.isZero(0);
  hit.t = t;
  hit.point = ray.origin + t * ray.direction;
  hit.normal = directionToWorld(pose, piece.normal);
  return hit;
}

void requireUsable(const Ray& ray) {
  requireFinite(ray.origin, "origin of the ray");
  requireFinite(ray.direction, "direction of the ray");
  if (ray.direction.isZero(0)) {
    reject("direction of the ray", toText(ray.direction), "must not be zero");
  }
  if (!(ray.reach >= 0)) reject("reach of the ray", toText(ray.reach), "must not be negative");
}

}  // namespace

RayHit castRay(const Shape& shape, const Pose& pose, const Ray& ray) {
  requireUsable(ray);
  const Real whole = ray.direction.stableNorm();
  const Vector3 origin = pointToBody(pose, ray.origin);
  const Vector3 direction = directionToBody(pose, ray.direction / whole);
  return hitOf(std::visit(Caster{origin, direction}, shape), pose, ray, whole);
}

PlanarRayHit castRay(const PlanarShape& shape, const PlanarPose& pose, const PlanarRay& ray) {
  const Ray spatial{
      {ray.origin.x(), ray.origin.y(), 0}, {ray.direction.x(), ray.direction.y(), 0}, ray.reach};
  // The plane's figures are slices of solids at z = 0: a disc of a ball, a polygon of its prism.
  struct Slices {
    const Ray& ray;
    RayHit operator()(const Disc& disc, const PlanarPose& placed) const {
      return castRay(Shape(Ball{disc.radius}), spatialPose(placed), ray);
    }
    RayHit operator()(const Polygon& polygon, const PlanarPose& placed) const {
      const Pose full = spatialPose(placed);
      const Real whole = ray.direction.stableNorm();
      const Vector3 o = pointToBody(full, ray.origin);
      const Vector3 d = directionToBody(full, ray.direction / whole);
      Piece piece;
      for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const Vector2& n = polygon.normals[i];
        piece.clip(n.dot(o.head<2>() - polygon.vertices[i]), n.dot(d.head<2>()), {n.x(), n.y(), 0});
      }
      return hitOf(piece, full, ray, whole);
    }
    RayHit operator()(const PlanarCompound& compound, const PlanarPose& placed) const {
      RayHit best;
      for (const PlanarCompoundPart& part : compound.parts) {
        const PlanarPose whole = composed(placed, part.pose);
        const RayHit hit =
            std::visit([&](const auto& figure) { return (*this)(figure, whole); }, part.shape);
        if (hit.hit && (!best.hit || hit.t < best.t)) best = hit;
      }
      return best;
    }
    static Pose spatialPose(const PlanarPose& p) {
      Pose full;
      full.R_WB(0, 0) = full.R_WB(1, 1) = p.cosine;
      full.R_WB(0, 1) = -p.sine;
      full.R_WB(1, 0) = p.sine;
      full.p_WB = {p.p_WB.x(), p.p_WB.y(), 0};
      return full;
    }
  };
  requireUsable(spatial);
  const Slices slices{spatial};
  const RayHit hit = std::visit([&](const auto& figure) { return slices(figure, pose); }, shape);
  return {hit.hit, hit.startsInside, hit.t, hit.point.head<2>(), hit.normal.head<2>()};
}

}  // namespace carom

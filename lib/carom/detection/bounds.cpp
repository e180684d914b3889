#include "carom/detection/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace carom {
namespace {

Aabb<3> about(const Vector3& center, const Vector3& reach) {
  return {center - reach, center + reach};
}

// Two doubles at once, which every processor that Carom runs on can compare without a branch.
using Two = Real __attribute__((vector_size(2 * sizeof(Real))));

Two twoAt(const std::vector<Real>& from, std::size_t i) {
  Two value;
  std::memcpy(&value, &from[i], sizeof value);
  return value;
}

// What a hull covers of a direction, before it is moved.
void cover(const ConvexHull& hull, const Vector3& direction, Real& low, Real& high) {
  const Two dx = {direction.x(), direction.x()};
  const Two dy = {direction.y(), direction.y()};
  const Two dz = {direction.z(), direction.z()};
  const std::size_t count = hull.x.size();
  // A last one without another is taken with its neighbour.
  const std::size_t last = count - 2;
  Two least = twoAt(hull.x, last) * dx + twoAt(hull.y, last) * dy + twoAt(hull.z, last) * dz;
  Two most = least;
  for (std::size_t i = 0; i + 2 < count; i += 2) {
    const Two along = twoAt(hull.x, i) * dx + twoAt(hull.y, i) * dy + twoAt(hull.z, i) * dz;
    least = along < least ? along : least;
    most = along > most ? along : most;
  }
  low = std::min(least[0], least[1]);
  high = std::max(most[0], most[1]);
}

struct Bounder {
  const Pose& pose;

  Aabb<3> operator()(const Ball& ball) const {
    return about(pose.p_WB, Vector3::Constant(ball.radius));
  }
  Aabb<3> operator()(const Box& box) const {
    return about(pose.p_WB, pose.R_WB.cwiseAbs() * box.halfExtents);
  }
  Aabb<3> operator()(const Capsule& capsule) const {
    const Vector3 axis = pose.R_WB.col(2).cwiseAbs() * capsule.halfLength;
    return about(pose.p_WB, axis + Vector3::Constant(capsule.radius));
  }
  Aabb<3> operator()(const Cylinder& cylinder) const {
    Vector3 reach;
    for (int k = 0; k < 3; ++k) {
      // The sine of the angle between the cylinder's axis and this one, without 1 - cos^2.
      const Real x = pose.R_WB(k, 0), y = pose.R_WB(k, 1), cosine = std::abs(pose.R_WB(k, 2));
      reach(k) = cosine * cylinder.halfHeight + std::sqrt(x * x + y * y) * cylinder.radius;
    }
    return about(pose.p_WB, reach);
  }
  Aabb<3> operator()(const ConvexHull& hull) const {
    Aabb<3> box;
    for (int k = 0; k < 3; ++k) cover(hull, pose.R_WB.row(k), box.low(k), box.high(k));
    return {box.low + pose.p_WB, box.high + pose.p_WB};
  }
  Aabb<3> operator()(const HalfSpace& space) const {
    constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
    Aabb<3> box = about(Vector3::Zero(), Vector3::Constant(kInfinity));
    const Vector3 normal = directionToWorld(pose, space.normal);
    const Real offset = space.offset + normal.dot(pose.p_WB);
    for (int k = 0; k < 3; ++k) {
      if (normal((k + 1) % 3) != 0 || normal((k + 2) % 3) != 0) continue;
      if (normal(k) > 0) box.high(k) = offset;
      if (normal(k) < 0) box.low(k) = -offset;
    }
    return box;
  }
  Aabb<3> operator()(const Compound& compound) const {
    Aabb<3> box;
    for (const CompoundPart& part : compound.parts) {
      box = joined(box, boundsOf(part.shape, composed(pose, part.pose)));
    }
    return box;
  }
};

struct PlanarBounder {
  const PlanarPose& pose;

  Aabb<2> operator()(const Disc& disc) const {
    const Vector2 reach(disc.radius, disc.radius);
    return {pose.p_WB - reach, pose.p_WB + reach};
  }
  Aabb<2> operator()(const Polygon& polygon) const {
    Aabb<2> box;
    for (const Vector2& vertex : polygon.vertices) box = joined(box, pointToWorld(pose, vertex));
    return box;
  }
  Aabb<2> operator()(const PlanarCompound& compound) const {
    Aabb<2> box;
    for (const PlanarCompoundPart& part : compound.parts) {
      const PlanarPose placed = composed(pose, part.pose);
      box = joined(box, std::visit(PlanarBounder{placed}, part.shape));
    }
    return box;
  }
};

}  // namespace

Aabb<3> boundsOf(const Shape& shape, const Pose& pose) {
  return std::visit(Bounder{pose}, shape);
}

Aabb<3> boundsOf(const ConvexShape& shape, const Pose& pose) {
  return std::visit(Bounder{pose}, shape);
}

Aabb<2> boundsOf(const PlanarShape& shape, const PlanarPose& pose) {
  return std::visit(PlanarBounder{pose}, shape);
}

}  // namespace carom

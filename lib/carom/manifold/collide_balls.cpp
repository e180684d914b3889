#include "carom/manifold/collide_balls.hpp"

#include "carom/core/length.hpp"
#include "carom/detection/closest_point.hpp"
#include "carom/detection/gjk.hpp"

namespace carom {
namespace {

void setPoint(const Vector3& normal, const Vector3& pointOfA, Real separation, Manifold& manifold) {
  manifold.normal = normal;
  manifold.count = 1;
  manifold.points[0].position = pointOfA + separation / 2 * normal;
  manifold.points[0].separation = separation;
  manifold.points[0].id = 0;
  manifold.areaCentroid = manifold.points[0].position;
}

}  // namespace

Manifold collideBalls(const Ball& a, const Pose& A, const Ball& b, const Pose& B, Real margin) {
  Manifold manifold;
  const Vector3 between = B.p_WB - A.p_WB;
  const Real distance = length(between);
  const Real separation = distance - (a.radius + b.radius);
  if (separation > margin) return manifold;
  const Vector3 normal = distance > 0 ? Vector3(between / distance) : Vector3(Vector3::UnitZ());
  setPoint(normal, A.p_WB + a.radius * normal, separation, manifold);
  return manifold;
}

Manifold detail::collideWithBallOf(const ShapeView& a, const Pose& A, const Ball& b, const Pose& B,
                                   Real margin) {
  Manifold manifold;
  if (const auto* ball = std::get_if<const Ball*>(&a)) {
    return collideBalls(**ball, A, b, B, margin);
  }
  if (const auto* hull = std::get_if<const ConvexHull*>(&a)) {
    const Separation gap = gjkOfCores(coreOf(**hull), A, coreOf(b), B, nullptr);
    if (gap.separation <= margin) setPoint(gap.normal, gap.pointA, gap.separation, manifold);
    return manifold;
  }
  // The other kinds are a few numbers, which may be copied.
  const auto copied = [](const auto* kind) -> ConvexShape {
    if constexpr (std::is_same_v<std::decay_t<decltype(*kind)>, ConvexHull>) {
      return Ball{};  // not reached
    } else {
      return *kind;
    }
  };
  const SurfacePoint nearest = closestPoint(std::visit(copied, a), A, B.p_WB);
  const Real separation = nearest.distance - b.radius;
  if (separation <= margin) setPoint(nearest.normal, nearest.point, separation, manifold);
  return manifold;
}

Manifold collideWithBall(const ConvexShape& a, const Pose& A, const Ball& b, const Pose& B,
                         Real margin) {
  return detail::collideWithBallOf(detail::viewOfShape(a), A, b, B, margin);
}

}  // namespace carom

#include "planar_touches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/manifold/collide_planar.hpp"

namespace carom {

Real timeToNextTouch(const PlanarWorld& world) {
  Real first = std::numeric_limits<Real>::infinity();
  for (auto a = world.bodies.begin(); a != world.bodies.end(); ++a) {
    const auto* disc = std::get_if<Disc>(&a->shape);
    if (disc == nullptr) continue;
    for (const PlanarWall& wall : world.walls) {
      const Real height = wall.normal.dot(a->position) - wall.offset - disc->radius;
      const Real speed = wall.normal.dot(a->motion.velocity.linear);
      if (speed < 0 && height > kTouching) first = std::min(first, height / -speed);
    }
    for (auto b = a + 1; b != world.bodies.end(); ++b) {
      const auto* other = std::get_if<Disc>(&b->shape);
      if (other == nullptr) continue;
      // |p + v t| = R, the earlier root, written so that nothing cancels.
      const Real R = disc->radius + other->radius;
      const Vector2 p = b->position - a->position;
      const Vector2 v = b->motion.velocity.linear - a->motion.velocity.linear;
      const Real gap = p.squaredNorm() - R * R, approach = p.dot(v);
      const Real root = approach * approach - v.squaredNorm() * gap;
      if (gap <= 2 * R * kTouching || approach >= 0 || root < 0) continue;
      first = std::min(first, gap / (std::sqrt(root) - approach));
    }
  }
  return first;
}

std::vector<PlanarTouch> findTouches(const PlanarWorld& world) {
  std::vector<PlanarTouch> touches;
  std::vector<PartManifold> manifolds;
  const int count = static_cast<int>(world.bodies.size());
  const auto body = [&](int i) { return world.bodies[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < count; ++i) {
    const PlanarWorldBody a = body(i);
    for (int j = i + 1; j < count; ++j) {
      const PlanarWorldBody b = body(j);
      const bool discs =
          std::holds_alternative<Disc>(a.shape) && std::holds_alternative<Disc>(b.shape);
      collidePlanar(a.shape, planarPoseOf(a.angle, a.position), b.shape,
                    planarPoseOf(b.angle, b.position), manifolds,
                    discs ? kTouching : kNearlyTouching);
      const ImpactLaw law{combineRestitution(a.restitution, b.restitution, world.rule),
                          std::sqrt(a.friction * b.friction)};
      for (const auto& [partA, partB, manifold] : manifolds) {
        for (int k = 0; k < manifold.count; ++k) {
          const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
          const Vector2 place = point.position.head<2>();
          const PlanarContact contact{manifold.normal.head<2>(), place - a.position,
                                      place - b.position};
          touches.push_back({i, j, contact, point.separation, law});
        }
      }
    }
    const auto* disc = std::get_if<Disc>(&a.shape);
    for (const PlanarWall& wall : world.walls) {
      const Real height = wall.normal.dot(a.position) - wall.offset;
      if (disc == nullptr || height > disc->radius + kTouching) continue;
      const ImpactLaw law{combineRestitution(wall.restitution, a.restitution, world.rule),
                          std::sqrt(wall.friction * a.friction)};
      const PlanarContact contact{wall.normal, {0, 0}, -disc->radius * wall.normal};
      touches.push_back({count, i, contact, height - disc->radius, law});
    }
  }
  return touches;
}

void pushApart(PlanarWorld& world, const std::vector<PlanarTouch>& touches) {
  for (const PlanarTouch& t : touches) {
    const bool deepest = std::all_of(touches.begin(), touches.end(), [&](const PlanarTouch& other) {
      return other.a != t.a || other.b != t.b || &other == &t || other.separation > t.separation ||
             (other.separation == t.separation && &other > &t);
    });
    PlanarWorldBody wall;
    const auto body = [&](int i) -> PlanarWorldBody& {
      const auto n = static_cast<std::size_t>(i);
      return n < world.bodies.size() ? world.bodies[n] : wall;
    };
    const Real ofA = body(t.a).motion.mass.inverseMass, ofB = body(t.b).motion.mass.inverseMass;
    if (!deepest || t.separation >= 0 || ofA + ofB == 0) continue;
    const Vector2 push = -t.separation / (ofA + ofB) * t.contact.normal;
    body(t.a).position -= ofA * push;
    body(t.b).position += ofB * push;
  }
}

}  // namespace carom

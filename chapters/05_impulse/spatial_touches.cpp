#include "spatial_touches.hpp"

#include <algorithm>
#include <cmath>

#include "carom/manifold/collide.hpp"

namespace carom {

std::vector<SpatialTouch> findTouches(SpatialWorld& world) {
  std::vector<SpatialTouch> touches;
  std::vector<PartManifold> manifolds;
  for (auto a = world.bodies.begin(); a != world.bodies.end(); ++a) {
    for (auto b = a + 1; b != world.bodies.end(); ++b) {
      if (a->motion.inverseMass == 0 && b->motion.inverseMass == 0) continue;
      collide(a->shape, poseOf(a->orientation, a->position), b->shape,
              poseOf(b->orientation, b->position), manifolds, {}, kNearlyTouching);
      for (const auto& [partA, partB, manifold] : manifolds) {
        SpatialTouch touch{&*a,
                           &*b,
                           {},
                           kNearlyTouching,
                           {combineRestitution(a->restitution, b->restitution, world.rule),
                            std::sqrt(a->friction * b->friction)}};
        for (int k = 0; k < manifold.count; ++k) {
          const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
          touch.separation = std::min(touch.separation, point.separation);
          touch.points.push_back(
              {manifold.normal, point.position - a->position, point.position - b->position});
        }
        touches.push_back(touch);
      }
    }
  }
  return touches;
}

void pushApart(SpatialWorld& world) {
  for (const SpatialTouch& t : findTouches(world)) {
    const Real ofA = t.a->motion.inverseMass, ofB = t.b->motion.inverseMass;
    if (t.separation >= 0) continue;
    const Vector3 push = -t.separation / (ofA + ofB) * t.points[0].normal;
    t.a->position -= ofA * push;
    t.b->position += ofB * push;
  }
}

}  // namespace carom

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <exception>
#include <memory>

#include "bench/narrowphase_peers.hpp"

namespace carom::bench {
namespace {

using Object = std::shared_ptr<fcl::CollisionObjectd>;

struct Objects {
  std::vector<Object> a, b;
};

Object object(const std::shared_ptr<fcl::CollisionGeometryd>& shape, const Pose& pose) {
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.linear() = pose.R_WB;
  X.translation() = pose.p_WB;
  return std::make_shared<fcl::CollisionObjectd>(shape, X);
}

std::shared_ptr<fcl::CollisionGeometryd> convex(const ConvexHull& hull) {
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vector3& v : hull.vertices) vertices->push_back(v);
  // Faces as FCL wants them: the number of corners, then the corners.
  const auto faces = std::make_shared<std::vector<int>>();
  for (const HullFace& face : hull.faces) {
    faces->push_back(face.count);
    for (std::int32_t i = 0; i < face.count; ++i) {
      faces->push_back(hull.halfEdges[static_cast<std::size_t>(face.firstHalfEdge + i)].origin);
    }
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.faces.size()), faces);
}

PairAnswer collide(const Objects& objects, std::size_t i) {
  PairAnswer answer;
  try {
    fcl::CollisionRequestd request(4, true);
    fcl::CollisionResultd result;
    fcl::collide(objects.a[i].get(), objects.b[i].get(), request, result);
    answer.hit = result.isCollision();
    answer.points = static_cast<int>(result.numContacts());
    for (std::size_t k = 0; k < result.numContacts(); ++k) {
      const auto& contact = result.getContact(k);
      if (k > 0 && -contact.penetration_depth >= answer.separation) continue;
      answer.separation = -contact.penetration_depth;
      answer.normal = contact.normal;
    }
  } catch (const std::exception&) {
    // No answer is a wrong one: the fields stay as they are.
  }
  return answer;
}

PairAnswer distance(const Objects& objects, std::size_t i) {
  PairAnswer answer;
  try {
    fcl::DistanceRequestd request(true, true);
    fcl::DistanceResultd result;
    answer.separation = fcl::distance(objects.a[i].get(), objects.b[i].get(), request, result);
    answer.hit = answer.separation <= 0;
  } catch (const std::exception&) {
  }
  return answer;
}

std::vector<PairMethod> methods(const std::shared_ptr<Objects>& objects) {
  return {{"FCL collide", [objects](std::size_t i) { return collide(*objects, i); }},
          {"FCL signed distance", [objects](std::size_t i) { return distance(*objects, i); }}};
}

}  // namespace

std::vector<PairMethod> fclBoxes(std::span<const BodyPair> pairs) {
  const auto objects = std::make_shared<Objects>();
  const auto box = [](const Vector3& half) {
    return std::make_shared<fcl::Boxd>(2 * half.x(), 2 * half.y(), 2 * half.z());
  };
  for (const BodyPair& pair : pairs) {
    objects->a.push_back(object(box(pair.halfA), pair.A));
    objects->b.push_back(object(box(pair.halfB), pair.B));
  }
  return methods(objects);
}

std::vector<PairMethod> fclHulls(const ConvexHull& a, const ConvexHull& b,
                                 std::span<const BodyPair> pairs) {
  const auto objects = std::make_shared<Objects>();
  const auto shapeA = convex(a), shapeB = convex(b);
  for (const BodyPair& pair : pairs) {
    objects->a.push_back(object(shapeA, pair.A));
    objects->b.push_back(object(shapeB, pair.B));
  }
  return methods(objects);
}

}  // namespace carom::bench

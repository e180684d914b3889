#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

#include "bench/narrowphase_peers.hpp"

namespace carom::bench {

std::vector<PairMethod> fclBoxes(std::span<const BodyPair> pairs) {
  struct Data {
    std::vector<std::shared_ptr<fcl::CollisionObjectd>> a, b;
  };
  const auto data = std::make_shared<Data>();
  const auto object = [](const Vector3& half, const Pose& pose) {
    fcl::Transform3d X = fcl::Transform3d::Identity();
    X.linear() = pose.R_WB;
    X.translation() = pose.p_WB;
    return std::make_shared<fcl::CollisionObjectd>(
        std::make_shared<fcl::Boxd>(2 * half.x(), 2 * half.y(), 2 * half.z()), X);
  };
  for (const BodyPair& pair : pairs) {
    data->a.push_back(object(pair.halfA, pair.A));
    data->b.push_back(object(pair.halfB, pair.B));
  }
  return {{"FCL collide",
           [data](std::size_t i) {
             fcl::CollisionRequestd request(4, true);
             fcl::CollisionResultd result;
             fcl::collide(data->a[i].get(), data->b[i].get(), request, result);
             PairAnswer answer;
             answer.hit = result.isCollision();
             answer.points = static_cast<int>(result.numContacts());
             for (std::size_t k = 0; k < result.numContacts(); ++k) {
               const auto& contact = result.getContact(k);
               if (k > 0 && -contact.penetration_depth >= answer.separation) continue;
               answer.separation = -contact.penetration_depth;
               answer.normal = contact.normal;
             }
             return answer;
           }},
          {"FCL distance", [data](std::size_t i) {
             fcl::DistanceRequestd request(true);
             fcl::DistanceResultd result;
             PairAnswer answer;
             answer.separation = fcl::distance(data->a[i].get(), data->b[i].get(), request, result);
             answer.hit = answer.separation <= 0;
             return answer;
           }}};
}

}  // namespace carom::bench

#include <ccd/ccd.h>
#include <ccd/quat.h>

#include <memory>

#include "bench/narrowphase_peers.hpp"

namespace carom::bench {
namespace {

// libccd asks for support points in the world; a box or a cloud of corners gives them.
struct Body {
  const Pose* pose = nullptr;
  Vector3 half = Vector3::Zero();
  const std::vector<Vector3>* corners = nullptr;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Body& body = *static_cast<const Body*>(object);
  const Vector3 d =
      body.pose->R_WB.transpose() * Vector3(direction->v[0], direction->v[1], direction->v[2]);
  Vector3 best;
  if (body.corners == nullptr) {
    for (int k = 0; k < 3; ++k) best(k) = d(k) >= 0 ? body.half(k) : -body.half(k);
  } else {
    best = body.corners->front();
    Real reach = d.dot(best);
    for (const Vector3& corner : *body.corners) {
      const Real along = d.dot(corner);
      if (along > reach) {
        reach = along;
        best = corner;
      }
    }
  }
  const Vector3 world = body.pose->R_WB * best + body.pose->p_WB;
  ccdVec3Set(point, world.x(), world.y(), world.z());
}

void center(const void* object, ccd_vec3_t* point) {
  const Vector3& p = static_cast<const Body*>(object)->pose->p_WB;
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

struct Bodies {
  std::vector<Body> a, b;
  ccd_t ccd;
  Bodies() {
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = support;
    ccd.center1 = ccd.center2 = center;
    ccd.max_iterations = 500;
    ccd.epa_tolerance = 1e-12;
  }
};

using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*,
                            ccd_vec3_t*);

std::vector<PairMethod> methods(const std::shared_ptr<Bodies>& bodies) {
  const auto penetration = [bodies](Penetration function) {
    return [bodies, function](std::size_t i) {
      ccd_real_t depth = 0;
      ccd_vec3_t direction, position;
      PairAnswer answer;
      answer.hit =
          function(&bodies->a[i], &bodies->b[i], &bodies->ccd, &depth, &direction, &position) == 0;
      if (answer.hit) {
        answer.separation = -depth;
        answer.normal = {direction.v[0], direction.v[1], direction.v[2]};
        answer.points = 1;
      }
      return answer;
    };
  };
  return {{"libccd GJK+EPA", penetration(&ccdGJKPenetration)},
          {"libccd MPR", penetration(&ccdMPRPenetration)},
          {"libccd intersect", [bodies](std::size_t i) {
             PairAnswer answer;
             answer.hit = ccdGJKIntersect(&bodies->a[i], &bodies->b[i], &bodies->ccd) != 0;
             return answer;
           }}};
}

}  // namespace

std::vector<PairMethod> ccdBoxes(std::span<const BodyPair> pairs) {
  const auto bodies = std::make_shared<Bodies>();
  for (const BodyPair& pair : pairs) {
    bodies->a.push_back({&pair.A, pair.halfA, nullptr});
    bodies->b.push_back({&pair.B, pair.halfB, nullptr});
  }
  return methods(bodies);
}

std::vector<PairMethod> ccdHulls(const ConvexHull& a, const ConvexHull& b,
                                 std::span<const BodyPair> pairs) {
  const auto bodies = std::make_shared<Bodies>();
  for (const BodyPair& pair : pairs) {
    bodies->a.push_back({&pair.A, Vector3::Zero(), &a.vertices});
    bodies->b.push_back({&pair.B, Vector3::Zero(), &b.vertices});
  }
  return methods(bodies);
}

}  // namespace carom::bench

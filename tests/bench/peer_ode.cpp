#include <ode/ode.h>

#include <array>
#include <memory>

#include "bench/narrowphase_peers.hpp"

namespace carom::bench {
namespace {

// ODE's vectors have four numbers, its matrices three rows of four.
struct Placed {
  dVector3 p, sides;
  dMatrix3 R;

  Placed(const Pose& pose, const Vector3& half) {
    for (int i = 0; i < 3; ++i) {
      p[i] = pose.p_WB(i);
      sides[i] = 2 * half(i);
      for (int j = 0; j < 3; ++j) R[4 * i + j] = pose.R_WB(i, j);
      R[4 * i + 3] = 0;
    }
    p[3] = sides[3] = 0;
  }
};

}  // namespace

std::vector<PairMethod> odeBoxes(std::span<const BodyPair> pairs) {
  struct Data {
    std::vector<Placed> a, b;
  };
  const auto data = std::make_shared<Data>();
  for (const BodyPair& pair : pairs) {
    data->a.emplace_back(pair.A, pair.halfA);
    data->b.emplace_back(pair.B, pair.halfB);
  }
  return {{"ODE dBoxBox", [data](std::size_t i) {
             constexpr int kMost = 8;
             const Placed &a = data->a[i], &b = data->b[i];
             std::array<dContactGeom, kMost> contacts;
             dVector3 normal;
             dReal depth = 0;
             int code = 0;
             PairAnswer answer;
             answer.points = dBoxBox(a.p, a.R, a.sides, b.p, b.R, b.sides, normal, &depth, &code,
                                     kMost, contacts.data(), sizeof(dContactGeom));
             answer.hit = answer.points > 0;
             if (answer.hit) {
               answer.separation = -depth;
               answer.normal = {normal[0], normal[1], normal[2]};
             }
             return answer;
           }}};
}

}  // namespace carom::bench

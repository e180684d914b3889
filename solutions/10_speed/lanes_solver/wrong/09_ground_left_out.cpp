#include "lanes_solver.hpp"

#include <string>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/core/lanes.hpp"

namespace carom {

namespace {

using Four = Lanes<Real, 4>;

Four lanesOf(const LaneValues& values) {
  return loaded<Four>(values.x.data());
}

}  // namespace

void lanesSolver(std::span<RowBlock> blocks, std::span<BodySpeeds> speeds) {
  for (const RowBlock& block : blocks) {
    for (const auto& who : {block.bodyA, block.bodyB}) {
      for (const std::int32_t body : who) {
        if (body < kNobody || body >= static_cast<std::int32_t>(speeds.size())) {
          reject("body", std::to_string(body), "must be one of the bodies, or nobody");
        }
      }
    }
  }
  const Four zero = everywhere<Four>(0);
  for (RowBlock& block : blocks) {
    // Speed i of the bodies of all four rows, side by side; nobody stands still.
    Four a[6], b[6];
    for (std::size_t i = 0; i < 6; ++i) {
      a[i] = b[i] = zero;
      for (std::size_t k = 0; k < kBlockLanes; ++k) {
        if (block.bodyA[k] != kNobody) a[i].v[k] = speeds[block.bodyA[k]].x[i];
        if (block.bodyB[k] != kNobody) b[i].v[k] = speeds[block.bodyB[k]].x[i];
      }
    }
    Four parting = zero;
    for (std::size_t i = 0; i < 6; ++i) parting += lanesOf(block.alongA[i]) * a[i];
    for (std::size_t i = 0; i < 6; ++i) parting += lanesOf(block.alongB[i]) * b[i];
    const Four old = lanesOf(block.impulse);
    const Four wanted = old + lanesOf(block.mass) * (lanesOf(block.target) - parting);
    // Where a lane holds no number, larger() takes its second argument.
    const Four total = larger(wanted, zero);
    const Four more = total - old;
    store(total, block.impulse.x.data());
    for (std::size_t i = 0; i < 6; ++i) {
      a[i] += more * lanesOf(block.changeA[i]);
      b[i] += more * lanesOf(block.changeB[i]);
      for (std::size_t k = 0; k < kBlockLanes; ++k) {
        if (block.bodyA[k] != kNobody && block.bodyB[k] != kNobody)
          speeds[block.bodyA[k]].x[i] = a[i].v[k];
        if (block.bodyB[k] != kNobody && block.bodyA[k] != kNobody)
          speeds[block.bodyB[k]].x[i] = b[i].v[k];
      }
    }
  }
}

}  // namespace carom

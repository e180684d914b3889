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
  for (RowBlock& block : blocks) {
    const auto speedOf = [&](std::int32_t body, std::size_t i) {
      return body == kNobody ? Real(0) : speeds[static_cast<std::size_t>(body)].x[i];
    };
    Four parting = everywhere<Four>(0);
    for (const bool first : {true, false}) {
      const auto& who = first ? block.bodyA : block.bodyB;
      for (std::size_t i = 0; i < 6; ++i) {
        LaneValues have;
        for (std::size_t k = 0; k < kBlockLanes; ++k) have.x[k] = speedOf(who[k], i);
        parting += lanesOf(first ? block.alongA[i] : block.alongB[i]) * lanesOf(have);
      }
    }
    const Four old = lanesOf(block.impulse);
    const Four wanted = old + lanesOf(block.mass) * (lanesOf(block.target) - parting);
    const Four total = select(wanted > everywhere<Four>(0), wanted, everywhere<Four>(0));
    store(total, block.impulse.x.data());
    for (const bool first : {true, false}) {
      const auto& who = first ? block.bodyA : block.bodyB;
      for (std::size_t i = 0; i < 6; ++i) {
        const Four more = (total - old) * lanesOf(first ? block.changeA[i] : block.changeB[i]);
        for (std::size_t k = 0; k < kBlockLanes; ++k) {
          if (who[k] != kNobody) speeds[static_cast<std::size_t>(who[k])].x[i] += more.v[k];
        }
      }
    }
  }
}

}  // namespace carom

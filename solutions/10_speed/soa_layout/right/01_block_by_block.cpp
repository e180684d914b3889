#include "soa_layout.hpp"

#include <string>

#include "carom/core/checks.hpp"

namespace carom {

std::vector<BodyBlock> soaLayout(std::span<const WholeBody> bodies) {
  std::vector<BodyBlock> blocks;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i % 4 == 0) blocks.emplace_back();
    const WholeBody& body = bodies[i];
    BodyBlock& block = blocks.back();
    for (int k = 0; k < 3; ++k) {
      block.position[static_cast<std::size_t>(k)].x[i % 4] = body.position[k];
      block.velocity[static_cast<std::size_t>(k)].x[i % 4] = body.velocity[k];
    }
    block.inverseMass.x[i % 4] = body.inverseMass;
  }
  return blocks;
}

void aosLayout(std::span<const BodyBlock> blocks, std::span<WholeBody> bodies) {
  if (blocks.size() != (bodies.size() + kBlockLanes - 1) / kBlockLanes) {
    reject("blocks", std::to_string(blocks.size()), "must be as many as the bodies take");
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BodyBlock& from = blocks[b];
    for (std::size_t lane = 0; lane < 4 && 4 * b + lane < bodies.size(); ++lane) {
      WholeBody& to = bodies[4 * b + lane];
      to.position =
          Vector3(from.position[0].x[lane], from.position[1].x[lane], from.position[2].x[lane]);
      to.velocity =
          Vector3(from.velocity[0].x[lane], from.velocity[1].x[lane], from.velocity[2].x[lane]);
      to.inverseMass = from.inverseMass.x[lane];
    }
  }
}

}  // namespace carom

#include "soa_layout.hpp"

#include <string>

#include "carom/core/checks.hpp"

namespace carom {

std::vector<BodyBlock> soaLayout(std::span<const WholeBody> bodies) {
  std::vector<BodyBlock> blocks(bodies.size() / kBlockLanes);
  for (std::size_t i = 0; i < blocks.size() * kBlockLanes; ++i) {
    BodyBlock& block = blocks[i / kBlockLanes];
    const std::size_t lane = i % kBlockLanes;
    for (std::size_t k = 0; k < 3; ++k) {
      block.position[k].x[lane] = bodies[i].position[k];
      block.velocity[k].x[lane] = bodies[i].velocity[k];
    }
    block.inverseMass.x[lane] = bodies[i].inverseMass;
  }
  return blocks;
}

void aosLayout(std::span<const BodyBlock> blocks, std::span<WholeBody> bodies) {
  if (blocks.size() != (bodies.size() + kBlockLanes - 1) / kBlockLanes) {
    reject("blocks", std::to_string(blocks.size()), "must be as many as the bodies take");
  }
  for (std::size_t i = 0; i < bodies.size() / kBlockLanes * kBlockLanes; ++i) {
    const BodyBlock& block = blocks[i / kBlockLanes];
    const std::size_t lane = i % kBlockLanes;
    for (std::size_t k = 0; k < 3; ++k) {
      bodies[i].position[k] = block.position[k].x[lane];
      bodies[i].velocity[k] = block.velocity[k].x[lane];
    }
    bodies[i].inverseMass = block.inverseMass.x[lane];
  }
}

}  // namespace carom

// Exercise 10.soa_layout: bodies side by side
// Check it with: ./course check 10.soa_layout

#include "soa_layout.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

std::vector<BodyBlock> soaLayout(std::span<const WholeBody> bodies) {
  // Body i goes to lane i % kBlockLanes of block i / kBlockLanes: block.position[k].x[lane].
  return todo<std::vector<BodyBlock>>("soaLayout");
}

void aosLayout(std::span<const BodyBlock> blocks, std::span<WholeBody> bodies) {
  if (blocks.size() != (bodies.size() + kBlockLanes - 1) / kBlockLanes) {
    reject("blocks", std::to_string(blocks.size()), "must be as many as the bodies take");
  }
  // Position, velocity and inverse mass of each body come back; nothing else changes.
  return todo<void>("aosLayout");
}

}  // namespace carom

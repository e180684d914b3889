// Exercise 10.lanes_solver: four rows at once
// Check it with: ./course check 10.lanes_solver

#include "lanes_solver.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/lanes.hpp"
#include "carom/core/todo.hpp"

namespace carom {

namespace {

using Four = Lanes<Real, 4>;

// Four numbers of a block as lanes; store(lanes, values.x.data()) writes them back.
[[maybe_unused]] Four lanesOf(const LaneValues& values) {
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
  // solveRow() in plain_row.hpp says what is to be done with each row, and in which order.
  // Lanes have + - * /, larger(a, b), everywhere<Four>(x); lane k of a is a.v[k].
  return todo<void>("lanesSolver");
}

}  // namespace carom

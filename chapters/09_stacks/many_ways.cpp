#include "many_ways.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "carom/solver/island_newton.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "gradient_sweep.hpp"
#include "shock_propagation.hpp"

namespace carom {

namespace {

using Pass = std::function<void(BoxColumn&)>;

Real fastest(const std::vector<MovingBody>& bodies) {
  Real speed = 0;
  for (const MovingBody& body : bodies) speed = std::max(speed, body.velocity.linear.norm());
  return speed;
}

WayResult byPasses(const std::string& name, BoxColumn column, Real slow, const Pass& pass) {
  constexpr int kMost = 100'000;
  WayResult result{name, 0, 0, {fastest(column.bodies)}};
  while (result.speeds.back() > slow && result.passes < kMost) {
    pass(column);
    ++result.passes;
    result.speeds.push_back(fastest(column.bodies));
  }
  result.ground = column.rows[0].impulse;
  return result;
}

// Newton's method wants blocks: here of one point, without friction.
WayResult byNewton(const BoxColumn& column) {
  std::vector<MovingBody> bodies = column.bodies;
  std::vector<ContactBlock> blocks;
  for (const ContactRow& row : column.rows) {
    ContactPatch patch;
    patch.bodyA = row.bodyA;
    patch.bodyB = row.bodyB;
    patch.normal = row.contact.normal;
    patch.count = 1;
    blocks.push_back(prepareBlock(patch, bodies));
  }
  WayResult result{"Newton's method", 0, 0, {fastest(bodies)}};
  IslandNewton newton;
  result.passes = newton.solve(bodies, blocks, {}).rounds;
  result.speeds.push_back(fastest(bodies));
  result.ground = blocks[0].impulses[0];
  return result;
}

}  // namespace

std::vector<WayResult> manyWays(const BoxColumn& column, Real slow) {
  GradientMemory memory;
  return {byPasses("sweeps", column, slow,
                   [](BoxColumn& c) { sequentialImpulses(c.bodies, c.rows, 1); }),
          byPasses("conjugate gradients", column, slow,
                   [&](BoxColumn& c) { gradientSweep(c.bodies, c.rows, memory); }),
          byPasses("shock propagation", column, slow,
                   [](BoxColumn& c) { shockPropagation(c.bodies, c.rows, 1); }),
          byNewton(column)};
}

}  // namespace carom

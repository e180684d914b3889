#include "carom/solver/solve_island.hpp"

#include <algorithm>

#include "carom/solver/hold_block.hpp"

namespace carom {

IslandSolution solveIsland(IslandNewton& newton, std::span<MovingBody> bodies,
                           std::span<ContactBlock> blocks, const IslandLimits& limits) {
  constexpr Real kSettled = 1e-9;  // of the fastest
  constexpr int kHeld = 2;         // visits of each row that holding a block is worth
  IslandSolution done;
  const auto sweep = [&](const SweepLimits& sweeps) {
    const Sweeps swept = solvePatches(bodies, blocks, sweeps);
    done.rows += swept.rows;
    done.settled = swept.change <= kSettled * sweeps.speed;
    return swept;
  };
  if (!limits.direct) {
    sweep(limits.sweeps);
    return done;
  }
  const auto look = [&] {
    done.looked = true;
    return newton.errorOf(bodies, blocks, limits.sweeps.speed).small;
  };
  if (look()) {
    done.settled = true;
    return done;
  }
  if (blocks.size() == 1 && holdBlock(bodies, blocks.front())) {
    done.rows += kHeld * (blocks.front().count + blocks.front().rubs);
    if (look()) {
      done.settled = true;
      return done;
    }
  }
  // As many as a few bodies need. What has come to its end by then is not looked at again.
  constexpr int kFew = 12;
  const Real tolerance = limits.sweeps.tolerance, speed = limits.sweeps.speed;
  const auto goOn = [&](int sweeps) {
    return sweep({.least = sweeps, .tolerance = tolerance, .speed = speed}).change;
  };
  Real change = goOn(kFew);
  // Where something rubs and slips or moves there is one answer, and to sweep on takes less than to
  // solve it directly as long as that gains. What stands may have many answers, of which the direct
  // solution is the even one; and without friction it is found in a few rounds.
  const auto any = [&](auto&& is) { return std::any_of(blocks.begin(), blocks.end(), is); };
  const bool rubs = any([](const ContactBlock& block) { return block.rubs > 0; });
  const bool sweepsOn =
      rubs && (limits.moves || any([](const ContactBlock& block) { return block.slips; }));
  constexpr Real kGain = 1.0 / 3;
  constexpr Real kAlmost = 1e-11;  // of the fastest: only rounding is left
  bool gains = sweepsOn;
  while (gains && change > tolerance * speed) {
    const Real last = change;
    change = goOn(2 * kFew);
    gains = change < kGain * last;
  }
  if (change <= (sweepsOn ? kAlmost : tolerance) * speed) {
    look();
    return done;
  }
  if (look()) {
    done.settled = true;
    return done;
  }
  // A body alone has no load to hand on: sweeps end, or there is no end (Painlevé 1895).
  const auto joins = [&](const ContactBlock& block) {
    const auto moves = [&](int body) {
      return bodies[static_cast<std::size_t>(body)].mass.inverseMass > 0;
    };
    return moves(block.bodyA) && moves(block.bodyB);
  };
  const bool alone = std::none_of(blocks.begin(), blocks.end(), joins);
  if (!limits.newton || alone) {
    // Rows. Four corners that rub want four hundred; what has not ended by then never does, and to
    // go on took a tipping box five times as long, for the same motion.
    constexpr int kAlone = 3000;
    SweepLimits sweeps = limits.sweeps;
    if (alone) sweeps.rowBudget = std::min(sweeps.rowBudget, kAlone);
    sweep(sweeps);
    look();
    return done;
  }
  const NewtonResult result =
      newton.solve(bodies, blocks, {.work = limits.directWork, .speed = speed});
  done.factorisations = result.factorisations;
  done.directWork = result.work;
  done.direct = done.settled = result.solved;
  if (!result.solved) {
    sweep(limits.sweeps);
    look();
  }
  return done;
}

}  // namespace carom

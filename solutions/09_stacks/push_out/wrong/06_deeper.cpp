#include "push_out.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/solver/sequential_impulses.hpp"

namespace carom {

std::vector<Velocity> pushOut(std::span<const MovingBody> bodies, std::span<const ContactRow> rows,
                              Real share, int sweeps) {
  if (!(share >= 0 && share <= 1)) reject("share", toText(share), "must be from 0 to 1");
  std::vector<MovingBody> ghosts(bodies.begin(), bodies.end());
  std::vector<ContactRow> wishes(rows.begin(), rows.end());
  for (MovingBody& ghost : ghosts) ghost.velocity = {};
  for (ContactRow& wish : wishes) {
    wish.impulse = 0;
    wish.target = wish.separation < 0 ? share * wish.separation : -wish.separation;
  }
  sequentialImpulses(ghosts, wishes, sweeps);
  std::vector<Velocity> moves;
  for (const MovingBody& ghost : ghosts) moves.push_back(ghost.velocity);
  return moves;
}

}  // namespace carom

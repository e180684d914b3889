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
  ghosts.clear();
  for (const MovingBody& body : bodies) ghosts.push_back({body.mass, Velocity{}});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Real overlap = std::max(Real(0), -rows[i].separation);
    const Real gap = std::max(Real(0), rows[i].separation);
    wishes[i].target = share * overlap - gap;
    wishes[i].impulse = 0;
  }
  sequentialImpulses(ghosts, wishes, sweeps);
  std::vector<Velocity> moves;
  for (const MovingBody& ghost : ghosts) moves.push_back(ghost.velocity);
  return moves;
}

}  // namespace carom

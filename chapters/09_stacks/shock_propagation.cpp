#include "shock_propagation.hpp"

#include <algorithm>
#include <vector>

#include "carom/solver/sequential_impulses.hpp"

namespace carom {

namespace {

// How many contacts each body is away from what cannot be moved; as many as
// there are bodies if nothing holds it.
std::vector<int> levelsOf(std::span<const MovingBody> bodies, std::span<const ContactRow> rows) {
  const int far = static_cast<int>(bodies.size());
  std::vector<int> levels;
  for (const MovingBody& body : bodies) levels.push_back(body.mass.inverseMass > 0 ? far : 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const ContactRow& row : rows) {
      int& a = levels[static_cast<std::size_t>(row.bodyA)];
      int& b = levels[static_cast<std::size_t>(row.bodyB)];
      changed = changed || a > b + 1 || b > a + 1;
      a = std::min(a, b + 1);
      b = std::min(b, a + 1);
    }
  }
  return levels;
}

}  // namespace

void shockPropagation(std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps) {
  const std::vector<int> levels = levelsOf(bodies, rows);
  const auto levelOf = [&](int body) { return levels[static_cast<std::size_t>(body)]; };
  std::vector<BodyMass> masses;
  for (const MovingBody& body : bodies) masses.push_back(body.mass);
  for (int level = 1; level <= static_cast<int>(bodies.size()); ++level) {
    std::vector<ContactRow> here;
    for (const ContactRow& row : rows) {
      if (std::max(levelOf(row.bodyA), levelOf(row.bodyB)) == level) here.push_back(row);
    }
    sequentialImpulses(bodies, here, sweeps);
    auto done = here.begin();
    for (ContactRow& row : rows) {
      if (std::max(levelOf(row.bodyA), levelOf(row.bodyB)) == level) row = *done++;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (levels[i] == level) bodies[i].mass = BodyMass();
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].mass = masses[i];
}

}  // namespace carom

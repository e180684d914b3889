// Grader of 06.pair_forces: two particles by hand, crowds whose forces must be the slopes of their
// energy, and crowds that are shifted through the walls of their box.

#include "carom/motion/pair_forces.hpp"

#include <cmath>

#include "grading/fields_motion.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

using Points = std::vector<Vector3>;
const Vector3 kNoBox(0, 0, 0);

// The potential at the cut-off, by which it is lifted.
Real lift(const LennardJones& atoms) {
  return 4 * atoms.depth * (std::pow(atoms.cutoff, -12) - std::pow(atoms.cutoff, -6));
}

void ask(const Points& positions, const LennardJones& atoms, const Vector3& box,
         const CrowdForces& expected, const char* what) {
  GRADE(pairForces(positions, atoms, box), expected, within(1e-12, kRounding),
        given("positions", positions, "m"), given("atoms", atoms, "(J, m, 1)"),
        given("box", box, "m"), unit("(N, J)"), about(what));
}

// Eight particles near the corners of a cube, none too near to another.
Points anyCrowd(Random& random, Real spacing) {
  Points all;
  for (int n = 0; n < 8; ++n) {
    const Vector3 corner(n & 1, (n >> 1) & 1, (n >> 2) & 1);
    all.push_back(spacing * corner + random.vector(0.08 * spacing));
  }
  return all;
}

// Less energy in the direction of the force: what the energy loses when one particle moves.
Points slopes(Points positions, const LennardJones& atoms, const Vector3& box) {
  const Real h = 1e-5;
  Points down;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Vector3 force;
    for (int axis = 0; axis < 3; ++axis) {
      const Real here = positions[i][axis];
      positions[i][axis] = here - h;
      const Real before = pairForces(positions, atoms, box).energy;
      positions[i][axis] = here + h;
      const Real after = pairForces(positions, atoms, box).energy;
      positions[i][axis] = here;
      force[axis] = (before - after) / (2 * h);
    }
    down.push_back(force);
  }
  return down;
}

}  // namespace

TEST_CASE("two") {
  const LennardJones atoms = {1, 1, 2.5}, heavy = {2, 0.6, 3};
  ask({{0, 0, 0}, {1, 0, 0}}, atoms, kNoBox, {{{-24, 0, 0}, {24, 0, 0}}, -lift(atoms)},
      "a distance of one size: they push each other with 24 depth/size");
  // (1/r)^6 = 1/2: the bottom of the potential.
  const Real bottom = std::pow(2, 1.0 / 6);
  ask({{0, 0, 1}, {0, bottom, 1}}, atoms, kNoBox, {{{0, 0, 0}, {0, 0, 0}}, -1 - lift(atoms)},
      "at the bottom of the potential");
  // A distance of 1.2 m is two sizes: (s/r)^6 = 1/64, and the direction is (0, 0.6, 0.8).
  const Real pull = 24 * 2 * (1.0 / 64 - 2.0 / 4096) / 1.2;
  ask({{1, 1, 1}, {1, 1.72, 1.96}}, heavy, kNoBox,
      {{{0, 0.6 * pull, 0.8 * pull}, {0, -0.6 * pull, -0.8 * pull}},
       8 * (1.0 / 4096 - 1.0 / 64) - lift(heavy)},
      "two sizes apart: they pull each other");
}

TEST_CASE("crowd") {
  Random random(seed());
  for (int n = 0; n < 3; ++n) {
    const LennardJones atoms = {random.between(0.5, 2), random.between(0.5, 2), 2.5};
    const Points crowd = anyCrowd(random, 1.25 * atoms.size);
    GRADE(pairForces(crowd, atoms, kNoBox).forces, slopes(crowd, atoms, kNoBox),
          within(1e-5, "taken from two energies 0.02 mm apart"), given("positions", crowd, "m"),
          given("atoms", atoms, "(J, m, 1)"), unit("N"),
          about("the force on each particle is what your energy loses per metre when it moves"));
  }
  // A triangle with sides of one size: 24 depth/size along each side.
  const Real h = std::sqrt(0.75), along = 24 * h * 2;
  const LennardJones atoms = {1, 1, 2.5};
  const Points triangle = {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}};
  ask(triangle, atoms, kNoBox,
      {{{-36, -24 * h, 0}, {36, -24 * h, 0}, {0, along, 0}}, -3 * lift(atoms)},
      "three particles, each a size from the others");
}

TEST_CASE("box") {
  const LennardJones atoms = {1, 1, 2.5};
  ask({{0.2, 1, 1}, {5.7, 1, 1}}, atoms, {6.5, 0, 0}, {{{24, 0, 0}, {-24, 0, 0}}, -lift(atoms)},
      "through the wall they are one size apart");
  ask({{0.2, 1, 1}, {5.7 + 26, 1, 1}}, atoms, {6.5, 0, 0},
      {{{24, 0, 0}, {-24, 0, 0}}, -lift(atoms)}, "the same, after one of them has gone far");
  Random random(seed() + 1);
  for (int n = 0; n < 3; ++n) {
    // A crowd in the middle of its box has no neighbours through the walls; shifted into a corner
    // and wrapped it is the same crowd.
    const Points crowd = anyCrowd(random, 1.25);
    const Vector3 box(6.5, 7, 8);
    Points wrapped;
    for (const Vector3& p : crowd) {
      Vector3 q = p - Vector3(0.6, 0.7, 0.5);
      for (int axis = 0; axis < 3; ++axis) q[axis] -= box[axis] * std::floor(q[axis] / box[axis]);
      wrapped.push_back(q);
    }
    GRADE(pairForces(wrapped, atoms, box).forces, slopes(crowd, atoms, kNoBox),
          within(1e-5, "taken from two energies 0.02 mm apart"), given("positions", wrapped, "m"),
          given("box", box, "m"), unit("N"),
          about("a crowd in the corner of its box: the forces that it has where no wall is"));
  }
}

TEST_CASE("refuses") {
  const Points same = {{1, 2, 3}, {1, 2, 3}}, images = {{0, 2, 3}, {6, 2, 3}};
  GRADE_REFUSES(pairForces(same, {1, 1, 2.5}, kNoBox), given("positions", same, "m"));
  GRADE_REFUSES(pairForces(images, {1, 1, 2.5}, {6, 0, 0}), given("positions", images, "m"),
                given("box", Vector3(6, 0, 0), "m"));
}

PROBES() {
  Random random(610);
  for (int n = 0; n < 16; ++n) {
    const LennardJones atoms = {random.between(0.5, 2), random.between(0.8, 1.1), 2.5};
    // Neighbours as they are, and neighbours through the walls alone.
    PROBE(pairForces(anyCrowd(random, n % 2 == 0 ? 1.5 : 3.6), atoms, {6, 5.6, 0}));
  }
}

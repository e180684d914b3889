// Crowds of particles: forces from cells and lists, and their motion.

#include "carom/motion/particles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/pair_forces.hpp"
#include "carom/motion/particle_lattice.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "support/catch.hpp"
#include "support/counted_memory.hpp"

using namespace carom;
using carom_test::allocations;
using carom_test::ContainsSubstring;

namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr Edge P = Edge::Periodic, W = Edge::Wall, F = Edge::Flat;

// The edges of the box as pairForces() wants them: zero where nothing is periodic.
Vector3 periodicEdges(const ParticleBox& box) {
  Vector3 edges = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (box.edges[static_cast<std::size_t>(axis)] == P) edges[axis] = box.size[axis];
  }
  return edges;
}

Real distanceIn(const ParticleBox& box, const Vector3& a, const Vector3& b) {
  Vector3 d = b - a;
  const Vector3 edges = periodicEdges(box);
  for (int axis = 0; axis < 3; ++axis) {
    if (edges[axis] != 0) d[axis] -= edges[axis] * std::round(d[axis] / edges[axis]);
  }
  return d.norm();
}

// Points anywhere in the box, none nearer to another than a distance; some exactly on an edge of
// the box or on the border of a cell.
std::vector<Vector3> crowdIn(const ParticleBox& box, Random& random, int tries, Real apart) {
  std::vector<Vector3> positions;
  for (int i = 0; i < tries; ++i) {
    Vector3 p = Vector3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      if (box.edges[static_cast<std::size_t>(axis)] == F) continue;
      const std::array<Real, 6> special = {0, 1, 0.5, 1.0 / 3, 0.25, std::nextafter(1.0, 0.0)};
      const int choice = random.integer(0, 11);
      const Real part =
          choice < 6 ? special[static_cast<std::size_t>(choice)] : random.between(0, 1);
      // Not in a wall.
      const Real margin = box.edges[static_cast<std::size_t>(axis)] == W ? 0.35 * apart : 0;
      p[axis] = std::clamp(part * box.size[axis], margin, box.size[axis] - margin);
    }
    const auto tooNear = [&](const Vector3& q) { return distanceIn(box, p, q) < apart; };
    if (std::none_of(positions.begin(), positions.end(), tooNear)) positions.push_back(p);
  }
  return positions;
}

// Walls: each particle and its image, which only push each other and share their energy.
void addWalls(CrowdForces& all, const std::vector<Vector3>& positions, const ParticleRules& rules) {
  LennardJones pushing = rules.atoms;
  pushing.cutoff = std::pow(2.0, 1.0 / 6);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (rules.box.edges[static_cast<std::size_t>(axis)] != W) continue;
      for (const Real wall : {Real(0), rules.box.size[axis]}) {
        Vector3 image = positions[i];
        image[axis] = 2 * wall - image[axis];
        const CrowdForces pair = pairForces(std::vector<Vector3>{positions[i], image}, pushing);
        all.forces[i] += pair.forces[0];
        all.energy += pair.energy / 2;
      }
    }
  }
}

// Largest difference of forces and of energy from those of all pairs, relative to the largest force
// and in units of the rounding of a coordinate. The force goes like the 13th power of a distance
// which may be somewhat less than the size: so an error of 100 is that of a few roundings.
Real errorAgainstAllPairs(const Particles& particles, const ParticleRules& rules) {
  std::vector<Vector3> positions;
  for (std::size_t i = 0; i < particles.count(); ++i) positions.push_back(particles.position(i));
  CrowdForces all = pairForces(positions, rules.atoms, periodicEdges(rules.box));
  addWalls(all, positions, rules);
  Real largest = 0, error = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    largest = std::max(largest, all.forces[i].norm());
    error = std::max(error, (particles.force(i) - all.forces[i]).norm());
  }
  const Real energy = std::abs(particles.totals().potential - all.energy);
  REQUIRE(largest > 0);
  const Real rounding = std::numeric_limits<Real>::epsilon() * rules.box.size.maxCoeff();
  return std::max(error * rules.atoms.size, energy) / largest / rounding;
}

LatticeStart startOf(std::array<int, 3> sites, std::array<Edge, 3> edges, Real temperature = 1,
                     Real density = 0.5) {
  return latticeStart(
      {.sites = sites, .density = density, .temperature = temperature, .edges = edges});
}

Particles particlesOf(const LatticeStart& start, ParticleRules rules = {}) {
  rules.box = start.box;
  return Particles(start.positions, start.velocities, rules);
}

// Greatest distance of the energy from its value at the start.
Real energyError(Particles& particles, Real dt, int steps) {
  const Real before = particles.totals().energy();
  Real error = 0;
  for (int i = 0; i < steps; ++i) {
    REQUIRE(particles.velocityVerletStep(dt) == ParticleStatus::Moved);
    error = std::max(error, std::abs(particles.totals().energy() - before));
  }
  return error;
}

}  // namespace

TEST_CASE("cells and lists give the forces of all pairs, in boxes of every kind") {
  Random random(11);
  const std::vector<std::array<Edge, 3>> kinds = {{P, P, P}, {W, W, W}, {P, W, P}, {W, P, W},
                                                  {P, P, F}, {W, W, F}, {F, P, W}, {P, F, F}};
  // Two cut-offs, the least a periodic box may have: one cell, or two with a thin skin; and more.
  for (const Vector3& size : {Vector3(5, 5, 5), Vector3(5, 5.8, 9), Vector3(13, 5, 6.1),
                              Vector3(16, 11, 8), Vector3(5, 40, 5)}) {
    for (const std::array<Edge, 3>& edges : kinds) {
      for (const Real skin : {0.0, 0.3, 2.5}) {
        const ParticleRules rules = {.box = {size, edges}, .skin = skin};
        const std::vector<Vector3> positions = crowdIn(rules.box, random, 250, 0.8);
        const std::vector<Vector3> still(positions.size(), Vector3::Zero());
        const Particles particles(positions, still, rules);
        CAPTURE(size.transpose(), skin, positions.size());
        REQUIRE(errorAgainstAllPairs(particles, rules) < 100);
      }
    }
  }
}

TEST_CASE("other atoms, other units: the forces are still those of all pairs") {
  Random random(12);
  const ParticleRules rules = {.atoms = {3e-21, 3.4e-10, 3.1},
                               .mass = 6.6e-26,
                               .box = {Vector3(4e-9, 3e-9, 5e-9), {P, W, P}},
                               .skin = 0.3};
  const std::vector<Vector3> positions = crowdIn(rules.box, random, 400, 3.0e-10);
  const Particles particles(positions, std::vector<Vector3>(positions.size(), Vector3::Zero()),
                            rules);
  CHECK(errorAgainstAllPairs(particles, rules) < 100);
}

TEST_CASE("a crowd that moves keeps the forces of all pairs, however old its list is") {
  const std::vector<std::array<Edge, 3>> kinds = {{P, P, P}, {W, P, W}};
  for (const std::array<Edge, 3>& edges : kinds) {
    for (const Real skin : {0.0, 0.2, 1.0}) {
      const LatticeStart start = startOf({6, 5, 7}, edges, 2);
      const ParticleRules rules = {.box = start.box, .skin = skin};
      Particles particles(start.positions, start.velocities, rules);
      for (int i = 0; i < 300; ++i) {
        REQUIRE(particles.velocityVerletStep(0.005) == ParticleStatus::Moved);
        // On the lattice the forces nearly cancel, and rounding is all that is left of them.
        if (i > 50 && i % 7 == 0) REQUIRE(errorAgainstAllPairs(particles, rules) < 100);
      }
      CHECK(particles.listsMade() > 5);
      CHECK(particles.listsMade() <= 301);
      if (skin == 0) CHECK(particles.listsMade() == 301);
    }
  }
}

TEST_CASE("each step is that of the chapter's method, with the forces of all pairs") {
  const LatticeStart start = startOf({4, 5, 4}, {P, P, P}, 1.3);
  const ParticleRules rules = {.mass = 1.7, .box = start.box};
  const auto n = static_cast<Eigen::Index>(start.positions.size());
  const Acceleration acceleration = [&](Real, const Coordinates& x,
                                        const Coordinates&) -> Coordinates {
    std::vector<Vector3> positions;
    for (Eigen::Index i = 0; i < n; ++i) positions.push_back(x.segment<3>(3 * i));
    const CrowdForces crowd = pairForces(positions, rules.atoms, rules.box.size);
    Coordinates a(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      a.segment<3>(3 * i) = crowd.forces[static_cast<std::size_t>(i)] / rules.mass;
    }
    return a;
  };
  using Step = ParticleStatus (Particles::*)(Real);
  using Method = State (*)(const State&, Real, Real, const Acceleration&);
  const std::vector<std::pair<Step, Method>> pairs = {
      {&Particles::velocityVerletStep, velocityVerlet},
      {&Particles::semiImplicitEulerStep, semiImplicitEuler},
      {&Particles::explicitEulerStep, explicitEuler}};
  for (const auto& [step, method] : pairs) {
    Particles particles(start.positions, start.velocities, rules);
    State state{Coordinates(3 * n), Coordinates(3 * n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      state.position.segment<3>(3 * i) = start.positions[static_cast<std::size_t>(i)];
      state.velocity.segment<3>(3 * i) = start.velocities[static_cast<std::size_t>(i)];
    }
    for (int i = 0; i < 40; ++i) {
      REQUIRE((particles.*step)(0.005) == ParticleStatus::Moved);
      state = method(state, i * 0.005, 0.005, acceleration);
    }
    Real error = 0;
    for (std::size_t i = 0; i < particles.count(); ++i) {
      const auto at = static_cast<Eigen::Index>(3 * i);
      error = std::max(error,
                       distanceIn(rules.box, particles.position(i), state.position.segment<3>(at)));
      error = std::max(error, (particles.velocity(i) - state.velocity.segment<3>(at)).norm());
    }
    CHECK(error < 1e-11);
  }
}

TEST_CASE("velocity Verlet holds the energy of a crowd for 20 000 steps, in 3D and in 2D") {
  for (const bool flat : {false, true}) {
    const LatticeStart start = flat ? startOf({8, 8, 1}, {P, P, F}) : startOf({4, 4, 4}, {P, P, P});
    Particles particles = particlesOf(start);
    for (int i = 0; i < 200; ++i) particles.velocityVerletStep(0.005);  // the lattice melts
    CHECK(energyError(particles, 0.005, 20000) < 5e-3 * static_cast<Real>(particles.count()));
    // To rounding: 20 000 steps, each with an error of a bit or so.
    CHECK(particles.totals().momentum.norm() < 1e-11);
  }
}

TEST_CASE("half the step makes a quarter of the energy's error") {
  // A warm lattice that does not melt, and a cut-off so far out that its jump does not count.
  const LatticeStart start = startOf({6, 6, 6}, {P, P, P}, 0.1, 1.0);
  std::vector<Real> errors;
  for (const int parts : {1, 2, 4}) {
    ParticleRules rules;
    rules.atoms.cutoff = 3;
    Particles particles = particlesOf(start, rules);
    errors.push_back(energyError(particles, 0.01 / parts, 200 * parts));
  }
  CHECK(errors[0] / errors[1] > 3.5);
  CHECK(errors[0] / errors[1] < 4.5);
  CHECK(errors[1] / errors[2] > 3.5);
  CHECK(errors[1] / errors[2] < 4.5);
}

TEST_CASE("a crowd that is turned round goes back where it came from") {
  const std::vector<std::array<Edge, 3>> kinds = {{P, P, P}, {W, W, W}};
  for (const std::array<Edge, 3>& edges : kinds) {
    const LatticeStart start = startOf({5, 5, 5}, edges);
    Particles particles = particlesOf(start);
    for (int i = 0; i < 200; ++i) particles.velocityVerletStep(0.005);
    Real away = 0;
    for (std::size_t i = 0; i < particles.count(); ++i) {
      away = std::max(away, distanceIn(start.box, particles.position(i), start.positions[i]));
    }
    particles.reverse();
    for (int i = 0; i < 200; ++i) particles.velocityVerletStep(0.005);
    Real error = 0;
    for (std::size_t i = 0; i < particles.count(); ++i) {
      error = std::max(error, distanceIn(start.box, particles.position(i), start.positions[i]));
      error = std::max(error, (particles.velocity(i) + start.velocities[i]).norm());
    }
    CHECK(away > 1);
    CHECK(error < 1e-9);
  }
}

TEST_CASE("the same crowd gives the same bits each time") {
  const LatticeStart start = startOf({6, 6, 6}, {P, W, P}, 1.5);
  Particles one = particlesOf(start), other = particlesOf(start);
  for (int i = 0; i < 500; ++i) {
    one.velocityVerletStep(0.005);
    other.velocityVerletStep(0.005);
  }
  for (std::size_t i = 0; i < one.count(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      REQUIRE(std::bit_cast<std::uint64_t>(one.position(i)[axis]) ==
              std::bit_cast<std::uint64_t>(other.position(i)[axis]));
    }
  }
}

TEST_CASE("a step takes no memory, also one that makes a new list") {
  const LatticeStart start = startOf({10, 10, 10}, {P, W, P});
  Particles particles = particlesOf(start);
  for (int i = 0; i < 300; ++i) particles.velocityVerletStep(0.005);
  const std::size_t before = allocations, lists = particles.listsMade();
  for (int i = 0; i < 300; ++i) particles.velocityVerletStep(0.005);
  const std::size_t taken = allocations - before;
  CHECK(taken == 0);
  CHECK(particles.listsMade() > lists + 10);
}

TEST_CASE("a particle alone flies straight, and comes in again where it left") {
  const ParticleRules rules = {.box = {Vector3(6, 7, 5), {P, P, P}}};
  Particles one({{Vector3(1, 1, 4)}}, {{Vector3(1, -2, 0.5)}}, rules);
  for (int i = 0; i < 1000; ++i) REQUIRE(one.velocityVerletStep(0.01) == ParticleStatus::Moved);
  CHECK(distanceIn(rules.box, one.position(0), Vector3(11, -19, 9)) < 1e-12);
  CHECK((one.velocity(0) - Vector3(1, -2, 0.5)).norm() == 0);
  CHECK(one.totals().kinetic == 2.625);
  CHECK(one.totals().potential == 0);
}

TEST_CASE("a wall throws a particle back as fast as it came") {
  const ParticleRules rules = {.box = {Vector3(6, 6, 6), {W, P, W}}};
  for (const Real speed : {-1.5, 1.5}) {
    for (const Real dt : {0.01, 0.001}) {
      Particles one({{Vector3(3, 3, 3)}}, {{Vector3(speed, 0.25, 0)}}, rules);
      Real highest = 0;
      for (int i = 0; i < 3.5 / dt; ++i) {
        REQUIRE(one.velocityVerletStep(dt) == ParticleStatus::Moved);
        highest = std::max(highest, one.totals().potential);
        REQUIRE(one.position(0).x() > 0.4);
        REQUIRE(one.position(0).x() < 5.6);
      }
      // In the turn all energy along x is the wall's. Curvature of the wall's potential: 230.
      CHECK(std::abs(highest - 1.125) < 100 * dt * dt);
      CHECK(one.totals().potential == 0);
      CHECK((one.velocity(0) - Vector3(-speed, 0.25, 0)).norm() < 20 * dt * dt);
    }
  }
}

TEST_CASE("who flies through a wall in a single step comes out of the mirror") {
  const ParticleRules rules = {.box = {Vector3(6, 6, 6), {W, W, W}}};
  for (const Real side : {-1.0, 1.0}) {
    const Vector3 place(3 + side * 2, 3, 3);  // out of reach of the wall's force, before and after
    Particles one({{place}}, {{Vector3(side * 200, 0, 0)}}, rules);
    REQUIRE(one.velocityVerletStep(0.01) == ParticleStatus::Moved);
    CHECK((one.position(0) - place).norm() < 1e-14);
    CHECK(one.velocity(0) == Vector3(-side * 200, 0, 0));
  }
}

TEST_CASE("walls keep every particle inside, and the energy where it is") {
  const LatticeStart start = startOf({16, 16, 1}, {W, W, F});
  Particles particles = particlesOf(start);
  for (int i = 0; i < 200; ++i) particles.velocityVerletStep(0.005);  // the lattice melts
  const Real before = particles.totals().energy();
  Real error = 0;
  for (int i = 0; i < 20000; ++i) {
    REQUIRE(particles.velocityVerletStep(0.005) == ParticleStatus::Moved);
    error = std::max(error, std::abs(particles.totals().energy() - before));
    if (i % 100 != 0) continue;
    for (std::size_t k = 0; k < particles.count(); ++k) {
      const Vector3& p = particles.position(k);
      REQUIRE((p.x() > 0.3 && p.x() < start.box.size.x() - 0.3));
      REQUIRE((p.y() > 0.3 && p.y() < start.box.size.y() - 0.3));
      REQUIRE(p.z() == 0);
    }
  }
  CHECK(error < 2e-3 * static_cast<Real>(particles.count()));
}

TEST_CASE("explicit Euler explodes, and says so; nothing moves from then on") {
  const LatticeStart start = startOf({10, 10, 1}, {W, W, F});
  Particles particles = particlesOf(start);
  const Real before = particles.totals().energy();
  int steps = 0;
  while (steps < 100000 && particles.explicitEulerStep(0.005) == ParticleStatus::Moved) ++steps;
  REQUIRE(steps < 100000);
  CHECK(particles.totals().energy() > 10 * std::abs(before));
  const Vector3 place = particles.position(3);
  CHECK(particles.explicitEulerStep(0.005) == ParticleStatus::Exploded);
  CHECK(particles.velocityVerletStep(0.005) == ParticleStatus::Exploded);
  CHECK(particles.position(3) == place);
  for (std::size_t i = 0; i < particles.count(); ++i) CHECK(particles.position(i).allFinite());
}

TEST_CASE("a step that is far too long is an explosion for every method and box") {
  using Step = ParticleStatus (Particles::*)(Real);
  for (const Step step : {&Particles::velocityVerletStep, &Particles::semiImplicitEulerStep,
                          &Particles::explicitEulerStep}) {
    for (const Edge edge : {P, W}) {
      for (const Real dt : {0.3, 5.0, 1e30, 1e300}) {
        Particles particles = particlesOf(startOf({5, 5, 5}, {edge, edge, edge}));
        int steps = 0;
        while (steps < 1000 && (particles.*step)(dt) == ParticleStatus::Moved) ++steps;
        CHECK(steps < 1000);
        for (std::size_t i = 0; i < particles.count(); ++i) {
          REQUIRE(particles.position(i).allFinite());
        }
      }
    }
  }
}

TEST_CASE("two atoms swing about their distance of rest with the period of a spring") {
  // The potential's curvature at 2^(1/6) s is 57.15 e/s^2 (72 / 2^(1/3)); the reduced mass is 1/2.
  const Real rest = std::pow(2.0, 1.0 / 6), stretch = 1e-4;
  const ParticleRules rules = {.box = {Vector3(10, 10, 10), {W, W, W}}};
  const std::vector<Vector3> positions = {{5, 5, 5}, {5 + rest + stretch, 5, 5}};
  Particles pair(positions, {{Vector3::Zero(), Vector3::Zero()}}, rules);
  const Real period = 2 * std::numbers::pi / std::sqrt(72 / std::cbrt(2.0) / 0.5);
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) pair.velocityVerletStep(period / steps);
  CHECK(std::abs((pair.position(1) - pair.position(0)).x() - rest - stretch) < 1e-3 * stretch);
}

TEST_CASE("pressure is the change of energy with volume") {
  // Energy of a lattice at rest in a box stretched by a factor: p = -dU/dV.
  const auto potential = [](Real factor) {
    LatticeStart start = startOf({6, 6, 6}, {P, P, P}, 0, 0.9);
    for (Vector3& position : start.positions) position *= factor;
    start.box.size *= factor;
    return std::pair(particlesOf(start).totals(), volumeOf(start.box));
  };
  constexpr Real h = 1e-5;
  const auto [low, lowVolume] = potential(1 - h);
  const auto [high, highVolume] = potential(1 + h);
  const Real slope = -(high.potential - low.potential) / (highVolume - lowVolume);
  CHECK(std::abs(potential(1).first.pressure / slope - 1) < 1e-6);
}

TEST_CASE("at low density pressure, volume and temperature are those of an ideal gas") {
  LatticeStart start = startOf({10, 10, 10}, {P, P, P}, 2, 1e-3);
  Particles gas = particlesOf(start);
  const ParticleTotals totals = gas.totals();
  CHECK(std::abs(totals.temperature - 2) < 1e-12);
  CHECK(std::abs(totals.pressure * volumeOf(start.box) / (1000 * totals.temperature) - 1) < 1e-12);
}

TEST_CASE("a lattice has the density and temperature asked for, and stays where it is") {
  const LatticeStart start = latticeStart({.sites = {4, 6, 5},
                                           .density = 0.3,
                                           .temperature = 1.7,
                                           .mass = 2,
                                           .edges = {P, W, P},
                                           .seed = 9});
  CHECK(start.positions.size() == 120);
  CHECK(std::abs(120 / volumeOf(start.box) / 0.3 - 1) < 1e-14);
  Vector3 sum = Vector3::Zero();
  Real squares = 0;
  for (const Vector3& v : start.velocities) sum += v, squares += v.squaredNorm();
  CHECK(sum.norm() < 1e-13);
  CHECK(std::abs(2 * squares / (3 * 120) / 1.7 - 1) < 1e-14);
  // The nearest two, also through the periodic edges, are one spacing apart.
  Real least = 1e9;
  for (std::size_t i = 0; i < 120; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, distanceIn(start.box, start.positions[i], start.positions[j]));
    }
  }
  CHECK(std::abs(least - std::cbrt(1 / 0.3)) < 1e-14);

  const LatticeStart flat = startOf({7, 3, 1}, {P, W, F});
  CHECK(dimensionsOf(flat.box) == 2);
  CHECK(std::abs(21 / volumeOf(flat.box) / 0.5 - 1) < 1e-14);
  for (const Vector3& v : flat.velocities) CHECK(v.z() == 0);
}

TEST_CASE("crowds that cannot be are refused with the reason") {
  const ParticleRules rules = {.box = {Vector3(6, 6, 6), {P, W, P}}};
  const std::vector<Vector3> two = {{1, 1, 1}, {3, 3, 3}}, still(2, Vector3::Zero());
  const auto refusal = [&](auto change, const char* why) {
    std::vector<Vector3> positions = two, velocities = still;
    ParticleRules changed = rules;
    change(positions, velocities, changed);
    CHECK_THROWS_AS(Particles(positions, velocities, changed), InvalidInput);
    CHECK_THROWS_WITH(Particles(positions, velocities, changed), ContainsSubstring(why));
  };
  using Points = std::vector<Vector3>;
  using Rules = ParticleRules;
  refusal([](Points& p, Points&, Rules&) { p[0].y() = kNan; }, "must be finite");
  refusal([](Points& p, Points&, Rules&) { p[0].x() = -1.0 / 0.0; }, "must be finite");
  refusal([](Points&, Points& v, Rules&) { v[1].z() = kNan; }, "must be finite");
  refusal([](Points& p, Points&, Rules&) { p[1].y() = 5.8; }, "must be between the walls");
  refusal([](Points& p, Points&, Rules&) { p[0].y() = -1; }, "must be between the walls");
  refusal([](Points& p, Points&, Rules&) { p[1] = p[0]; }, "must be at least half their size");
  // Overlapping through a periodic edge.
  refusal([](Points& p, Points&, Rules&) { p = {{0.1, 3, 3}, {5.9, 3, 3}}; }, "distance");
  refusal([](Points&, Points& v, Rules&) { v.pop_back(); }, "number of velocities = 1");
  refusal([](Points& p, Points& v, Rules&) { p.clear(), v.clear(); }, "number of particles = 0");
  refusal([](Points&, Points&, Rules& r) { r.mass = -1; }, "mass = -1 must be positive");
  refusal([](Points&, Points&, Rules& r) { r.atoms.depth = 0; }, "depth = 0 must be positive");
  refusal([](Points&, Points&, Rules& r) { r.atoms.size = kNan; }, "size = nan must be positive");
  refusal([](Points&, Points&, Rules& r) { r.atoms.cutoff = -2; }, "cutoff = -2");
  refusal([](Points&, Points&, Rules& r) { r.skin = -0.1; }, "skin = -0.1");
  refusal([](Points&, Points&, Rules& r) { r.skin = 2.6; }, "no more than the cut-off");
  refusal([](Points&, Points&, Rules& r) { r.box.size.x() = 4.99; }, "two cut-offs");
  refusal([](Points&, Points&, Rules& r) { r.box.size.y() = 2.4; }, "one cut-off");
  refusal([](Points&, Points&, Rules& r) { r.box.size.z() = kNan; }, "must be finite");
  refusal([](Points&, Points&, Rules& r) { r.box.edges[2] = F; }, "must be zero along");
  refusal([](Points&, Points&, Rules& r) { r.box.edges = {F, F, F}; }, "must have room");

  Particles sound(two, still, rules);
  CHECK_THROWS_WITH(sound.velocityVerletStep(kNan), ContainsSubstring("dt = nan must be finite"));
  CHECK_THROWS_AS(sound.explicitEulerStep(1.0 / 0.0), InvalidInput);
  CHECK(sound.velocityVerletStep(0.001) == ParticleStatus::Moved);
}

TEST_CASE("lattices that cannot be are refused with the reason") {
  const auto refused = [](const LatticePlan& plan, const char* why) {
    CHECK_THROWS_WITH(latticeStart(plan), ContainsSubstring(why));
  };
  refused({.sites = {0, 1, 1}}, "must be at least 1");
  refused({.sites = {2, 2, 2}, .edges = {P, P, F}}, "must be 1 along an axis that is flat");
  refused({.sites = {100000, 100000, 1}}, "at most");
  refused({.density = 0}, "density");
  refused({.density = kNan}, "density");
  refused({.temperature = -1}, "temperature");
  refused({.mass = 0}, "mass");
  refused({.sites = {1, 1, 1}}, "must be zero for one particle");
  refused({.sites = {1, 1, 1}, .edges = {F, F, F}}, "must");
}

TEST_CASE("a large and nearly empty box takes little memory") {
  const ParticleRules rules = {.box = {Vector3(1e9, 1e9, 1e9), {P, W, P}}};
  const std::vector<Vector3> positions = {{0.1, 1, 1}, {1e9 - 1, 1, 1}, {5e8, 5e8, 5e8}};
  const Particles particles(positions, std::vector<Vector3>(3, Vector3::Zero()), rules);
  CHECK(errorAgainstAllPairs(particles, rules) < 100);
  CHECK(particles.pairsListed() == 1);
}

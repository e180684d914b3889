// Why did the particles of the two-dimensional simulation always explode?
//
// Four hundred discs that attract and repel each other, between four walls. The same start is moved
// by explicit Euler, by semi-implicit Euler and by velocity Verlet: the same forces, and one
// evaluation of them a step.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/motion/particle_lattice.hpp"
#include "carom/motion/particles.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Edge;
using carom::Particles;
using carom::ParticleStatus;
using carom::Real;
using carom::Vector3;
using Step = ParticleStatus (Particles::*)(Real);

const std::vector<Step> kSteps = {&Particles::explicitEulerStep, &Particles::semiImplicitEulerStep,
                                  &Particles::velocityVerletStep};

//! [crowd]
// Units: energy of the bond, size and mass of a disc are 1.
Particles crowd() {
  carom::LatticePlan plan;
  plan.sites = {20, 20, 1};
  plan.density = 0.5;
  plan.temperature = 1;
  plan.edges = {Edge::Wall, Edge::Wall, Edge::Flat};
  const carom::LatticeStart start = carom::latticeStart(plan);
  return {start.positions, start.velocities, {.box = start.box}};
}
//! [crowd]

Real energyPerDisc(const Particles& discs) {
  return discs.totals().energy() / static_cast<Real>(discs.count());
}

struct Run {
  Real worst = 0;       // furthest from the energy at the start, per disc
  Real explodedAt = 0;  // 0: it did not
};

Run run(Step step, Real dt, Real duration) {
  Particles discs = crowd();
  const Real start = energyPerDisc(discs);
  Run result;
  for (int i = 1; i * dt <= duration; ++i) {
    if ((discs.*step)(dt) == ParticleStatus::Exploded) {
      result.explodedAt = i * dt;
      return result;
    }
    result.worst = std::max(result.worst, std::abs(energyPerDisc(discs) - start));
  }
  return result;
}

void energies() {
  constexpr Real kStep = 0.002;
  constexpr int kRow = 125;  // steps from row to row
  std::vector<Particles> crowds(kSteps.size(), crowd());
  carom::io::Table table;
  table.column("time", carom::io::fixed(2)).column("explicit Euler", carom::io::significant(5));
  table.column("semi-implicit", carom::io::fixed(5)).column("velocity Verlet", carom::io::fixed(5));
  std::vector<bool> sound(kSteps.size(), true);
  for (int i = 0; i <= 5000; ++i) {
    if ((i <= 12 * kRow && i % kRow == 0) || i % 1000 == 0) {
      std::vector<carom::io::Cell> cells = {i * kStep};
      for (std::size_t k = 0; k < kSteps.size(); ++k) {
        cells.push_back(sound[k] ? carom::io::Cell(energyPerDisc(crowds[k])) : "exploded");
      }
      table.row(cells);
    }
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
      sound[k] = (crowds[k].*kSteps[k])(kStep) == ParticleStatus::Moved;
    }
  }
  std::cout << "Energy per disc, steps of " << kStep << "\n\n" << table;
}

void errors() {
  carom::io::Table table;
  table.column("step", carom::io::fixed(5)).column("Euler explodes at", carom::io::fixed(2));
  table.column("semi-implicit", carom::io::scientific(1));
  table.column("velocity Verlet", carom::io::scientific(1));
  for (const Real dt : {0.01, 0.005, 0.0025, 0.00125}) {
    table.row({dt, run(kSteps[0], dt, 20).explodedAt, run(kSteps[1], dt, 10).worst,
               run(kSteps[2], dt, 10).worst});
  }
  std::cout << "\nFurthest from the energy at the start, per disc, in a time of 10\n\n" << table;
}

std::vector<Vector3> placesOf(const Particles& discs, Real aside) {
  std::vector<Vector3> places;
  for (std::size_t i = 0; i < discs.count(); ++i) {
    places.push_back(discs.position(i) + aside * Vector3::UnitX());
  }
  return places;
}

void record(const std::filesystem::path& file) {
  constexpr Real kStep = 0.001;
  constexpr int kFrames = 180, kStepsPerFrame = 40;
  Particles euler = crowd(), verlet = crowd();
  const Real length = std::sqrt(2 * static_cast<Real>(euler.count()));  // density 1/2
  const Real aside = length + 3;
  carom::io::Recording recording(
      "Discs that explode, and discs that do not",
      "Two boxes with the same four hundred discs. On the left explicit Euler moves them: they get "
      "hotter and hotter, until they fly apart. On the right velocity Verlet does: they stay as "
      "warm as they are.");
  recording.setView({.flat = true, .up = Vector3::UnitY()});
  for (const Real left : {Real(0), aside}) {
    const Real right = left + length;
    recording.addFixed(
        left == 0 ? "walls" : "the same walls",
        carom::io::Polyline{
            {{left, 0, 0}, {right, 0, 0}, {right, length, 0}, {left, length, 0}, {left, 0, 0}}},
        {}, {.color = carom::io::kGray});
  }
  recording.addSwarm("explicit Euler", {.count = euler.count(), .color = carom::io::kPalette[1]});
  recording.addSwarm("velocity Verlet", {.count = verlet.count(), .color = carom::io::kPalette[0]});
  recording.addChannel("log10 of the temperature, Euler", "");
  recording.addChannel("log10 of the temperature, Verlet", "");
  for (int frame = 0; frame < kFrames; ++frame) {
    recording.addFrame({.time = frame * kStepsPerFrame * kStep,
                        .channels = {std::log10(euler.totals().temperature),
                                     std::log10(verlet.totals().temperature)},
                        .swarms = {placesOf(euler, 0), placesOf(verlet, aside)}});
    for (int i = 0; i < kStepsPerFrame; ++i) {
      euler.explicitEulerStep(kStep);
      verlet.velocityVerletStep(kStep);
    }
  }
  recording.writeHtml(file);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  energies();
  errors();
  record(folder / "particles_2d.html");
}

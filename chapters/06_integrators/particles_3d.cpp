// Do ten thousand particles keep their energy, and can one watch them while they are computed?
//
// A warm liquid: particles at a density of one half in a box without walls, what leaves on one side
// comes in on the other. Velocity Verlet, with lists of near pairs made from cells.

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/motion/particle_lattice.hpp"
#include "carom/motion/particles.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Particles;
using carom::Real;
using carom::Vector3;

constexpr Real kStep = 0.005;  // [tau]; tau is the time unit s sqrt(m/e), here 1
constexpr int kStepsPerFrame = 10;
constexpr int kFrames = 241;
constexpr int kFramesPerRow = 20;

// The box as twelve edges, drawn in one line.
carom::io::Polyline edgesOf(const Vector3& size) {
  carom::io::Polyline line;
  for (const int corner : {0, 1, 3, 2, 0, 4, 5, 1, 5, 7, 3, 7, 6, 2, 6, 4}) {
    line.points.push_back(Vector3(corner & 1, corner >> 1 & 1, corner >> 2).cwiseProduct(size));
  }
  return line;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  //! [crowd]
  carom::LatticePlan plan;
  plan.sites = {25, 20, 20};
  plan.density = 0.5;
  plan.temperature = 1;
  const carom::LatticeStart start = carom::latticeStart(plan);
  const carom::ParticleRules rules = {.box = start.box};
  Particles particles(start.positions, start.velocities, rules);
  //! [crowd]
  const auto count = static_cast<Real>(particles.count());
  const auto isLeft = [&](std::size_t i) {
    return start.positions[i].x() < start.box.size.x() / 2;
  };

  carom::io::Recording recording(
      "Ten thousand particles",
      "Ten thousand balls on a lattice begin to move, attract and repel each other and become a "
      "liquid. Those that began in the left half have another colour than those of the right.");
  recording.addFixed("box", edgesOf(start.box.size), {}, {.color = carom::io::kGray});
  std::size_t left = 0;
  for (std::size_t i = 0; i < particles.count(); ++i) left += isLeft(i);
  const Vector3& size = start.box.size;
  recording.addSwarm("left at first", {.count = left, .period = size});
  recording.addSwarm("right at first", {.count = particles.count() - left, .period = size});
  recording.addChannel("temperature", "e");
  recording.addChannel("energy per particle", "e");

  carom::io::Table table;
  table.column("time", carom::io::fixed(1)).column("energy/n", carom::io::fixed(7));
  table.column("temperature", carom::io::fixed(5)).column("pressure", carom::io::fixed(5));
  table.column("momentum", carom::io::scientific(0));
  for (int frame = 0; frame < kFrames; ++frame) {
    const carom::ParticleTotals totals = particles.totals();
    const Real time = frame * kStepsPerFrame * kStep;
    std::vector<std::vector<Vector3>> swarms(2);
    for (std::size_t i = 0; i < particles.count(); ++i) {
      swarms[isLeft(i) ? 0 : 1].push_back(particles.position(i));
    }
    recording.addFrame({.time = time,
                        .channels = {totals.temperature, totals.energy() / count},
                        .swarms = std::move(swarms)});
    if (frame % kFramesPerRow == 0) {
      table.row({time, totals.energy() / count, totals.temperature, totals.pressure,
                 totals.momentum.norm()});
    }
    for (int i = 0; i < kStepsPerFrame; ++i) particles.velocityVerletStep(kStep);
  }
  std::cout << particles.count() << " particles, " << kFrames * kStepsPerFrame << " steps of "
            << kStep << "\n\n"
            << table << "\nLists made: " << particles.listsMade()
            << ", pairs in the last: " << particles.pairsListed()
            << ", all pairs: " << particles.count() / 2 * (particles.count() - 1) << '\n';
  recording.writeHtml(folder / "particles_3d.html");
}

// The suite `particles`: a step of velocity Verlet for a crowd, by all pairs, by cells made anew in
// every step, and by lists of near pairs; processor time against the number of particles.
//
// The crowds are those of chapter 6: density one half, a temperature of about one, steps of 0.005,
// a periodic box. They have been moving for a while before they are timed, and they go on moving
// while they are: what is timed is a simulation, its lists made anew as often as it needs them.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "carom/motion/pair_forces.hpp"
#include "carom/motion/particle_lattice.hpp"
#include "carom/motion/particles.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::CrowdForces;
using carom::Edge;
using carom::Particles;
using carom::ParticleStatus;
using carom::Real;
using carom::Vector3;
using carom::bench::Case;
using carom::bench::Json;
using carom::bench::keep;
using carom::bench::Options;
using carom::bench::Timing;

namespace {

constexpr Real kStep = 0.005;                      // [tau]
constexpr Real kSkin = 0.5;                        // of the lists, unless said otherwise [1]
constexpr int kWarmUp = 200;                       // steps, in which the lattice melts
constexpr Real kStepsPerFrame = 1.0 / 60 / kStep;  // at one tau per second

// A crowd that has moved for a while.
struct Crowd {
  carom::ParticleRules rules;
  std::vector<Vector3> positions, velocities;
};

Crowd warmCrowd(const std::array<int, 3>& sites) {
  const bool flat = sites[2] == 1;
  const carom::LatticeStart start = carom::latticeStart(
      {.sites = sites,
       .density = 0.5,
       .temperature = 1,
       .edges = {Edge::Periodic, Edge::Periodic, flat ? Edge::Flat : Edge::Periodic}});
  Crowd crowd{{.box = start.box, .skin = kSkin}, {}, {}};
  Particles particles(start.positions, start.velocities, crowd.rules);
  for (int i = 0; i < kWarmUp; ++i) particles.velocityVerletStep(kStep);
  for (std::size_t i = 0; i < particles.count(); ++i) {
    crowd.positions.push_back(particles.position(i));
    crowd.velocities.push_back(particles.velocity(i));
  }
  return crowd;
}

Particles particlesOf(const Crowd& crowd, Real skin) {
  carom::ParticleRules rules = crowd.rules;
  rules.skin = skin;
  return Particles(crowd.positions, crowd.velocities, rules);
}

// Velocity Verlet with the forces of all pairs, as one would write it first.
struct AllPairs {
  Crowd crowd;
  Vector3 box;
  CrowdForces now;

  explicit AllPairs(const Crowd& start) : crowd(start), box(start.rules.box.size) {
    if (start.rules.box.edges[2] == Edge::Flat) box.z() = 0;
    now = carom::pairForces(crowd.positions, crowd.rules.atoms, box);
  }
  void step() {
    for (std::size_t i = 0; i < crowd.positions.size(); ++i) {
      crowd.velocities[i] += kStep / 2 * now.forces[i];
      crowd.positions[i] += kStep * crowd.velocities[i];
    }
    now = carom::pairForces(crowd.positions, crowd.rules.atoms, box);
    for (std::size_t i = 0; i < crowd.positions.size(); ++i) {
      crowd.velocities[i] += kStep / 2 * now.forces[i];
    }
  }
};

template <class System>
Case caseOf(const std::string& name, std::size_t count, std::shared_ptr<System> system) {
  return {name, count, [system] { system->step(); }};
}

// Particles with the step that is timed.
struct Listed {
  Particles particles;
  void step() {
    keep(particles.velocityVerletStep(kStep));
  }
};

struct Curve {
  std::string name;
  std::vector<Real> counts;
  std::vector<Timing> times;  // per particle and step [ns]
};

// All methods over crowds of one dimension.
std::vector<Curve> race(bool flat, const Options& options) {
  const std::vector<std::array<int, 3>> sizes =
      flat ? std::vector<std::array<int, 3>>{{10, 10, 1}, {20, 20, 1},   {32, 32, 1},  {50, 50, 1},
                                             {71, 70, 1}, {100, 100, 1}, {200, 200, 1}}
           : std::vector<std::array<int, 3>>{{5, 5, 5},    {7, 7, 7},    {10, 10, 10}, {14, 14, 13},
                                             {17, 17, 17}, {25, 20, 20}, {35, 34, 34}};
  const std::string dimension = flat ? " (2D)" : " (3D)";
  std::vector<Curve> curves = {{"all pairs" + dimension, {}, {}},
                               {"cells, anew in each step" + dimension, {}, {}},
                               {"lists from cells" + dimension, {}, {}}};
  std::vector<Case> cases;
  std::vector<std::size_t> owners;
  const auto enter = [&](std::size_t curve, std::size_t count, Case one) {
    curves[curve].counts.push_back(static_cast<Real>(count));
    owners.push_back(curve);
    cases.push_back(std::move(one));
  };
  for (const std::array<int, 3>& sites : sizes) {
    const Crowd crowd = warmCrowd(sites);
    const std::size_t n = crowd.positions.size();
    if (n <= 5000) enter(0, n, caseOf("all pairs", n, std::make_shared<AllPairs>(crowd)));
    for (const Real skin : {Real(0), kSkin}) {
      auto system = std::make_shared<Listed>(Listed{particlesOf(crowd, skin)});
      enter(skin == 0 ? 1 : 2, n, caseOf("lists", n, system));
    }
  }
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  for (std::size_t i = 0; i < timings.size(); ++i) curves[owners[i]].times.push_back(timings[i]);
  return curves;
}

void enterRows(const std::vector<Curve>& curves, Json& rows) {
  carom::io::Table table;
  table.column("method").column("particles").column("ns per particle", carom::io::significant(3));
  table.column("ms per step", carom::io::significant(3));
  table.column("part of a 60 Hz frame", carom::io::significant(3));
  for (const Curve& curve : curves) {
    for (std::size_t i = 0; i < curve.counts.size(); ++i) {
      const Real seconds = 1e-9 * curve.times[i].median * curve.counts[i];
      const Real share = seconds * kStepsPerFrame * 60;
      table.row({curve.name, static_cast<long>(curve.counts[i]), curve.times[i].median,
                 1000 * seconds, share});
      rows.push_back({{"suite", "particles"},
                      {"scene", "crowd of density 0.5"},
                      {"engine", curve.name},
                      {"version", CAROM_VERSION},
                      {"particles", curve.counts[i]},
                      {"dt", kStep},
                      {"threads", 1},
                      {"ns_per_particle_step", curve.times[i].median},
                      {"least", curve.times[i].least},
                      {"most", curve.times[i].most},
                      {"share_of_60Hz_frame", share}});
    }
    const std::size_t last = curve.counts.size();
    if (last < 2) continue;
    std::vector<Real> x, y;
    for (std::size_t i = last / 2; i < last; ++i) {
      x.push_back(curve.counts[i]);
      y.push_back(curve.times[i].median * curve.counts[i]);
    }
    rows.back()["exponent"] = carom::bench::slopeOf(x, y);
  }
  std::cout << table << '\n';
}

// Ten thousand particles, and how far the list reaches beyond the cut-off.
void skins(const Crowd& crowd, const Options& options, Json& rows) {
  const std::vector<Real> widths = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0};
  std::vector<Case> cases;
  std::vector<std::shared_ptr<Listed>> systems;
  for (const Real skin : widths) {
    systems.push_back(std::make_shared<Listed>(Listed{particlesOf(crowd, skin)}));
    cases.push_back(caseOf("skin", crowd.positions.size(), systems.back()));
  }
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  carom::io::Table table;
  table.column("skin", carom::io::fixed(1)).column("ns per particle", carom::io::significant(3));
  table.column("steps per list", carom::io::fixed(1))
      .column("pairs per particle", carom::io::fixed(1));
  for (std::size_t i = 0; i < widths.size(); ++i) {
    Particles& particles = systems[i]->particles;
    const std::size_t before = particles.listsMade();
    constexpr int kSteps = 200;
    for (int k = 0; k < kSteps; ++k) particles.velocityVerletStep(kStep);
    const Real lists = static_cast<Real>(particles.listsMade() - before);
    const Real pairs =
        static_cast<Real>(particles.pairsListed()) / static_cast<Real>(particles.count());
    table.row({widths[i], timings[i].median, kSteps / lists, pairs});
    rows.push_back({{"suite", "particles"},
                    {"scene", "10 000 in 3D, skin of the lists"},
                    {"engine", "lists from cells (3D)"},
                    {"skin", widths[i]},
                    {"ns_per_particle_step", timings[i].median},
                    {"steps_per_list", kSteps / lists},
                    {"pairs_per_particle", pairs}});
  }
  std::cout << "10 000 particles in 3D\n\n" << table << '\n';
}

// How far the energy of ten thousand particles goes from where it was, in a time of five.
void energies(const Crowd& crowd, Json& rows) {
  carom::io::Table table;
  table.column("step", carom::io::fixed(4))
      .column("furthest, per particle", carom::io::scientific(1));
  table.column("at the end", carom::io::scientific(1));
  for (const Real dt : {0.01, 0.005, 0.0025}) {
    Particles particles = particlesOf(crowd, kSkin);
    const auto count = static_cast<Real>(particles.count());
    const Real start = particles.totals().energy() / count;
    Real worst = 0, end = 0;
    for (int i = 1; i * dt <= 5; ++i) {
      keep(particles.velocityVerletStep(dt));
      end = particles.totals().energy() / count - start;
      worst = std::max(worst, std::abs(end));
    }
    table.row({dt, worst, std::abs(end)});
    rows.push_back({{"suite", "particles"},
                    {"scene", "10 000 in 3D, energy over a time of 5"},
                    {"engine", "lists from cells (3D)"},
                    {"dt", dt},
                    {"error", {{"energy", worst}, {"energy_at_end", end}}}});
  }
  std::cout << "Energy of 10 000 particles in 3D, a time of 5\n\n" << table << '\n';
}

void draw(const std::vector<Curve>& curves, const std::filesystem::path& file) {
  carom::io::Plot plot("A step of velocity Verlet for a crowd");
  plot.describe(
      "Time of a step against the number of particles, both axes logarithmic. All pairs rise with "
      "the square of the number, cells and lists with the number itself; ten thousand particles "
      "stay below the line of real time by lists, not by all pairs.");
  plot.size(980, 560).xAxis("particles", carom::io::Scale::Logarithmic).xRange(100, 100000);
  plot.yAxis("time of a step [ms]", carom::io::Scale::Logarithmic).yRange(1e-4, 1000);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    std::vector<Real> times;
    for (std::size_t k = 0; k < curves[i].counts.size(); ++k) {
      times.push_back(1e-6 * curves[i].times[k].median * curves[i].counts[k]);
    }
    carom::io::CurveStyle style = carom::bench::styleOf(i % 3, false);
    style.dashed = i >= 3;
    plot.curve(curves[i].name, curves[i].counts, times, style);
  }
  const Real limit = 1000 / 60.0 / kStepsPerFrame;
  plot.curve("real time: 1 tau a second", {100, 100000}, {limit, limit},
             {.width = 1, .color = carom::io::Color{30, 30, 30}});
  carom::bench::sign(plot, 130, 1.2e-3, 0.4);
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = carom::bench::readOptions(argc, argv);
  Json figures{{"suite", "particles"}, {"circumstances", carom::bench::circumstances(options)}};
  Json rows = Json::array();
  std::cout << carom::bench::circumstancesInALine() << "\n\n";
  std::vector<Curve> curves = race(false, options);
  for (Curve& curve : race(true, options)) curves.push_back(std::move(curve));
  enterRows(curves, rows);
  const Crowd tenThousand = warmCrowd({25, 20, 20});
  skins(tenThousand, options, rows);
  energies(tenThousand, rows);
  if (!options.plots.empty()) {
    std::filesystem::create_directories(options.plots);
    draw(curves, options.plots / "particles.svg");
  }
  figures["rows"] = rows;
  carom::bench::writeJson(options, figures);
}

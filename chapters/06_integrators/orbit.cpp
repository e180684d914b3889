// Does a planet come back to where it was?
//
// A planet goes round the sun on an ellipse that is as much as 0.6 out of round; units are such
// that a year is 2 pi. Six methods follow it for ten years with steps of 0.01, among them what the
// source calls Verlet. Where the planet must be, Kepler's equation says.

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom/motion/yoshida.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"
#include "source_listings.hpp"

using carom::Coordinates;
using carom::Real;
using carom::State;
using carom::Step;
using carom::Vector3;

const Real kEccentricity = 0.6;
const Real kStep = 0.01;
const int kSteps = 6283;  // ten years, less 0.0019

//! [gravity]
// The sun is at the origin, and pulls with 1/r^2.
Coordinates gravity(Real, const Coordinates& x, const Coordinates&) {
  const Real r = x.norm();
  return -x / (r * r * r);
}
//! [gravity]

State nearestToTheSun() {
  const Real e = kEccentricity;
  return {Coordinates{{1 - e, 0.0}}, Coordinates{{0.0, std::sqrt((1 + e) / (1 - e))}}};
}

// Kepler: the angle E for which E - e sin E is the time, by Newton's method.
Coordinates keplersPlace(Real time) {
  const Real e = kEccentricity;
  Real angle = time;
  for (int i = 0; i < 20; ++i) {
    const auto [s, c] = carom::sineCosine(angle);
    angle -= (angle - e * s - time) / (1 - e * c);
  }
  const auto [s, c] = carom::sineCosine(angle);
  return Coordinates{{c - e, std::sqrt(1 - e * e) * s}};
}

Real energy(const State& s) {
  return s.velocity.squaredNorm() / 2 - 1 / s.position.norm();
}

struct Method {
  std::string name;
  Step step;
  int forces;  // asked for in each step
};

const std::vector<Method> kMethods = {
    {"explicit Euler", carom::explicitEuler, 1},
    {"source's 7.2", sourceVerlet, 1},
    {"semi-implicit Euler", carom::semiImplicitEuler, 1},
    {"velocity Verlet", carom::velocityVerlet, 1},
    {"Runge and Kutta's", carom::rk4, 4},
    {"Yoshida's, order 6", carom::yoshida6, 7},
};

carom::io::Pose at(const Coordinates& x) {
  return {.position = {x[0], x[1], 0}};
}

carom::io::Recording emptySky() {
  carom::io::Recording recording("Ten years",
                                 "A planet by six methods, and in grey where it should be.");
  recording.addBody("planet", carom::io::Disc{0.06}, {.trail = true});
  recording.addBody("where it should be", carom::io::Disc{0.05}, {.color = {{150, 150, 150}}});
  recording.addFixed("sun", carom::io::Disc{0.12}, {}, {.color = {{240, 170, 0}}});
  recording.setView({.flat = true, .target = Vector3(-0.6, 0, 0), .distance = 2.5});
  recording.setParameter("method");
  return recording;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const Coordinates place = keplersPlace(kSteps * kStep);
  std::cout << "Ten years in steps of 0.01, eccentricity 0.6\n\n";
  carom::io::Table table;
  table.column("method").column("forces").column("off by", carom::io::scientific(1));
  table.column("energy off by", carom::io::scientific(1));
  carom::io::Plot plot("Ten years");
  plot.xAxis("x").yAxis("y").equalAspect().xRange(-6, 2).yRange(-3, 3);
  plot.describe(
      "The orbit of explicit Euler opens into a spiral; that of semi-implicit Euler turns "
      "slowly about the sun; that of Runge and Kutta's method is the ellipse.");

  carom::io::Recording recording = emptySky();
  std::vector<std::vector<State>> paths;
  for (const Method& method : kMethods) {
    std::vector<State> path = {nearestToTheSun()};
    for (int i = 0; i < kSteps; ++i) {
      path.push_back(method.step(path.back(), i * kStep, kStep, gravity));
    }
    table.row({method.name, method.forces, (path.back().position - place).norm(),
               energy(path.back()) - energy(path.front())});
    recording.beginCase(method.name);
    for (int i = 0; i <= kSteps; i += 12) {
      recording.addFrame(
          {.time = i * kStep / 4, .poses = {at(path[i].position), at(keplersPlace(i * kStep))}});
    }
    paths.push_back(std::move(path));
  }
  std::cout << table;

  for (std::size_t m : {0, 2, 4}) {
    std::vector<Real> x, y;
    for (int i = 0; i <= kSteps; i += 5) {
      x.push_back(paths[m][i].position[0]);
      y.push_back(paths[m][i].position[1]);
    }
    plot.curve(kMethods[m].name, x, y, {.width = 1});
  }
  plot.writeSvg(folder / "orbit.svg");

  recording.writeHtml(folder / "orbit.html");
}

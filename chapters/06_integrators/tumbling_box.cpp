// Why does a book not spin about its middle axis?
//
// A thin plate, 12 kg, moments of inertia 1, 2 and 3 kg m^2, turns in free fall. Six methods follow
// it with sixty steps a second; the seventh has no steps. First a plate that tumbles wildly, and
// what is left of its energy and angular momentum after ten seconds. Then one that turns about its
// middle axis, all but exactly, and should turn over every seven seconds.

#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/motion/explicit_gyroscopic_step.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/motion/gyroscopic_step.hpp"
#include "carom/motion/rk4_rotor.hpp"
#include "carom/motion/split_rotor.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Quaternion;
using carom::Real;
using carom::RotorState;
using carom::Vector3;

const Vector3 kMoments(1, 2, 3);  // [kg m^2]
const Real kStep = 1.0 / 60;      // [s]
const RotorState kTumbling = {{1, 0, 0, 0}, {2, 0, 1.5}};
const RotorState kRacket = {{1, 0, 0, 0}, {0.001, 5, 0}};

using StepOf = std::function<RotorState(const RotorState&)>;

//! [engine]
// An engine's step: first the angular velocity, then the attitude.
RotorState turned(const RotorState& s, const Vector3& w) {
  const Vector3 inTheWorld = rotatePoint(s.q_WB, w);
  return {integrateOrientation(s.q_WB, inTheWorld, kStep), w};
}

RotorState withoutTheTerm(const RotorState& s) {
  return turned(s, s.angularVelocity);
}

RotorState explicitly(const RotorState& s) {
  const Vector3& w = s.angularVelocity;
  return turned(s, carom::explicitGyroscopicStep(kMoments, w, kStep));
}

RotorState implicitly(const RotorState& s) {
  const Vector3& w = s.angularVelocity;
  const carom::Matrix3 inertia = kMoments.asDiagonal();
  return turned(s, carom::gyroscopicStep(inertia, w, kStep));
}
//! [engine]

struct Method {
  std::string name;
  StepOf step;
};

std::vector<Method> methods() {
  const carom::SplitRotor split(kMoments);
  return {
      {"without the term", withoutTheTerm},
      {"explicit", explicitly},
      {"implicit", implicitly},
      {"Runge and Kutta's",
       [](const RotorState& s) { return carom::rk4Rotor(kMoments, s, 0, kStep); }},
      {"splitting, order 2", [split](const RotorState& s) { return split.step2(s, kStep); }},
      {"splitting, order 4", [split](const RotorState& s) { return split.step4(s, kStep); }},
  };
}

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  return quaternionLogarithm(hamiltonProduct(conjugate(a), b)).norm();
}

void tumbling() {
  carom::io::Table table;
  table.column("method").column("attitude off by [rad]", carom::io::scientific(1));
  table.column("energy [%]", carom::io::scientific(1));
  table.column("L turned by [rad]", carom::io::scientific(1));
  const RotorState exact = carom::FreeRotor(kMoments, kTumbling).at(10);
  const Real energy = carom::rotationEnergy(kMoments, kTumbling.angularVelocity);
  const Vector3 L = carom::angularMomentum(kMoments, kTumbling);
  for (const Method& method : methods()) {
    RotorState s = kTumbling;
    for (int i = 0; i < 600; ++i) s = method.step(s);
    const Vector3 now = carom::angularMomentum(kMoments, s);
    table.row({method.name, angleBetween(s.q_WB, exact.q_WB),
               100 * (carom::rotationEnergy(kMoments, s.angularVelocity) / energy - 1),
               carom::arctangent2(carom::cross(now, L).norm(), now.dot(L))});
  }
  std::cout << "A plate that tumbles, after 10 s\n\n" << table;
}

struct TurningOver {
  int times = 0;
  Real last = 0;  // when it did so for the last time [s]
};

// The sign of the spin about the middle axis, for thirty seconds.
TurningOver turningOver(const std::vector<RotorState>& path) {
  TurningOver result;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i - 1].angularVelocity.y() * path[i].angularVelocity.y() >= 0) continue;
    ++result.times;
    result.last = static_cast<Real>(i) * kStep;
  }
  return result;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  tumbling();

  carom::io::Recording recording("A plate that turns about its middle axis",
                                 "Four plates start alike. The first one never turns over.");
  //! [exact]
  const carom::FreeRotor rotor(kMoments, kRacket);
  std::vector<RotorState> exact;
  for (int i = 0; i <= 1800; ++i) exact.push_back(rotor.at(i * kStep));
  //! [exact]
  carom::io::Table table;
  table.column("method").column("turns over").column("the last time at [s]", carom::io::fixed(2));
  std::vector<std::vector<RotorState>> paths;
  const auto follow = [&](const std::string& name, const std::vector<RotorState>& path) {
    const TurningOver over = turningOver(path);
    table.row({name, over.times, over.times > 0 ? carom::io::Cell(over.last) : ""});
    paths.push_back(path);
  };
  for (const Method& method : methods()) {
    std::vector<RotorState> path = {kRacket};
    for (int i = 0; i < 1800; ++i) path.push_back(method.step(path.back()));
    follow(method.name, path);
  }
  follow("exact", exact);
  std::cout << "\nOne that turns about its middle axis, 30 s\n\n" << table;

  const std::vector<std::size_t> shown = {0, 1, 2, 6};
  const std::vector<std::string> names = {"without the term", "explicit", "implicit", "exact"};
  for (const std::string& name : names) {
    recording.addBody(name, carom::io::Box{Vector3(1.4, 1, 0.08)}, {.axes = true});
  }
  for (std::size_t i = 0; i <= 1800; i += 3) {
    carom::io::Frame frame{.time = static_cast<Real>(i) * kStep};
    for (std::size_t k = 0; k < shown.size(); ++k) {
      frame.poses.push_back({Vector3(2.2 * static_cast<Real>(k), 0, 0), paths[shown[k]][i].q_WB});
    }
    recording.addFrame(frame);
  }
  recording.writeHtml(folder / "tumbling_box.html");
}

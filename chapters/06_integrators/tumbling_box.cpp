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
  return turned(s, carom::explicitGyroscopicStep(kMoments, s.angularVelocity, kStep));
}

RotorState implicitly(const RotorState& s) {
  const carom::Matrix3 inertia = kMoments.asDiagonal();
  return turned(s, carom::gyroscopicStep(inertia, s.angularVelocity, kStep));
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
               carom::arctangent2(now.cross(L).norm(), now.dot(L))});
  }
  std::cout << "A plate that tumbles, after 10 s\n\n" << table;
}

// How often the plate turns over in thirty seconds: the sign of the spin about its middle axis.
int turnsOver(const std::function<RotorState(int)>& at) {
  int turns = 0;
  bool up = true;
  for (int i = 0; i <= 1800; ++i) {
    const Real spin = at(i).angularVelocity.y();
    if (up ? spin < 0 : spin > 0) {
      up = !up;
      ++turns;
    }
  }
  return turns;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  tumbling();

  carom::io::Recording recording("A plate that turns about its middle axis",
                                 "Four plates start alike. Two of them turn over.");
  const carom::io::Box plate{Vector3(1.4, 1, 0.08)};
  std::vector<std::vector<RotorState>> paths;
  carom::io::Table table;
  table.column("method")
      .column("turns over")
      .column("spin at the end [rad/s]", carom::io::fixed(3));
  for (const Method& method : methods()) {
    std::vector<RotorState> path = {kRacket};
    for (int i = 0; i < 1800; ++i) path.push_back(method.step(path.back()));
    table.row({method.name, turnsOver([&](int i) { return path[i]; }),
               path.back().angularVelocity.norm()});
    paths.push_back(std::move(path));
  }
  //! [exact]
  const carom::FreeRotor rotor(kMoments, kRacket);
  const auto exact = [&](int i) { return rotor.at(i * kStep); };
  //! [exact]
  table.row({"exact", turnsOver(exact), exact(1800).angularVelocity.norm()});
  std::cout << "\nOne that turns about its middle axis, 30 s\n\n" << table;

  for (std::size_t m : {0, 1, 2}) recording.addBody(methods()[m].name, plate, {.axes = true});
  recording.addBody("exact", plate, {.axes = true});
  for (int i = 0; i <= 1800; i += 3) {
    carom::io::Frame frame{.time = i * kStep};
    for (std::size_t m : {0, 1, 2}) {
      frame.poses.push_back({Vector3(2.2 * static_cast<Real>(m), 0, 0), paths[m][i].q_WB});
    }
    frame.poses.push_back({Vector3(6.6, 0, 0), exact(i).q_WB});
    recording.addFrame(frame);
  }
  recording.writeHtml(folder / "tumbling_box.html");
}

// Do the cars of the source collide?
//
// A car of 3.6 m drives at 72 m/s towards another one of 3.6 m that stands still. The simulation
// looks at them once in a step. Ten thousand starting places, evenly over one step: from how many
// does it drive through without being seen? Then the moment of impact, without steps.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/toi/conservative_advancement.hpp"
#include "carom/toi/tunnels.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

const Real kLength = 3.6;  // of both cars [m]

//! [seen]
// The front of one car has got to the other's rear, and its rear not
// yet to the other's front: are there steps at which both hold?
bool seen(Real distance, Real stepLength) {
  for (int i = 0; i * stepLength <= distance + 2 * kLength; ++i) {
    const Real front = i * stepLength;
    if (front >= distance && front <= distance + 2 * kLength) return true;
  }
  return false;
}
//! [seen]

int missedOf(int starts, Real stepLength) {
  int missed = 0;
  for (int i = 0; i < starts; ++i) {
    const Real distance = stepLength * (i + 0.5) / starts;
    if (!seen(distance, stepLength)) ++missed;
  }
  return missed;
}

struct Row {
  std::string name;
  Real speed, dt;
};

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<Row> rows = {
      {"as the source reckons", 60, 0.1},     {"as the source drives", 72, 0.1},
      {"a little slower steps", 72, 0.11},    {"twice the speed", 144, 0.1},
      {"sixty steps a second", 72, 1.0 / 60}, {"the same at 500 m/s", 500, 1.0 / 60}};
  carom::io::Table table;
  table.column("").column("speed [m/s]").column("dt [s]", carom::io::significant(3));
  table.column("jump [m]", carom::io::significant(3)).column("can tunnel");
  table.column("unseen [%]", carom::io::fixed(2));
  for (const Row& row : rows) {
    const bool can = carom::tunnels(kLength, kLength, row.speed, row.dt);
    table.row({row.name, row.speed, row.dt, row.speed * row.dt, can ? "yes" : "no",
               missedOf(10000, row.speed * row.dt) / 100.0});
  }
  std::cout << "Two cars of 3.6 m, one of them parked\n\n" << table;

  //! [gap]
  const Real start = 20, speed = 72;
  const auto gap = [&](Real t) { return start - speed * t; };
  const auto hit = carom::conservativeAdvancement(gap, speed, 1, 1e-12);
  //! [gap]
  std::cout << "\nFrom 20 m: impact after " << carom::io::Cell(hit.time).text(carom::io::fixed(9))
            << " s, found in " << hit.steps << " step\n";

  carom::io::Recording recording("Two cars", "In jumps of 7.9 m the car is never seen to touch.");
  recording.addBody("car", carom::io::Box{Vector3(kLength, 1.6, 1.2)});
  recording.addFixed("parked car", carom::io::Box{Vector3(kLength, 1.6, 1.2)},
                     {Vector3(kLength / 2, 0, 0.6)});
  recording.addFixed("road", carom::io::Plane{60, 5});
  recording.setParameter("steps");
  for (const Real dt : {0.11, 0.01}) {
    recording.beginCase(dt > 0.1 ? "of 0.11 s" : "until the impact");
    const Real from = -2 * 7.92 - 0.36;  // of the front, from the other's rear
    for (int i = 0; i <= static_cast<int>(0.5 / dt); ++i) {
      const Real front =
          dt > 0.1 ? from + speed * i * dt : std::min(from + speed * i * dt, Real(0));
      const Vector3 middle(front - kLength / 2, 0, 0.6);
      recording.addFrame({.time = i * dt * 6, .poses = {{middle}}});
      // It stands where it is until the next step: that is what a simulation knows of it.
      if (dt > 0.1) recording.addFrame({.time = (i + 0.98) * dt * 6, .poses = {{middle}}});
    }
  }
  recording.writeHtml(folder / "two_cars.html");
}

// How far from an axis does the mass of a body lie?
//
// The axis turns about z, from the x axis to the y axis and on. For each direction the radius of
// gyration is drawn as a length along the axis: a body has one such curve, and the principal axes
// are where it is widest and narrowest.

#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/mass/standard_solids.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "gyration_radius.hpp"

using carom::MassProperties;
using carom::Real;
using carom::Vector3;

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<std::pair<std::string, MassProperties>> bodies = {
      {"ball, radius 0.5 m", carom::solidBall(0.5, 1000)},
      {"box, 1.6 x 0.8 x 0.2 m", carom::solidBox({1.6, 0.8, 0.2}, 1000)},
      {"ellipsoid, 2 x 1 x 1 m", carom::solidEllipsoid({1, 0.5, 0.5}, 1000)},
  };

  carom::io::Table table;
  table.column("angle [deg]", carom::io::fixed(0));
  for (const auto& [name, body] : bodies) table.column("k of the " + name, carom::io::fixed(4));
  for (int degrees = 0; degrees <= 90; degrees += 15) {
    std::vector<carom::io::Cell> row = {Real(degrees)};
    const auto [s, c] = carom::sineCosine(degrees * std::numbers::pi / 180);
    for (const auto& named : bodies) {
      row.push_back(carom::gyrationRadius(named.second, Vector3(c, s, 0)));
    }
    table.row(row);
  }
  std::cout << "Radius of gyration in m about axes in the plane z = 0\n\n" << table;

  carom::io::Plot plot("Radius of gyration along the axis");
  plot.describe(
      "Closed curves around the centre, one for each body: a circle for the ball, and curves that "
      "are "
      "widest across the longest edge for the box and the ellipsoid.");
  plot.equalAspect().xAxis("along x [m]").yAxis("along y [m]");
  for (const auto& [name, body] : bodies) {
    std::vector<Real> x, y;
    for (int degrees = 0; degrees <= 360; degrees += 2) {
      const auto [s, c] = carom::sineCosine(degrees * std::numbers::pi / 180);
      const Real k = carom::gyrationRadius(body, Vector3(c, s, 0));
      x.push_back(k * c);
      y.push_back(k * s);
    }
    plot.curve(name, x, y);
  }
  plot.writeSvg(folder / "gyration.svg");
}

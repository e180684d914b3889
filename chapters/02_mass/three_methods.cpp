// Three ways to find where half a ball balances.
//
// Signed tetrahedra are exact for the mesh. Monte Carlo comes closer with the square root of the
// number of points. The centre of the skin is fast, exact, and the answer to another question.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/shell_centroid.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::MassProperties;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector2;

constexpr Real kDensity = 1000;  // [kg/m^3]
constexpr int kSeeds = 32;       // runs of Monte Carlo that are averaged

// Half a ball of radius 1 m on the plane z = 0, in 2 * around * bands triangles about.
TriangleMesh halfBall(int bands, int around) {
  std::vector<Vector2> profile = {{0, 0}};
  for (int i = 0; i < bands; ++i) {
    const auto [s, c] = carom::sineCosine(std::numbers::pi / 2 * i / bands);
    profile.push_back({c, s});
  }
  profile.push_back({0, 1});
  return carom::latheMesh(profile, around);
}

void printCentres() {
  carom::io::Table table;
  table.column("triangles").column("tetrahedra: z [m]", carom::io::fixed(6));
  table.column("skin: z [m]", carom::io::fixed(6));
  for (int bands : {4, 16, 64, 256}) {
    const TriangleMesh mesh = halfBall(bands, 4 * bands);
    table.row(
        {mesh.triangles.size(), carom::centerOfMass(mesh).z(), carom::shellCentroid(mesh).z()});
  }
  std::cout << "Height of the centre of half a ball of radius 1 m: the solid's is 3/8 = 0.375,\n"
               "that of the skin with its base 1/3\n\n"
            << table;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  printCentres();

  const TriangleMesh mesh = halfBall(6, 12);
  const MassProperties exact = carom::massProperties(mesh, kDensity);
  carom::io::Table table;
  table.column("points").column("volume error", carom::io::scientific(1));
  table.column("expected", carom::io::scientific(1))
      .column("centre error [m]", carom::io::scientific(1));
  table.column("inertia error", carom::io::scientific(1));
  std::vector<Real> points, volumeErrors, centreErrors, inertiaErrors;
  for (int samples : {100, 1000, 10000, 100000}) {
    Real volume = 0, centre = 0, inertia = 0, expected = 0;  // sums of squares
    for (int seed = 1; seed <= kSeeds; ++seed) {
      const auto estimate =
          carom::monteCarloMass(mesh, kDensity, samples, static_cast<unsigned>(seed));
      volume += std::pow(estimate.body.volume / exact.volume - 1, 2);
      centre += (estimate.body.center - exact.center).squaredNorm();
      inertia +=
          (estimate.body.inertia - exact.inertia).squaredNorm() / exact.inertia.squaredNorm();
      expected += estimate.relativeError * estimate.relativeError;
    }
    const auto mean = [](Real sum) { return std::sqrt(sum / kSeeds); };
    table.row({samples, mean(volume), mean(expected), mean(centre), mean(inertia)});
    points.push_back(samples);
    volumeErrors.push_back(mean(volume));
    centreErrors.push_back(mean(centre));
    inertiaErrors.push_back(mean(inertia));
  }
  std::cout << "\nMonte Carlo against signed tetrahedra on a mesh of " << mesh.triangles.size()
            << " triangles, root mean square of " << kSeeds << " runs\n\n"
            << table;

  carom::io::Plot plot("Monte Carlo: a hundred times the points for one more digit");
  plot.xAxis("points", carom::io::Scale::Logarithmic);
  plot.yAxis("error", carom::io::Scale::Logarithmic);
  plot.curve("volume, relative", points, volumeErrors, {.marks = true});
  plot.curve("centre [m]", points, centreErrors, {.marks = true});
  plot.curve("inertia, relative", points, inertiaErrors, {.marks = true});
  plot.slope("1/sqrt(points)", -0.5, points.front(), volumeErrors.front());
  plot.writeSvg(folder / "three_methods.svg");
}

// Three ways to find where half a ball balances.
//
// Signed tetrahedra are exact for the mesh. Monte Carlo comes closer with the square root of the
// number of points. The centre of the skin is fast, exact, and the answer to another question.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
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
using carom::Vector3;

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

// How near a method comes to the centre of the true half ball with more and more work.
struct Track {
  std::string name;
  std::vector<Real> work = {}, error = {};  // triangles looked at; distance [m]

  void add(std::size_t triangles, Real off) {
    work.push_back(static_cast<Real>(triangles));
    error.push_back(off);
  }
};

Real distanceFromTruth(const Vector3& centre) {
  return (centre - Vector3(0, 0, 0.375)).norm();
}

void printWork(const std::filesystem::path& folder) {
  std::vector<Track> tracks = {{"tetrahedra"}, {"skin"}, {"Monte Carlo"}};
  for (int bands : {2, 8, 32, 128, 512}) {
    const TriangleMesh mesh = halfBall(bands, 4 * bands);
    tracks[0].add(mesh.triangles.size(), distanceFromTruth(carom::centerOfMass(mesh)));
    tracks[1].add(mesh.triangles.size(), distanceFromTruth(carom::shellCentroid(mesh)));
  }
  // A point looks at every triangle; the mesh is fine enough not to matter. Mean of eight runs.
  const TriangleMesh mesh = halfBall(16, 64);
  for (int samples : {10, 100, 1000, 10000}) {
    Real squares = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const auto estimate = carom::monteCarloMass(mesh, kDensity, samples, seed);
      squares += std::pow(distanceFromTruth(estimate.body.center), 2);
    }
    tracks[2].add(static_cast<std::size_t>(samples) * mesh.triangles.size(),
                  std::sqrt(squares / 8));
  }
  carom::io::Table table;
  table.column("method").column("triangles looked at", carom::io::scientific(1));
  table.column("error of the centre [m]", carom::io::scientific(1));
  carom::io::Plot plot("The centre of half a ball: error against work");
  plot.describe(
      "Tetrahedra fall as one over the work. The skin stays. Monte Carlo needs a hundred "
      "times the work for a digit and begins ten thousand times further right.");
  plot.xAxis("triangles looked at", carom::io::Scale::Logarithmic);
  plot.yAxis("error of the centre [m]", carom::io::Scale::Logarithmic);
  for (const Track& track : tracks) {
    for (std::size_t i = 0; i < track.work.size(); ++i) {
      table.row({track.name, track.work[i], track.error[i]});
    }
    plot.curve(track.name, track.work, track.error, {.marks = true});
  }
  std::cout << "\nWhat more work buys: distance from the centre of the true half ball\n\n" << table;
  plot.writeSvg(folder / "three_methods_work.svg");
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  printCentres();
  printWork(folder);
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

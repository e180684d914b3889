// How many darts for one more digit?
//
// A ball of 320 triangles and a tetrahedron are weighed by darts, with sixteen seeds for every
// number of darts. The picture has two logarithmic axes, so that a power of the number of darts is
// a straight line.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <vector>

#include "carom/mass/meshes.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "monte_carlo_error.hpp"

using carom::DartError;
using carom::Real;
using carom::TriangleMesh;

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<int> darts = {16, 64, 256, 1024, 4096, 16384};
  constexpr int kSeeds = 16;
  const TriangleMesh ball = carom::icosphereMesh(1, 1);
  const TriangleMesh corner = carom::tetrahedronMesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});

  const std::vector<DartError> ofBall = carom::monteCarloError(ball, darts, kSeeds);
  const std::vector<DartError> ofCorner = carom::monteCarloError(corner, darts, kSeeds);

  //! [theory]
  // Every dart hits or misses, so the hits spread as a binomial does.
  const auto theory = [](Real share, int samples) {
    return std::sqrt((1 - share) / (share * samples));
  };
  //! [theory]
  const Real shareOfBall = carom::signedVolume(ball) / 8;  // its box reaches from -1 to 1

  carom::io::Table table;
  table.column("darts").column("ball", carom::io::fixed(4)).column("theory", carom::io::fixed(4));
  table.column("tetrahedron", carom::io::fixed(4)).column("theory", carom::io::fixed(4));
  std::vector<Real> x, yBall, yCorner;
  for (std::size_t i = 0; i < darts.size(); ++i) {
    table.row({darts[i], ofBall[i].relativeError, theory(shareOfBall, darts[i]),
               ofCorner[i].relativeError, theory(1.0 / 6, darts[i])});
    x.push_back(darts[i]);
    yBall.push_back(ofBall[i].relativeError);
    yCorner.push_back(ofCorner[i].relativeError);
  }
  std::cout << "Relative error of the volume, root mean square of " << kSeeds << " runs\n\n"
            << table;

  carom::io::Plot plot("Weighing by darts");
  plot.describe(
      "The error of the volume against the number of darts, with logarithmic axes: two straight "
      "lines that fall by a factor of two for four times the darts.");
  plot.xAxis("darts", carom::io::Scale::Logarithmic);
  plot.yAxis("relative error", carom::io::Scale::Logarithmic);
  plot.curve("tetrahedron, 1/6 of its box", x, yCorner, {.marks = true});
  plot.curve("ball, about half of its box", x, yBall, {.marks = true});
  plot.slope("slope -1/2", -0.5, 16, theory(1.0 / 6, 16));
  plot.writeSvg(folder / "dart_error.svg");
}

// Weighing by random points: right on average, and only so fast.

#include <cmath>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

TEST_CASE(
    "random points find mass, centre and inertia of a body with a hole, within their own error "
    "bar") {
  const TriangleMesh torus = translated(torusMesh(2, 0.7, 16, 8), {10, -20, 30});
  const MassProperties exact = massProperties(torus, 5);
  const MonteCarloMass estimate = monteCarloMass(torus, 5, 40000, 1);
  CHECK(relativeError(estimate.body.volume, exact.volume) < 4 * estimate.relativeError);
  CHECK_THAT(estimate.body.mass, WithinRel(5 * estimate.body.volume, 1e-15));
  CHECK((estimate.body.center - exact.center).norm() < 0.05);
  CHECK(relativeError(estimate.body.inertia, exact.inertia) < 0.03);
  CHECK(estimate.samples == 40000);
}

TEST_CASE("a cavity counts as outside") {
  const TriangleMesh hollow = joined(boxMesh({-1, -1, -1}, {1, 1, 1}),
                                     reversed(boxMesh({-0.9, -0.9, -0.9}, {0.9, 0.9, 0.9})));
  const MonteCarloMass estimate = monteCarloMass(hollow, 1, 20000, 2);
  CHECK(relativeError(estimate.body.volume, 8 - 5.832) < 4 * estimate.relativeError);
}

TEST_CASE("a box that fills its bounding box is hit by every point") {
  const MonteCarloMass estimate = monteCarloMass(boxMesh({0, 0, 0}, {1, 2, 3}), 1, 1000, 3);
  CHECK(estimate.inside == 1000);
  CHECK(estimate.body.volume == 6);
  CHECK(estimate.relativeError == 0);
}

TEST_CASE("the error falls as one over the root of the number of points, over four decades") {
  // Root mean square error over seeds, N = 10 to 100000 on a tetrahedron (a share of one sixth).
  const TriangleMesh tetra = tetrahedronMesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  std::vector<Real> errors;
  for (const int samples : {10, 100, 1000, 10000, 100000}) {
    const int seeds = samples > 10000 ? 30 : 100;
    Real squares = 0;
    for (int seed = 0; seed < seeds; ++seed) {
      const Real volume =
          monteCarloMass(tetra, 1, samples, 1000 + static_cast<std::uint64_t>(seed)).body.volume;
      squares += std::pow(6 * volume - 1, 2) / seeds;
    }
    errors.push_back(std::sqrt(squares));
  }
  // Slope of log error against log N by least squares over the five points.
  Real slope = 0;
  for (int i = 0; i < 5; ++i)
    slope += (i - 2) * std::log10(errors[static_cast<std::size_t>(i)]) / 10;
  CHECK_THAT(slope, WithinAbs(-0.5, 0.05));
}

TEST_CASE("the same seed gives the same answer, another seed another") {
  const TriangleMesh ball = icosphereMesh(1, 1);
  CHECK(monteCarloMass(ball, 1, 500, 9).body.inertia ==
        monteCarloMass(ball, 1, 500, 9).body.inertia);
  CHECK(monteCarloMass(ball, 1, 500, 9).body.center !=
        monteCarloMass(ball, 1, 500, 10).body.center);
}

TEST_CASE("the generator is SplitMix64: its published first numbers for seed 1234567") {
  Random random(1234567);
  CHECK(random.bits() == 6457827717110365317u);
  CHECK(random.bits() == 3203168211198807973u);
  CHECK(random.bits() == 9817491932198370423u);
  for (int i = 0; i < 1000; ++i) {
    const Real x = random.between(-2, 3);
    CHECK((x >= -2 && x < 3));
  }
}

TEST_CASE("bad wishes are refused") {
  const TriangleMesh ball = icosphereMesh(1, 0);
  CHECK_THROWS_AS(monteCarloMass(ball, 1, 0, 1), InvalidInput);
  CHECK_THROWS_AS(monteCarloMass(ball, 1, -5, 1), InvalidInput);
  CHECK_THROWS_AS(monteCarloMass(ball, -1, 10, 1), InvalidInput);
  CHECK_THROWS_AS(monteCarloMass({}, 1, 10, 1), InvalidInput);
}

// Grader of 02.monte_carlo_mass: what must hold exactly, whatever the darts do, and closed forms
// within six times the spread that the darts have. Other orders of drawing are as right as ours.

#include "carom/mass/monte_carlo_mass.hpp"

#include <cmath>

#include "carom/mass/meshes.hpp"
#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings";
constexpr int kDarts = 20000;

Matrix3 diagonal(Real xx, Real yy, Real zz) {
  return Vector3(xx, yy, zz).asDiagonal();
}

// One sixth of its box.
TriangleMesh cornerOfBox(const Vector3& place) {
  return translated(tetrahedronMesh({0, 0, 0}, {5, 0, 0}, {0, 4, 0}, {0, 0, 3}), place);
}

// Volume of the box times hits over darts, whatever the darts did; -1 if there are no darts.
Real volumeFromHits(const MonteCarloMass& m, Real boxVolume) {
  return m.samples > 0 ? boxVolume * m.inside / m.samples : -1;
}

Real ratioOfVolumes(const MonteCarloMass& m, Real boxVolume) {
  return m.body.volume / volumeFromHits(m, boxVolume);
}

Real errorFromHits(const MonteCarloMass& m) {
  const Real p = Real(m.inside) / m.samples;
  return std::sqrt((1 - p) / (p * m.samples));
}

bool same(const MonteCarloMass& a, const MonteCarloMass& b) {
  return a.inside == b.inside && a.body.center == b.body.center && a.body.inertia == b.body.inertia;
}

}  // namespace

TEST_CASE("volume") {
  for (const int darts : {500, kDarts}) {
    GRADE(ratioOfVolumes(monteCarloMass(cornerOfBox({0, 0, 0}), 2, darts, seed()), 60), 1.0,
          within(1e-14, kRounding), given("mesh", "a tetrahedron in a box of 5 x 4 x 3 m"),
          given("samples", darts), about("your volume divided by 60 m^3 times hits over darts"));
  }
  GRADE(monteCarloMass(boxMesh({-1, 2, 0}, {1, 3, 5}), 2, 100, seed()).body.volume, 10.0,
        within(1e-14, kRounding),
        given("mesh", "the box [-1,1]x[2,3]x[0,5], which every dart hits"), given("samples", 100),
        unit("m^3"));
  GRADE(monteCarloMass(boxMesh({-1, 2, 0}, {1, 3, 5}), 2, 100, seed()).body.mass, 20.0,
        within(1e-14, kRounding),
        given("mesh", "the box [-1,1]x[2,3]x[0,5], which every dart hits"), given("samples", 100),
        given("density", 2.0, "kg/m^3"), unit("kg"));
}

TEST_CASE("hits") {
  const Real spread = std::sqrt(kDarts * (1.0 / 6) * (5.0 / 6));
  for (const Vector3& place : {Vector3(0, 0, 0), Vector3(-7, 12, 3)}) {
    GRADE(monteCarloMass(cornerOfBox(place), 1, kDarts, seed()).inside, kDarts / 6,
          within(6 * spread, "six times the spread of 20000 darts, of which one in six hits"),
          given("mesh", "a tetrahedron that fills one sixth of its box"),
          given("moved by", place, "m"), given("samples", kDarts));
  }
  GRADE(monteCarloMass(boxMesh({2, 2, 2}, {3, 4, 5}), 1, 777, seed()).inside, 777,
        within(0, "every dart hits a box"), given("mesh", "the box [2,3]x[2,4]x[2,5]"),
        given("samples", 777));
}

TEST_CASE("centre") {
  Matrix3 exact;
  exact << 9.375, 2.5, 1.875, 2.5, 12.75, 1.5, 1.875, 1.5, 15.375;
  for (const Vector3& place : {Vector3(0, 0, 0), Vector3(-20, 10, 30)}) {
    // About 3300 hits, each with a spread of 1 m: the mean is uncertain by 0.017 m.
    GRADE(monteCarloMass(cornerOfBox(place), 1, kDarts, seed()).body.center,
          Vector3(Vector3(1.25, 1, 0.75) + place),
          within(0.1, "six times the spread of the mean of some 3300 hits"),
          given("mesh", "the tetrahedron (0,0,0), (5,0,0), (0,4,0), (0,0,3)"),
          given("moved by", place, "m"), given("samples", kDarts), unit("m"));
    GRADE(monteCarloMass(cornerOfBox(place), 1, kDarts, seed()).body.inertia, exact,
          within(2.6, "six times the spread of the second moments of some 3300 hits"),
          given("mesh", "the tetrahedron (0,0,0), (5,0,0), (0,4,0), (0,0,3)"),
          given("moved by", place, "m"), given("density", 1.0, "kg/m^3"), given("samples", kDarts),
          unit("kg m^2"));
  }
  GRADE(monteCarloMass(boxMesh({0, 0, 0}, {1, 2, 3}), 1, kDarts, seed()).body.inertia,
        diagonal(6.5, 5, 2.5),
        within(0.3, "six times the spread of the second moments of 20000 hits"),
        given("mesh", "the box [0,1]x[0,2]x[0,3]"), given("density", 1.0, "kg/m^3"),
        given("samples", kDarts), unit("kg m^2"));
}

TEST_CASE("error") {
  const MonteCarloMass run = monteCarloMass(cornerOfBox({0, 0, 0}), 1, 3000, seed());
  GRADE(monteCarloMass(cornerOfBox({0, 0, 0}), 1, 3000, seed()).relativeError, errorFromHits(run),
        withinRelative(1e-13, kRounding),
        given("mesh", "a tetrahedron that fills one sixth of its box"),
        given("samples", run.samples), given("hits", run.inside));
  GRADE(monteCarloMass(boxMesh({2, 2, 2}, {3, 4, 5}), 1, 400, seed()).relativeError, 0.0,
        within(0, "every dart hits a box, so the estimate is exact"),
        given("mesh", "the box [2,3]x[2,4]x[2,5]"), given("samples", 400));
}

TEST_CASE("seed") {
  const TriangleMesh mesh = cornerOfBox({0, 0, 0});
  GRADE(same(monteCarloMass(mesh, 1, 300, 5), monteCarloMass(mesh, 1, 300, 5)), true,
        within(0, "yes or no"), given("samples", 300),
        about("the same seed twice gives the same answer"));
  GRADE(same(monteCarloMass(mesh, 1, 300, 5), monteCarloMass(mesh, 1, 300, 6)), false,
        within(0, "yes or no"), given("samples", 300),
        about("the seeds 5 and 6 give different answers"));
  GRADE(monteCarloMass(mesh, 1, 300, 5).samples, 300, within(0, "the number of darts thrown"),
        given("samples", 300));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(monteCarloMass(boxMesh({0, 0, 0}, {1, 1, 1}), 1, 0, 1), given("samples", 0));
  GRADE_REFUSES(monteCarloMass(boxMesh({0, 0, 0}, {1, 1, 1}), -1, 10, 1),
                given("density", -1.0, "kg/m^3"));
}

PROBES() {
  Random random(28);
  for (int n = 0; n < 16; ++n) {
    const Vector3 place = 0.1 * random.vector();
    PROBE(monteCarloMass(cornerOfBox(place), random.between(1, 3), 200, random.bits() >> 32));
  }
}

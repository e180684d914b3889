// Do the other ways of chapter 9 go where sweeps go, and where do they not?

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/solver/box_column.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "gradient_sweep.hpp"
#include "many_ways.hpp"
#include "shock_propagation.hpp"
#include "support/catch.hpp"

using carom::BoxColumn;
using carom::ContactRow;
using carom::GradientMemory;
using carom::MovingBody;
using carom::Real;
using carom::Vector3;
using carom_test::WithinAbs;
using carom_test::WithinRel;

namespace {

BoxColumn pulled(const std::vector<Real>& masses) {
  BoxColumn column = carom::boxColumn(masses);
  carom::pullDown(column.bodies, -1);
  return column;
}

// A plank of 2 m that lies on an edge below its middle, and a box that comes down on its right end.
struct SeeSaw {
  std::vector<MovingBody> bodies{3};
  std::vector<ContactRow> rows{2};

  SeeSaw() {
    bodies[1].mass = {1, 3 * carom::Matrix3::Identity()};
    bodies[2].mass.inverseMass = 0.1;
    bodies[2].velocity.linear = {0, 0, -1};
    rows[0].bodyB = 1;
    rows[1].bodyA = 1;
    rows[1].bodyB = 2;
    for (ContactRow& row : rows) row.contact.normal = Vector3::UnitZ();
    rows[1].contact.armA = {1, 0, 0};
  }
};

}  // namespace

TEST_CASE("sweeps that remember a direction come to the loads, and sooner than sweeps") {
  for (const int boxes : {2, 10, 40}) {
    INFO(boxes << " boxes");
    BoxColumn column = pulled(std::vector<Real>(static_cast<std::size_t>(boxes), 1));
    BoxColumn swept = column;
    GradientMemory memory;
    const int passes = 25 * boxes;
    for (int n = 0; n < passes; ++n) carom::gradientSweep(column.bodies, column.rows, memory);
    for (const ContactRow& row : column.rows) {
      CHECK_THAT(row.impulse, WithinAbs(boxes - row.name, 1e-5));
    }
    carom::sequentialImpulses(swept.bodies, swept.rows, passes);
    if (boxes == 40) CHECK(swept.rows[0].impulse < 39);
  }
}

TEST_CASE("sweeps that remember a direction never pull, and leave an answer alone") {
  carom::Random random(9);
  for (int heap = 0; heap < 20; ++heap) {
    BoxColumn column = pulled({1, 2, 5, 1, 3});
    // Some of the boxes are flying off.
    for (MovingBody& body : column.bodies) {
      if (body.mass.inverseMass > 0) body.velocity.linear.z() += random.between(-1, 2);
    }
    BoxColumn swept = column;
    carom::sequentialImpulses(swept.bodies, swept.rows, 2000);
    GradientMemory memory;
    for (int n = 0; n < 500; ++n) {
      carom::gradientSweep(column.bodies, column.rows, memory);
      for (const ContactRow& row : column.rows) REQUIRE(row.impulse >= 0);
    }
    for (std::size_t i = 0; i < column.rows.size(); ++i) {
      CHECK_THAT(column.rows[i].impulse, WithinAbs(swept.rows[i].impulse, 1e-9));
    }
  }
}

TEST_CASE("a shock from the ground holds up any tower in one pass, but the ground feels one box") {
  BoxColumn column = pulled({1, 1000, 1, 100});
  carom::shockPropagation(column.bodies, column.rows, 1);
  for (const MovingBody& body : column.bodies) CHECK(body.velocity.linear.norm() < 1e-15);
  CHECK_THAT(column.rows[0].impulse, WithinRel(1.0, 1e-15));
  CHECK_THAT(column.rows[1].impulse, WithinRel(1000.0, 1e-15));
  // The masses are as they were.
  CHECK(column.bodies[2].mass.inverseMass == 1.0 / 1000);
  CHECK(column.bodies[0].mass.inverseMass == 0);
}

TEST_CASE("under a shock a see-saw does not tip; under sweeps it does") {
  SeeSaw shocked, swept;
  carom::shockPropagation(shocked.bodies, shocked.rows, 100);
  CHECK(shocked.bodies[1].velocity.angular.norm() == 0);
  CHECK(shocked.bodies[2].velocity.linear.norm() < 1e-15);
  carom::sequentialImpulses(swept.bodies, swept.rows, 1000);
  // The end of the plank and the box go on together, with the momentum about the edge that the box
  // had: 10 kg m^2/s over 10 + 1/3 kg m^2.
  CHECK_THAT(swept.bodies[1].velocity.angular.y(), WithinRel(10 / (10 + 1.0 / 3), 1e-9));
}

TEST_CASE("of four ways all but the shock know what the ground carries") {
  const auto ways = carom::manyWays(pulled(std::vector<Real>(20, 1)), 1e-9);
  REQUIRE(ways.size() == 4);
  for (const auto& way : ways) {
    INFO(way.name);
    CHECK(way.speeds.back() <= 1e-9);
    const bool shock = way.name == "shock propagation";
    CHECK_THAT(way.ground, WithinAbs(shock ? 1 : 20, 1e-6));
  }
  CHECK(ways[1].passes < ways[0].passes / 10);
  CHECK(ways[2].passes == 1);
  CHECK(ways[3].passes < 10);
}

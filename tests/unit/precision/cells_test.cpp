#include <cmath>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/precision/cell_position.hpp"
#include "carom/precision/relative_to_origin.hpp"
#include "carom/precision/steps_until.hpp"
#include "carom/precision/time_of_step.hpp"
#include "carom/precision/ulp.hpp"
#include "support/catch.hpp"

using namespace carom;

TEST_CASE("a position is cut into cell and offset without loss") {
  const CellPosition p = cellPosition({1e7, -0.125, -1536});
  CHECK(p.cell == std::array<std::int64_t, 3>{9766, 0, -2});
  CHECK(p.offset == Vector3(1e7 - 9766 * 1024, -0.125, 512));
  Random random(77);
  for (int i = 0; i < 5000; ++i) {
    const Vector3 v = random.vector(std::ldexp(1.0, random.integer(0, 60)));
    const CellPosition c = cellPosition(v);
    REQUIRE(c.offset.cwiseAbs().maxCoeff() <= kCellSize / 2);
    REQUIRE(relativeToOrigin(c, CellPosition{}) == v);
  }
}

TEST_CASE("what is near in a far cell is as exact as at the origin") {
  CellPosition a = cellPosition({0.5, 0.25, 300}), b = cellPosition({-511.0, 0, 0});
  const Vector3 atHome = relativeToOrigin(a, b);
  for (auto* p : {&a, &b}) p->cell = {1000000000000, -7, p->cell[2] + 4000000000000000};
  CHECK(relativeToOrigin(a, b) == atHome);
  CHECK(relativeToOrigin(b, a) == -atHome);
}

TEST_CASE("a walk of a million steps through the cells ends where counting says") {
  CellPosition p = cellPosition({1e7, 0, 0});
  const CellPosition start = p;
  const Vector3 step(0.25, -0.125, 0x1p-10);  // sums of these are exact
  for (int i = 0; i < 1000000; ++i) {
    p = moved(p, step);
    REQUIRE(p.offset.cwiseAbs().maxCoeff() <= kCellSize / 2);
  }
  CHECK(relativeToOrigin(p, start) == Vector3(250000, -125000, 1000000 * 0x1p-10));
}

TEST_CASE("floats in cells are good to the spacing of floats in half a cell") {
  FloatCellPosition p;
  CellPosition q;
  for (int i = 0; i < 10000; ++i) {
    p = moved(p, Eigen::Vector3f(1.5f, 0.1f, 0));
    q = moved(q, Vector3(1.5, Real(0.1f), 0));
  }
  CHECK(p.cell == q.cell);
  const Real rounding = 10000 * Real(ulp(511.0f)) / 2;
  CHECK(relativeToOrigin(inDoubles(p), q).cwiseAbs().maxCoeff() < rounding);
}

TEST_CASE("moving the origin nearer rounds nothing, and moving it back undoes it") {
  Random random(78);
  CellPosition origin = cellPosition({3e6, 0, 0});
  std::vector<Vector3> positions;
  const Vector3 far(5e6, -2e6, 1e4);
  for (int i = 0; i < 100; ++i) positions.push_back(far + random.vector(100));
  const std::vector<Vector3> before = positions;
  moveOrigin(origin, far, positions);
  for (std::size_t i = 0; i < 100; ++i) {
    CHECK(positions[i].cwiseAbs().maxCoeff() < 700);
    const CellPosition body = moved(origin, positions[i]);
    CHECK(relativeToOrigin(body, cellPosition({3e6, 0, 0})) == before[i]);
  }
  const Vector3 back = relativeToOrigin(cellPosition({3e6, 0, 0}), origin);
  moveOrigin(origin, back, positions);
  CHECK(positions == before);
}

TEST_CASE("positions that cannot be held are refused, and nothing has changed") {
  CHECK_THROWS_AS(cellPosition({std::nan(""), 0, 0}), InvalidInput);
  CHECK_THROWS_AS(cellPosition({0, 1e30, 0}), InvalidInput);
  CellPosition origin;
  origin.cell[0] = std::int64_t{1} << 53;
  std::vector<Vector3> positions{{1, 2, 3}};
  CHECK_THROWS_AS(moveOrigin(origin, {5000, 0, 0}, positions), InvalidInput);
  CHECK(origin.cell[0] == std::int64_t{1} << 53);
  CHECK(positions[0] == Vector3(1, 2, 3));
}

TEST_CASE("the time of a step is count times step, whatever the count") {
  CHECK(timeOfStep(0, 0.1, 0) == 0);
  CHECK(timeOfStep(3, 0.5, 10) == 11.5);
  CHECK(timeOfStep(-4, 0.25, 0) == -1);
  CHECK(timeOfStep(5000000000, 0.25, 0) == 1.25e9);
  CHECK_THROWS_AS(timeOfStep(1, std::nan(""), 0), InvalidInput);
  CHECK_THROWS_AS(timeOfStep(std::int64_t{1} << 60, 1, 0), InvalidInput);
  CHECK(stepsUntil(10, 0.1) == 100);
  CHECK(stepsUntil(0, 0.1) == 0);
  CHECK_THROWS_AS(stepsUntil(1, 0), InvalidInput);
  CHECK_THROWS_AS(stepsUntil(1e300, 1e-10), InvalidInput);
}

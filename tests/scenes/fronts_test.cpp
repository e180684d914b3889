// Does the comparison at equal error say what its rules say? On fronts that are made up.

#include "scenes/fronts.hpp"

#include <cmath>

#include "support/catch.hpp"

using carom::Real;
using carom_test::WithinRel;
using namespace carom::scenes;

TEST_CASE("a front holds the runs that no other beats, the cheapest first") {
  // Dearer and worse, equally dear and worse, dearer and as wrong: all beaten.
  const Front front = frontOf(
      {{8, 1e-3}, {1, 1e-1}, {2, 3e-1}, {1, 2e-1}, {4, 1e-2}, {16, 1e-3}, {5, 2e-2}}, 1e-13);
  REQUIRE(front.size() == 3);
  CHECK(front[0].cost == 1);
  CHECK(front[1].cost == 4);
  CHECK(front[2].cost == 8);
  CHECK(front[2].error == 1e-3);
  CHECK(frontOf({}, 1e-13).empty());
}

TEST_CASE("errors that rounding makes count as the bound: the cheapest of such runs is the end") {
  const Front front = frontOf({{1, 1e-2}, {2, 1e-14}, {3, 0}, {4, 1e-16}}, 1e-13);
  REQUIRE(front.size() == 2);
  CHECK(front[1].cost == 2);
  CHECK(front[1].error == 1e-13);
}

TEST_CASE("between two points the cost lies on the line through their logarithms") {
  // A method of second order: four times the error for half the cost.
  const Front front = frontOf({{1, 4e-2}, {2, 1e-2}, {4, 0.25e-2}}, 1e-13);
  for (const Real error : {3e-2, 1e-2, 0.7e-2, 0.3e-2}) {
    CHECK_THAT(costAt(front, error).value(), WithinRel(std::sqrt(4e-2 / error), 1e-12));
  }
}

TEST_CASE("beyond its ends a front has no line: nothing is gained, and nothing is reached") {
  const Front front = frontOf({{3, 1e-2}, {6, 1e-4}}, 1e-13);
  CHECK(costAt(front, 1).value() == 3);
  CHECK(costAt(front, 1e-2).value() == 3);
  CHECK(costAt(front, 1e-4).value() == 6);
  CHECK_FALSE(costAt(front, 0.99e-4));
  CHECK_FALSE(costAt({}, 1));
}

TEST_CASE("the cheapest of the others is asked for at every error that one of them reaches") {
  const std::vector<NamedFront> theirs{{"coarse", frontOf({{1, 1e-1}, {2, 1e-2}}, 1e-13)},
                                       {"fine", frontOf({{10, 1e-2}, {20, 1e-4}}, 1e-13)},
                                       {"fallen", {}}};
  const std::vector<NamedFront> ours{{"steps", frontOf({{0.1, 1e-2}, {0.5, 1e-3}}, 1e-13)},
                                     {"whole", frontOf({{0.2, 1e-3}}, 1e-13)}};
  const auto all = compareFronts(ours, theirs);
  REQUIRE(all.size() == 3);
  CHECK(all[0].error == 1e-1);
  CHECK(all[0].theirs.name == "coarse");
  CHECK_THAT(all[0].ratio(), WithinRel(10.0, 1e-12));
  // At 1e-2 both are there, and the cheaper one counts.
  CHECK(all[1].error == 1e-2);
  CHECK(all[1].theirs.name == "coarse");
  CHECK_THAT(all[1].ratio(), WithinRel(20.0, 1e-12));
  // Nobody of ours gets to 1e-4, however cheap: that is behind, and not nearly as good.
  CHECK(all[2].error == 1e-4);
  CHECK(all[2].theirs.name == "fine");
  CHECK_FALSE(all[2].ours);
  CHECK(all[2].ratio() == 0);
}

TEST_CASE("ours is taken between its points, not at the better one of them") {
  const std::vector<NamedFront> theirs{{"peer", frontOf({{100, 1e-3}}, 1e-13)}};
  const std::vector<NamedFront> ours{{"steps", frontOf({{1, 1e-2}, {100, 1e-4}}, 1e-13)}};
  const auto all = compareFronts(ours, theirs);
  REQUIRE(all.size() == 1);
  CHECK_THAT(all[0].ours.value().cost, WithinRel(10.0, 1e-12));
  CHECK_THAT(all[0].ratio(), WithinRel(10.0, 1e-12));
}

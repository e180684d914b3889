// Grader of 08.grid_pairs: scenes whose pairs are found by trying all, with several cells.

#include "carom/broadphase/grid_pairs.hpp"

#include <limits>

#include "box_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kWhole = "numbers of boxes are whole numbers";
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

void ask(const Boxes& boxes, Real cell, const Pairs& expected, const char* what) {
  GRADE(gridPairs(boxes, cell), expected, within(0, kWhole), given("boxes", boxes, "m"),
        given("cell", cell, "m"), about(what));
}

}  // namespace

TEST_CASE("crowd") {
  Random random(seed());
  for (const Real cell : {0.7, 1.3, 2.0, 5.0}) {
    Boxes boxes = crowd(random, 60, 2.5);
    for (Aabb<3>& box : boxes) {
      box.low += Vector3::Constant(20);
      box.high += Vector3::Constant(20);
    }
    ask(boxes, cell, pairsAmong(boxes), "sixty boxes, all on the positive side");
  }
  const Boxes across = {boxFrom({0.9, 0, 0}, {1.1, 0.5, 0.5}),
                        boxFrom({1.05, 0, 0}, {1.3, 0.5, 0.5})};
  ask(across, 1, {{0, 1}}, "a short box across the border of two cells");
}

TEST_CASE("negative") {
  const Boxes boxes = {
      boxFrom({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), boxFrom({-1.5, -0.4, -0.4}, {-0.4, 0.3, 0.3}),
      boxFrom({0.4, -0.4, -0.4}, {1.5, 0.3, 0.3}), boxFrom({-2.5, -2.5, -2.5}, {-1.2, -0.2, -0.2})};
  ask(boxes, 1, {{0, 1}, {0, 2}, {1, 3}}, "boxes across zero and below it");
  Random random(seed());
  const Boxes any = crowd(random, 50, 2);
  ask(any, 1, pairsAmong(any), "fifty boxes about the origin");
}

TEST_CASE("big") {
  const Boxes boxes = {boxFrom({0, 0, 0}, {1, 1, 1}), boxFrom({-500, -500, -1}, {500, 500, 0.5}),
                       boxFrom({30, 0, 0.4}, {31, 1, 1.4}), boxFrom({2, -500, -3}, {3, 500, 9})};
  ask(boxes, 1, {{0, 1}, {1, 2}, {1, 3}}, "a floor and a wall of a kilometre, two pebbles");
  Boxes ground = boxes;
  ground[1] = boxFrom({-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, 0.5});
  ask(ground, 1, {{0, 1}, {1, 2}, {1, 3}}, "a ground that reaches to infinity");
  ask(boxes, 0.01, {{0, 1}, {1, 2}, {1, 3}}, "cells for which all are big");
}

TEST_CASE("once") {
  const Boxes boxes = {boxFrom({0, 0, 0}, {3, 3, 3}), boxFrom({1, 1, 1}, {4, 4, 4}),
                       boxFrom({4, 1, 1}, {5, 2, 2}), boxFrom({4.1, 3.5, 3.5}, {4.4, 3.8, 3.8})};
  ask(boxes, 1, {{0, 1}, {1, 2}}, "two that share many cells, two that touch");
  ask(boxes, 8, {{0, 1}, {1, 2}}, "all in one cell");
}

TEST_CASE("refuses") {
  Boxes boxes = {boxFrom({0, 0, 0}, {1, 1, 1})};
  GRADE_REFUSES(gridPairs(boxes, 0), given("cell", 0.0, "m"));
  boxes[0].low.x() = std::nan("");
  GRADE_REFUSES(gridPairs(boxes, 1), given("boxes", boxes, "m"));
}

PROBES() {
  Random random(820);
  for (int n = 0; n < 16; ++n) {
    Boxes boxes = crowd(random, 9 + n % 3, 1.3);
    boxes[2] = boxFrom({-9, -9, -0.2}, {9, 9, 0.2});
    boxes[5] = boxFrom({-0.2, -9, -9}, {0.2, 9, 9});
    // A neighbour that touches.
    boxes[4].low.x() = boxes[1].high.x();
    boxes[4].high.x() = boxes[4].low.x() + 1;
    boxes[4].low.y() = boxes[1].low.y();
    boxes[4].high.y() = boxes[1].high.y();
    boxes[4].low.z() = boxes[1].low.z();
    boxes[4].high.z() = boxes[1].high.z();
    PROBE(gridPairs(boxes, 1));
  }
}

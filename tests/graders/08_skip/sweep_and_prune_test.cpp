// Grader of 08.sweep_and_prune: scenes whose pairs are found by trying all.

#include "carom/broadphase/sweep_and_prune.hpp"

#include <limits>

#include "box_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kWhole = "numbers of boxes are whole numbers";
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

void ask(const Boxes& boxes, const Pairs& expected, const char* what) {
  GRADE(sweepAndPrune(boxes), expected, within(0, kWhole), given("boxes", boxes, "m"), about(what));
}

}  // namespace

TEST_CASE("crowd") {
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Boxes boxes = crowd(random, 60, 2.5);
    ask(boxes, pairsAmong(boxes), "sixty boxes, most of which meet several others");
  }
  const Boxes row = {boxFrom({0, 0, 0}, {10, 1, 1}), boxFrom({1, 0, 0}, {2, 1, 1}),
                     boxFrom({3, 0, 0}, {4, 1, 1}), boxFrom({5, 0, 0}, {6, 1, 1})};
  ask(row, {{0, 1}, {0, 2}, {0, 3}}, "three small boxes in one long one");
}

TEST_CASE("long") {
  const Boxes boxes = {boxFrom({0, 0, 0}, {1, 1, 1}), boxFrom({2, 0, 0}, {3, 1, 1}),
                       boxFrom({4, 0, 0}, {5, 1, 1}), boxFrom({-1, 0, 0}, {99, 1, 1})};
  ask(boxes, {{0, 3}, {1, 3}, {2, 3}}, "the last box begins before the others and ends far behind");
  Boxes ground = boxes;
  ground[3] = boxFrom({-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, 0.5});
  ask(ground, {{0, 3}, {1, 3}, {2, 3}}, "a ground that reaches to infinity");
}

TEST_CASE("touch") {
  const Boxes row = {boxFrom({0, 0, 0}, {1, 1, 1}), boxFrom({1, 0, 0}, {2, 1, 1}),
                     boxFrom({2, 1, 0}, {3, 2, 1}), boxFrom({2, 0, 1}, {3, 1, 2})};
  ask(row, {{0, 1}, {1, 2}, {1, 3}, {2, 3}}, "cubes that share a face, or an edge");
  const Boxes tower = {boxFrom({0, 0, 0}, {1, 1, 1}), boxFrom({0, 0, 1}, {1, 1, 2}),
                       boxFrom({0.5, 0, 5}, {1.5, 1, 6}), boxFrom({0.5, 4, 0}, {1.5, 5, 1})};
  ask(tower, {{0, 1}}, "one above the other; two more are apart on y or z only");
}

TEST_CASE("names") {
  const Boxes boxes = {boxFrom({4, 0, 0}, {6, 1, 1}), boxFrom({3, 0, 0}, {5, 1, 1}),
                       boxFrom({2, 0, 0}, {4, 1, 1}), boxFrom({1, 0, 0}, {3, 1, 1})};
  ask(boxes, {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}, "boxes that are given from right to left");
}

TEST_CASE("refuses") {
  Boxes boxes = {boxFrom({0, 0, 0}, {1, 1, 1}), boxFrom({0, 0, 0}, {1, std::nan(""), 1})};
  GRADE_REFUSES(sweepAndPrune(boxes), given("boxes", boxes, "m"));
  boxes[1] = boxFrom({0, 0, 0}, {1, -1, 1});
  GRADE_REFUSES(sweepAndPrune(boxes), given("boxes", boxes, "m"));
}

PROBES() {
  Random random(810);
  for (int n = 0; n < 16; ++n) {
    Boxes boxes = crowd(random, 8 + n % 3, 1.2);
    boxes[n % 8].high.x() += 5;
    boxes[n % 8].low.x() -= n % 2;
    // A neighbour that touches.
    boxes[(n + 3) % 8].low.x() = boxes[(n + 1) % 8].high.x();
    boxes[(n + 3) % 8].high.x() = boxes[(n + 3) % 8].low.x() + 1;
    PROBE(sweepAndPrune(boxes));
  }
}

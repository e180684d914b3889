// Grader of 03.convex_parts: Pacman and what lies in his mouth; a cup; and figures of whole
// rectangles, judged by counting the cells and the points of a grid that they have in common.

#include "carom/detection/convex_parts.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kYesNo = "one of three words";

using Corners = std::vector<Vector2>;
using Parts = std::vector<Corners>;

Corners rectangle(Real x0, Real y0, Real x1, Real y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// A sector of a disc of radius 1 m at the origin, between two angles in parts of a half turn.
Corners sector(Real from, Real to) {
  Corners corners = {{0, 0}};
  for (int i = 0; i <= 6; ++i) {
    const Real angle = (from + (to - from) * i / 6) * 3.141592653589793;
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  return corners;
}

// He looks along x, his jaws open by 45 degrees up and down.
const Parts pacman = {sector(0.25, 1), sector(1, 1.75)};

Parts squareAt(Real x, Real y) {
  return {rectangle(x - 0.1, y - 0.1, x + 0.1, y + 0.1)};
}

// A cup, open at the top: floor, left wall, right wall.
const Parts cup = {rectangle(0, 0, 6, 1), rectangle(0, 1, 1, 5), rectangle(5, 1, 6, 5)};

Parts reversed(Parts parts) {
  std::reverse(parts.begin(), parts.end());
  return parts;
}

// Pacman in words: his corners are cosines with sixteen digits.
auto shown(const char* name, const Parts& parts) {
  if (parts == pacman || parts == reversed(pacman)) {
    const std::string first = parts == pacman ? "upper" : "lower";
    return given(name,
                 "Pacman: a disc of radius 1 m about (0, 0), jaws open by 45 degrees up and "
                 "down from the x axis, in two halves, the " +
                     first + " one first");
  }
  return given(name, parts, "m");
}

void askBothWays(const Parts& one, const Parts& other, const char* verdict, const char* what) {
  for (const bool swapped : {false, true}) {
    for (const bool turned : {false, true}) {
      const Parts first = turned ? reversed(one) : one;
      const Parts& a = swapped ? other : first;
      const Parts& b = swapped ? first : other;
      GRADE(inWords(convexParts(a, b)), verdict, within(0, kYesNo), shown("a", a), shown("b", b),
            about(what));
    }
  }
}

struct Cells {
  int x0, y0, x1, y1;
  Corners corners() const {
    return rectangle(x0, y0, x1, y1);
  }
};

std::vector<Cells> anyFigure(Random& random) {
  std::vector<Cells> all;
  for (int n = random.integer(2, 3); n > 0; --n) {
    const int x = random.integer(0, 7), y = random.integer(0, 7);
    all.push_back({x, y, x + random.integer(1, 2), y + random.integer(1, 2)});
  }
  return all;
}

Parts partsOf(const std::vector<Cells>& figure) {
  Parts parts;
  for (const Cells& cells : figure) parts.push_back(cells.corners());
  return parts;
}

const char* byCounting(const std::vector<Cells>& a, const std::vector<Cells>& b) {
  bool cell = false, point = false;
  for (int x = 0; x <= 10; ++x) {
    for (int y = 0; y <= 10; ++y) {
      const auto holdsCell = [&](const Cells& c) {
        return c.x0 <= x && x < c.x1 && c.y0 <= y && y < c.y1;
      };
      const auto holdsPoint = [&](const Cells& c) {
        return c.x0 <= x && x <= c.x1 && c.y0 <= y && y <= c.y1;
      };
      cell = cell || (std::any_of(a.begin(), a.end(), holdsCell) &&
                      std::any_of(b.begin(), b.end(), holdsCell));
      point = point || (std::any_of(a.begin(), a.end(), holdsPoint) &&
                        std::any_of(b.begin(), b.end(), holdsPoint));
    }
  }
  return cell ? "overlapping" : (point ? "touching" : "separated");
}

}  // namespace

TEST_CASE("mouth") {
  askBothWays(pacman, squareAt(0.2, 0.6), "overlapping", "a morsel in Pacman's upper jaw");
  askBothWays(pacman, squareAt(0.2, -0.6), "overlapping", "a morsel in Pacman's lower jaw");
  askBothWays(pacman, squareAt(0.7, 0), "separated", "a morsel in the open mouth, not yet bitten");
  askBothWays(pacman, squareAt(-0.5, 0), "overlapping", "a morsel across the cut of the halves");
  askBothWays(pacman, squareAt(1.5, 0), "separated", "a morsel in front of him");
}

TEST_CASE("cup") {
  askBothWays(cup, {rectangle(2, 1, 4, 3)}, "touching",
              "a block that stands on the floor of a cup");
  askBothWays(cup, {rectangle(1, 1, 5, 3)}, "touching", "a block that just fits between the walls");
  askBothWays(cup, {rectangle(2, 0.5, 4, 3)}, "overlapping",
              "a block sunk into the floor of a cup");
  askBothWays(cup, {rectangle(2, 2, 4, 3)}, "separated", "a block that hangs in the cup");
  askBothWays(cup, {rectangle(4.5, 1, 5.5, 3)}, "overlapping",
              "a block that touches the floor and is sunk into a wall");
}

TEST_CASE("grid") {
  Random random(seed());
  for (int n = 0; n < 60; ++n) {
    const std::vector<Cells> a = anyFigure(random), b = anyFigure(random);
    GRADE(inWords(convexParts(partsOf(a), partsOf(b))), byCounting(a, b), within(0, kYesNo),
          given("partsOf(a)", partsOf(a), "m"), given("partsOf(b)", partsOf(b), "m"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(convexParts(Parts{}, cup), about("a figure without parts"));
}

PROBES() {
  Random random(309);
  for (int n = 0; n < 28; ++n) {
    const Parts b = partsOf(anyFigure(random)), a = partsOf(anyFigure(random));
    PROBE(convexParts(a, b));
  }
  PROBE(convexParts(pacman, squareAt(0.7, 0)));
  PROBE(convexParts(pacman, squareAt(0.2, -0.6)));
  PROBE(convexParts(cup, Parts{rectangle(4.5, 1, 5.5, 3)}));
  PROBE(convexParts(cup, Parts{rectangle(1, 1, 5, 3)}));
}

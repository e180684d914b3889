// Grader of 10.color_graph: properties, since there is more than one right answer.

#include "carom/solver/color_graph.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "grading/fields_solver.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Edges = std::vector<ColorEdge>;
using Colors = std::vector<std::int32_t>;

constexpr const char* kCount = "a count";

// Pairs of a body that can be moved and a colour that it has more than once; a contact without a
// colour counts as well.
int clashes(const Colors& colors, const Edges& edges, std::int32_t movable) {
  int count = 0;
  std::set<std::pair<std::int32_t, std::int32_t>> taken;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e >= colors.size() || colors[e] < 0) {
      ++count;
      continue;
    }
    for (const std::int32_t body : {edges[e].a, edges[e].b}) {
      if (body < movable && !taken.insert({body, colors[e]}).second) ++count;
    }
  }
  return count;
}

// One more than the greatest colour, so that gaps count.
int colorsIn(const Colors& colors) {
  return colors.empty() ? 0 : *std::max_element(colors.begin(), colors.end()) + 1;
}

int greatestDegree(const Edges& edges, std::int32_t movable) {
  std::map<std::int32_t, int> degree;
  int greatest = 0;
  for (const ColorEdge& edge : edges) {
    const std::int32_t ends[] = {edge.a, edge.b};
    for (const std::int32_t body : ends) {
      if (body < movable) greatest = std::max(greatest, ++degree[body]);
    }
  }
  return greatest;
}

// Colours above 2 d - 1; all contacts, where one has none or shares a body.
int tooMany(const Colors& colors, const Edges& edges, std::int32_t movable) {
  if (clashes(colors, edges, movable) > 0) return static_cast<int>(edges.size());
  return std::max(0, colorsIn(colors) - (2 * greatestDegree(edges, movable) - 1));
}

// Colours between zero and the greatest that no contact has.
int gaps(const Colors& colors) {
  const std::set<std::int32_t> used(colors.begin(), colors.end());
  return colorsIn(colors) - static_cast<int>(used.size());
}

// Different pairs, in any order. Bodies from `movable` on, `still` of them, cannot be moved.
Edges randomEdges(Random& random, int movable, int still, int count) {
  std::set<std::pair<int, int>> pairs;
  Edges edges;
  while (static_cast<int>(edges.size()) < count) {
    const int a = random.integer(0, movable - 1);
    const int b = random.integer(0, movable + still - 1);
    if (a == b || !pairs.insert({std::min(a, b), std::max(a, b)}).second) continue;
    const bool turned = random.integer(0, 1) == 1;
    edges.push_back(turned ? ColorEdge{b, a} : ColorEdge{a, b});
  }
  return edges;
}

// Boxes in a row: 0-1, 1-2, 2-3, ...
Edges rowOf(int boxes) {
  Edges edges;
  for (std::int32_t i = 0; i + 1 < boxes; ++i) edges.push_back({i, i + 1});
  return edges;
}

// One body among many: 0-1, 0-2, 0-3, ...
Edges starOf(int contacts) {
  Edges edges;
  for (std::int32_t i = 1; i <= contacts; ++i) {
    edges.push_back(i % 2 == 0 ? ColorEdge{0, i} : ColorEdge{i, 0});
  }
  return edges;
}

}  // namespace

TEST_CASE("neighbours") {
  const Edges triangle = {{0, 1}, {1, 2}, {2, 0}};
  GRADE(colorsIn(colorGraph(triangle, 3)), 3, within(0, kCount), given("edges", triangle),
        given("movable", 3), about("three boxes that all touch: the number of colours"));
  GRADE(clashes(colorGraph(triangle, 3), triangle, 3), 0, within(0, kCount),
        given("edges", triangle), given("movable", 3),
        about("bodies that have one colour twice, three boxes that all touch"));
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const int movable = random.integer(6, 14);
    const Edges edges = randomEdges(random, movable, 1, 2 * movable);
    GRADE(clashes(colorGraph(edges, movable), edges, movable), 0, within(0, kCount),
          given("edges", edges), given("movable", movable),
          about("bodies that can be moved and have one colour twice"));
  }
}

TEST_CASE("few") {
  const Edges row = rowOf(12);
  GRADE(colorsIn(colorGraph(row, 12)), 2, within(1, "two, or the three that one pass promises"),
        given("edges", row), given("movable", 12),
        about("twelve boxes in a row: one more than the greatest colour"));
  Random random(seed() + 1);
  for (int n = 0; n < 4; ++n) {
    const int movable = random.integer(20, 30);
    const Edges edges = randomEdges(random, movable, 0, movable + movable / 2);
    GRADE(tooMany(colorGraph(edges, movable), edges, movable), 0, within(0, kCount),
          given("edges", edges), given("movable", movable),
          about("colours above 2 d - 1, for d contacts at the body that has most"));
    GRADE(gaps(colorGraph(edges, movable)), 0, within(0, kCount), given("edges", edges),
          given("movable", movable), about("colours that no contact has, below the greatest"));
  }
  const Edges apart = {{0, 1}, {2, 3}, {4, 5}};
  GRADE(colorGraph(apart, 6), (Colors{0, 0, 0}), within(0, "all have the first colour"),
        given("edges", apart), given("movable", 6), about("three contacts that share no body"));
}

TEST_CASE("ground") {
  Edges floor;
  for (std::int32_t i = 0; i < 20; ++i) {
    floor.push_back(i % 2 == 0 ? ColorEdge{20, i} : ColorEdge{i, 20});
  }
  GRADE(colorGraph(floor, 20), Colors(20, 0), within(0, "all have the first colour"),
        given("edges", floor), given("movable", 20), about("twenty boxes on one floor, body 20"));
  const Edges stones = {{0, 2}, {0, 3}, {1, 3}};
  GRADE(clashes(colorGraph(stones, 2), stones, 2), 0, within(0, kCount), given("edges", stones),
        given("movable", 2),
        about("box 0 lies on two stones, 2 and 3: bodies that have one colour twice"));
  GRADE(colorsIn(colorGraph(stones, 2)), 2, within(0, kCount), given("edges", stones),
        given("movable", 2), about("box 0 lies on two stones, 2 and 3: the number of colours"));
}

TEST_CASE("many") {
  const Edges star = starOf(100);
  GRADE(colorsIn(colorGraph(star, 101)), 100, within(0, kCount), given("contacts", 100),
        about("body 0 touches a hundred others: the number of colours"));
  GRADE(clashes(colorGraph(star, 101), star, 101), 0, within(0, kCount), given("contacts", 100),
        about("body 0 touches a hundred others: bodies that have one colour twice"));
}

TEST_CASE("refuses") {
  const Edges fine = {{0, 1}}, below = {{0, 1}, {1, -1}}, alone = {{0, 1}, {1, 1}};
  GRADE_REFUSES(colorGraph(below, 2), given("edges", below));
  GRADE_REFUSES(colorGraph(alone, 2), given("edges", alone));
  GRADE_REFUSES(colorGraph(fine, -1), given("movable", -1));
}

PROBES() {
  Random random(1020);
  for (int n = 0; n < 14; ++n) {
    const int movable = random.integer(6, 12);
    const Edges edges = randomEdges(random, movable, n % 3, 2 * movable - 2);
    PROBE(clashes(colorGraph(edges, movable), edges, movable));
    PROBE(colorsIn(colorGraph(edges, movable)));
  }
  const Edges star = starOf(70);
  PROBE(clashes(colorGraph(star, 71), star, 71));
  PROBE(gaps(colorGraph(rowOf(8), 8)));
}

// Grader of 10.what_it_costs: lines and colours are counted, threads are added up.

#include <algorithm>
#include <set>
#include <vector>

#include "carom/solver/color_graph.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Within kMargin = withinRelative(0.05, "a prediction may be 5% off");

// Lines of 64 bytes in which numbers of 8 bytes begin that lie so far apart.
int linesOf(int count, int apart) {
  std::set<int> lines;
  for (int i = 0; i < count; ++i) lines.insert(i * apart / 64);
  return static_cast<int>(lines.size());
}

Real stepOf(int threads) {
  return 2 + Real(8) / threads;
}

int colorsOf(const std::vector<ColorEdge>& edges, std::int32_t movable) {
  const std::vector<std::int32_t> colors = colorGraph(edges, movable);
  return *std::max_element(colors.begin(), colors.end()) + 1;
}

int colorsOnGround() {
  std::vector<ColorEdge> edges;
  for (std::int32_t ball = 0; ball < 12; ++ball) edges.push_back({ball, 12});
  return colorsOf(edges, 12);
}

int colorsOnPlate() {
  std::vector<ColorEdge> edges = {{12, 13}};
  for (std::int32_t ball = 0; ball < 12; ++ball) edges.push_back({ball, 12});
  return colorsOf(edges, 13);
}

}  // namespace

TEST_CASE("lines") {
  GRADE(predicted("lines_of_whole_bodies", "lines"), static_cast<Real>(linesOf(1000, 256)), kMargin,
        unit("lines"), about("one number of 8 bytes out of every 256"));
  GRADE(predicted("lines_side_by_side", "lines"), static_cast<Real>(linesOf(1000, 8)), kMargin,
        unit("lines"), about("a thousand numbers of 8 bytes side by side"));
}

TEST_CASE("threads") {
  GRADE(predicted("step_two_threads", "ms"), stepOf(2), kMargin, unit("ms"),
        about("10 ms, of which 2 ms cannot be shared, with two threads"));
  GRADE(predicted("step_eight_threads", "ms"), stepOf(8), kMargin, unit("ms"),
        about("10 ms, of which 2 ms cannot be shared, with eight threads"));
}

TEST_CASE("colours") {
  GRADE(predicted("colours_on_ground", "colours"), static_cast<Real>(colorsOnGround()), kMargin,
        unit("colours"), about("twelve balls on the ground"));
  GRADE(predicted("colours_on_plate", "colours"), static_cast<Real>(colorsOnPlate()), kMargin,
        unit("colours"), about("twelve balls on a plate that lies on the ground"));
}

PROBES() {
  PROBE(predicted("lines_of_whole_bodies", "lines"));
  PROBE(predicted("lines_side_by_side", "lines"));
  PROBE(predicted("step_two_threads", "ms"));
  PROBE(predicted("step_eight_threads", "ms"));
  PROBE(predicted("colours_on_ground", "colours"));
  PROBE(predicted("colours_on_plate", "colours"));
}

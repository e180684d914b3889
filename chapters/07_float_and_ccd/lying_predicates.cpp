// Which side of the line is it, does the formula say?
//
// The line goes through (12, 12) and (24, 24), that is x = y. The point goes through a square grid
// of neighbouring doubles, or floats, that begins at (0.5, 0.5). The plain formula's answer is
// compared with the exact one, which here anybody can see: y > x is to the left.

#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/precision/in_circle.hpp"
#include "carom/precision/orient2d.hpp"
#include "carom/precision/orient2d_filtered.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector2;

const int kGrid = 48;

template <class Number>
int sign(Number value) {
  return (value > 0) - (value < 0);
}

//! [plain]
// What the plain formula says of the point (i, j) of the grid.
template <class Number>
int plainSide(int i, int j, Number step) {
  using Point = Eigen::Matrix<Number, 2, 1>;
  const Point p(Number(0.5) + Number(i) * step, Number(0.5) + Number(j) * step);
  return sign(carom::orient2d<Number>(Point(12, 12), Point(24, 24), p));
}
//! [plain]

template <class Number>
void count(const std::string& type, Number step, carom::io::Table& table) {
  int right = 0, onTheLine = 0, otherSide = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const int exact = sign(j - i), plain = plainSide(i, j, step);
      ++(plain == exact ? right : plain == 0 ? onTheLine : otherSide);
    }
  }
  table.row({type, right, onTheLine, otherSide});
}

// The answers of a filtered predicate on the grid.
void countFiltered(carom::io::Table& table) {
  int right = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const Vector2 p(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
      right += carom::orient2dFiltered({12, 12}, {24, 24}, p).sign == sign(j - i);
    }
  }
  table.row({"double, filtered", right, 0, kGrid * kGrid - right});
}

// How often exact numbers are needed, in a million questions about random points.
void countExact() {
  carom::Random random(70);
  const auto point = [&random] {
    const Real x = random.between(-1, 1);
    return Vector2(x, random.between(-1, 1));
  };
  int sides = 0, circles = 0;
  for (int n = 0; n < 1000000; ++n) {
    const Vector2 a = point(), b = point(), c = point(), d = point();
    sides += !carom::orient2dFiltered(a, b, c).filtered;
    circles += !carom::inCircle(a, b, c, d).filtered;
  }
  std::cout << "Of a million random questions, exact numbers were needed for\n"
            << sides << " about a line and " << circles << " about a circle.\n";
}

int main(int argc, char** argv) {
  carom::io::Table table;
  table.column("2304 points").column("right").column("\"on the line\"").column("other side");
  count<float>("float, plain", 0x1p-24f, table);
  count<double>("double, plain", 0x1p-53, table);
  countFiltered(table);
  std::cout << table << '\n';
  countExact();

  carom::io::Plot plot("What the plain formula says, point by point");
  plot.xAxis("steps of x from 0.5").yAxis("steps of y from 0.5").equalAspect();
  plot.xRange(-1, kGrid).yRange(-1, kGrid);
  plot.describe(
      "A square of dots in three colours, left, right and on the line. Along the "
      "diagonal, where the line is, they form blocks and stripes that cross it.");
  std::array<std::vector<Real>, 3> x, y;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const auto side = static_cast<std::size_t>(plainSide(i, j, 0x1p-53) + 1);
      x[side].push_back(i);
      y[side].push_back(j);
    }
  }
  plot.points("to the right", x[0], y[0])
      .points("on the line", x[1], y[1])
      .points("to the left", x[2], y[2]);
  plot.curve("the line", {-1, kGrid}, {-1, kGrid}, {.width = 1});
  plot.writeSvg(std::filesystem::path(argc > 1 ? argv[1] : ".") / "lying_predicates.svg");
}

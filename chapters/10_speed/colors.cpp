// What may be solved side by side, and what comes of it if one does not care?
//
// The contacts of a pyramid of boxes get colours. Then they are solved: one by one, four at once
// colour by colour, and four at once in the order in which they were found.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "box_pyramid.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "lanes_solver.hpp"
#include "sweeps_by_order.hpp"

using carom::BoxPyramid;
using carom::boxPyramid;
using carom::PlainRow;
using carom::Real;
using carom::RowBlock;

// The rows by colour, and their places; a colour begins a new block.
std::vector<int> orderOf(const std::vector<std::int32_t>& colors) {
  std::vector<int> order;
  for (std::int32_t color = 0; order.size() < colors.size(); ++color) {
    for (int r = 0; r < static_cast<int>(colors.size()); ++r) {
      if (colors[static_cast<std::size_t>(r)] == color) order.push_back(r);
    }
  }
  return order;
}

std::vector<RowBlock> blocksOf(const BoxPyramid& p, const std::vector<std::int32_t>& colors) {
  std::vector<RowBlock> blocks;
  std::size_t lane = carom::kBlockLanes;
  std::int32_t color = -1;
  for (const int r : orderOf(colors)) {
    const PlainRow& row = p.rows[static_cast<std::size_t>(r)];
    if (lane == carom::kBlockLanes || colors[static_cast<std::size_t>(r)] != color) {
      blocks.emplace_back();
      lane = 0;
      color = colors[static_cast<std::size_t>(r)];
    }
    RowBlock& block = blocks.back();
    block.bodyA[lane] = row.bodyA;
    block.bodyB[lane] = row.bodyB;
    for (std::size_t i = 0; i < 6; ++i) {
      block.alongA[i].x[lane] = row.alongA[i], block.alongB[i].x[lane] = row.alongB[i];
      block.changeA[i].x[lane] = row.changeA[i], block.changeB[i].x[lane] = row.changeB[i];
    }
    block.mass.x[lane++] = row.mass;
  }
  return blocks;
}

std::vector<carom::BodySpeeds> falling(const BoxPyramid& p) {
  return std::vector<carom::BodySpeeds>(p.centres.size(), {{0, 0, -1, 0, 0, 0}});
}

// The sum of the speeds downwards that is left, over what there was: each box has 1 kg.
Real left(const std::vector<carom::BodySpeeds>& speeds) {
  Real sum = 0;
  for (const carom::BodySpeeds& body : speeds) sum -= body.x[2];
  return sum / static_cast<Real>(speeds.size());
}

void draw(const BoxPyramid& p, const std::vector<std::int32_t>& colors, carom::io::Plot& plot) {
  for (const carom::Vector2& c : p.centres) {
    constexpr Real h = 0.46;
    plot.polygon("",
                 {{c.x() - h, c.y() - h},
                  {c.x() + h, c.y() - h},
                  {c.x() + h, c.y() + h},
                  {c.x() - h, c.y() + h}},
                 {.opacity = 0.1, .color = carom::io::Color{90, 90, 90}});
  }
  const std::int32_t most = *std::max_element(colors.begin(), colors.end());
  for (std::int32_t color = 0; color <= most; ++color) {
    std::vector<Real> x, y;
    for (std::size_t e = 0; e < colors.size(); ++e) {
      if (colors[e] != color) continue;
      x.push_back(p.points[e].x());
      y.push_back(p.points[e].y());
    }
    plot.points("colour " + std::to_string(color), x, y);
  }
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("height")
      .column("boxes")
      .column("contacts")
      .column("colours")
      .column("most promised");
  table.column("blocks").column("empty lanes");
  for (const int height : {2, 5, 10, 20, 40}) {
    const BoxPyramid p = boxPyramid(height);
    const int boxes = static_cast<int>(p.centres.size());
    const auto colors = carom::colorGraph(p.contacts, boxes);
    const std::size_t blocks = blocksOf(p, colors).size();
    const int most = *std::max_element(colors.begin(), colors.end()) + 1;
    // A box in the middle has two contacts below and two above.
    table.row({height, boxes, p.contacts.size(), most, 2 * (height > 2 ? 4 : 3) - 1, blocks,
               carom::kBlockLanes * blocks - colors.size()});
  }
  std::cout << "A pyramid\n\n" << table;

  const BoxPyramid p = boxPyramid(10);
  const auto colors = carom::colorGraph(p.contacts, static_cast<std::int32_t>(p.centres.size()));
  std::vector<PlainRow> rows = p.rows;
  std::vector<RowBlock> colored = blocksOf(p, colors);
  std::vector<RowBlock> careless = blocksOf(p, std::vector<std::int32_t>(colors.size(), 0));
  auto one = falling(p), four = one, lost = one;
  for (int sweep = 0; sweep < 400; ++sweep) {
    for (const int r : orderOf(colors)) carom::solveRow(rows[static_cast<std::size_t>(r)], one);
    carom::lanesSolver(colored, four);
    carom::lanesSolver(careless, lost);
  }
  const auto differing = [&](const std::vector<carom::BodySpeeds>& speeds) {
    int count = 0;
    for (std::size_t i = 0; i < one.size(); ++i) count += speeds[i].x != one[i].x ? 1 : 0;
    return count;
  };
  carom::io::Table outcome;
  outcome.column("ten layers fall at 1 m/s").column("left [m/s]", carom::io::scientific(1));
  outcome.column("boxes with other bits");
  outcome.row({"one by one, by colour", left(one), differing(one)});
  outcome.row({"four at once, by colour", left(four), differing(four)});
  outcome.row({"four at once, as they come", left(lost), differing(lost)});
  std::cout << "\nAfter 400 sweeps\n\n" << outcome;

  constexpr int kHeights[] = {2, 5, 10, 20};
  carom::io::Table orders;
  orders.column("height").column("sweeps upwards").column("sweeps by colour");
  for (const auto& counted : carom::sweepsByOrder(kHeights)) {
    orders.row({counted.height, counted.upwards, counted.byColor});
  }
  std::cout << "\nUntil no box is faster than 1 mm/s\n\n" << orders;

  const BoxPyramid small = boxPyramid(5);
  carom::io::Plot plot("The contacts of a pyramid, by colour");
  plot.describe(
      "Fifteen boxes in five rows. Each contact between two boxes is a mark of one of a "
      "few colours; no box has two marks of one colour.");
  plot.equalAspect().size(640, 520).xAxis("[m]").yAxis("[m]");
  draw(small, carom::colorGraph(small.contacts, static_cast<std::int32_t>(small.centres.size())),
       plot);
  plot.writeSvg(folder / "colors.svg");
}

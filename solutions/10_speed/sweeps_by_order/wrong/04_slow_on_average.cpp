#include "sweeps_by_order.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "box_pyramid.hpp"
#include "carom/core/checks.hpp"

namespace carom {

std::vector<SweepsByOrder> sweepsByOrder(std::span<const int> heights) {
  for (const int height : heights) {
    if (height < 1 || height > 30) {
      reject("height", std::to_string(height), "must be from 1 to 30");
    }
  }
  std::vector<SweepsByOrder> table;
  const auto sweepsIn = [](const BoxPyramid& pyramid, const std::vector<std::size_t>& order) {
    std::vector<PlainRow> rows = pyramid.rows;
    std::vector<BodySpeeds> speeds(pyramid.centres.size(), {{0, 0, -1, 0, 0, 0}});
    for (int sweeps = 1;; ++sweeps) {
      for (const std::size_t r : order) solveRow(rows[r], speeds);
      Real fastest = 0;
      for (const BodySpeeds& body : speeds) fastest += std::abs(body.x[2]);
      if (!(fastest / static_cast<Real>(speeds.size()) > 1e-3)) return sweeps;
    }
  };
  for (const int height : heights) {
    const BoxPyramid pyramid = boxPyramid(height);
    const int boxes = static_cast<int>(pyramid.centres.size());
    const std::vector<std::int32_t> colors = colorGraph(pyramid.contacts, boxes);
    std::vector<std::size_t> order;
    for (std::size_t r = 0; r < colors.size(); ++r) order.push_back(r);
    const int upwards = sweepsIn(pyramid, order);
    const auto earlier = [&](std::size_t i, std::size_t j) { return colors[i] < colors[j]; };
    std::stable_sort(order.begin(), order.end(), earlier);
    table.push_back({height, upwards, sweepsIn(pyramid, order)});
  }
  return table;
}

}  // namespace carom

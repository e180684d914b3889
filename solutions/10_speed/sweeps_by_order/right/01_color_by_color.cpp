#include "sweeps_by_order.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "box_pyramid.hpp"
#include "carom/core/checks.hpp"

namespace carom {

namespace {

bool allSlow(const std::vector<BodySpeeds>& speeds) {
  for (const BodySpeeds& body : speeds) {
    if (body.x[2] > 1e-3 || body.x[2] < -1e-3) return false;
  }
  return true;
}

}  // namespace

std::vector<SweepsByOrder> sweepsByOrder(std::span<const int> heights) {
  for (const int height : heights) {
    if (height < 1 || height > 30) {
      reject("height", std::to_string(height), "must be from 1 to 30");
    }
  }
  std::vector<SweepsByOrder> table;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    table.push_back({heights[k], 0, 0});
    const BoxPyramid made = boxPyramid(heights[k]);
    const auto colors = colorGraph(made.contacts, static_cast<std::int32_t>(made.centres.size()));
    const std::int32_t last = *std::max_element(colors.begin(), colors.end());
    for (const bool sorted : {false, true}) {
      BoxPyramid p = made;
      std::vector<BodySpeeds> speeds(p.centres.size());
      for (BodySpeeds& body : speeds) body.x[2] = -1;
      int& count = sorted ? table[k].byColor : table[k].upwards;
      while (!allSlow(speeds)) {
        for (std::int32_t color = 0; color <= (sorted ? last : 0); ++color) {
          for (std::size_t r = 0; r < p.rows.size(); ++r) {
            if (!sorted || colors[r] == color) solveRow(p.rows[r], speeds);
          }
        }
        ++count;
      }
    }
  }
  return table;
}

}  // namespace carom

// Exercise 10.sweeps_by_order: measure what the order of colours costs
// Check it with: ./course check 10.sweeps_by_order

#include "sweeps_by_order.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "box_pyramid.hpp"
#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

std::vector<SweepsByOrder> sweepsByOrder(std::span<const int> heights) {
  for (const int height : heights) {
    if (height < 1 || height > 30) {
      reject("height", std::to_string(height), "must be from 1 to 30");
    }
  }
  std::vector<SweepsByOrder> table;
  // boxPyramid(height) has .rows, .contacts and .centres; boxes have the numbers of their centres.
  // Row r belongs to contact r. All speeds of box i are speeds[i].x; x[2] is the one upwards.
  return todo<std::vector<SweepsByOrder>>("sweepsByOrder");
}

}  // namespace carom

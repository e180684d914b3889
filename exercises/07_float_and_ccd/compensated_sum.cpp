// Exercise 07.compensated_sum: what is the sum of many numbers, to the last digit?
// Check it with: ./course check 07.compensated_sum

#include "carom/precision/compensated_sum.hpp"

#include <cmath>

#include "carom/core/todo.hpp"

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  // `for (const Real term : terms)` goes through the terms; std::abs(x) is |x|.
  return todo<Real>("compensatedSum");
}

}  // namespace carom

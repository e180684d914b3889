// Exercise 07.compensated_sum: what is the sum of many numbers, to the last digit?
// Check it with: ./course check 07.compensated_sum

#include "carom/precision/compensated_sum.hpp"

#include <cmath>

#include "carom/core/todo.hpp"

namespace carom {

Real compensatedSum(std::span<const Real> terms) {
  //# solution
  Real sum = 0, lost = 0;
  for (const Real term : terms) {
    const Real next = sum + term;
    if (std::abs(sum) >= std::abs(term)) {
      lost += (sum - next) + term;
    } else {
      lost += (term - next) + sum;
    }
    sum = next;
  }
  return sum + lost;
  //# stub
  // `for (const Real term : terms)` goes through the terms; std::abs(x) is |x|.
  //#| return todo<Real>("compensatedSum");
  //# end
}

}  // namespace carom

// Exercise 07.ulp_distance: how many doubles lie between two doubles?
// Check it with: ./course check 07.ulp_distance

#include "carom/precision/ulp_distance.hpp"

#include <bit>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

std::uint64_t ulpDistance(Real a, Real b) {
  // Given: what is not a number has no place in the row.
  if (std::isnan(a)) reject("a", toText(a), "must be a number");
  if (std::isnan(b)) reject("b", toText(b), "must be a number");
  //# solution
  const auto place = [](Real x) {
    const auto size = std::bit_cast<std::int64_t>(std::abs(x));
    return std::signbit(x) ? -size : size;
  };
  const std::int64_t from = place(a), to = place(b);
  return from < to ? static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from)
                   : static_cast<std::uint64_t>(from) - static_cast<std::uint64_t>(to);
  //# stub
  // std::bit_cast<std::int64_t>(x) reads the bits of x as a whole number, std::abs(x) is |x|,
  // and std::signbit(x) says whether x has a minus.
  //#| return todo<std::uint64_t>("ulpDistance");
  //# end
}

}  // namespace carom

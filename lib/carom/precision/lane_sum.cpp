#include "carom/precision/lane_sum.hpp"

#include "carom/core/variant.hpp"
#include "carom/precision/compensated_sum.hpp"
#include "carom/precision/neumaier_sum.hpp"

namespace carom {

Real compensatedSumInLanes(std::span<const Real> terms) {
  if (takesPlainPath()) return compensatedSum(terms);
  constexpr std::size_t kLanes = 8;
  NeumaierSum lanes[kLanes];
  const std::size_t whole = terms.size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane].add(terms[i + lane]);
  }
  for (std::size_t i = whole; i < terms.size(); ++i) lanes[i - whole].add(terms[i]);
  for (std::size_t lane = 1; lane < kLanes; ++lane) lanes[0].add(lanes[lane]);
  return lanes[0].value();
}

}  // namespace carom

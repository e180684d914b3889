#include "carom/precision/lane_sum.hpp"

#include "carom/core/variant.hpp"
#include "carom/precision/compensated_sum.hpp"
#include "carom/precision/neumaier_sum.hpp"

namespace carom {

Real compensatedSumInLanes(std::span<const Real> terms) {
  if (takesPlainPath()) return compensatedSum(terms);
  constexpr std::size_t kLanes = 8;
  Real sums[kLanes] = {}, lost[kLanes] = {};
  const std::size_t whole = terms.size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const TwoSum next = twoSum(sums[lane], terms[i + lane]);
      sums[lane] = next.sum;
      lost[lane] += next.error;
    }
  }
  NeumaierSum sum;
  for (const Real part : sums) sum.add(part);
  for (const Real part : lost) sum.add(part);
  for (const Real term : terms.subspan(whole)) sum.add(term);
  return sum.value();
}

}  // namespace carom

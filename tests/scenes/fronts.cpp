#include "scenes/fronts.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scenes {

Front frontOf(std::vector<CostAndError> runs, Real rounding) {
  for (CostAndError& run : runs) run.error = std::max(run.error, rounding);
  std::sort(runs.begin(), runs.end(), [](const CostAndError& a, const CostAndError& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
  });
  Front front;
  for (const CostAndError& run : runs) {
    if (front.empty() || run.error < front.back().error) front.push_back(run);
  }
  return front;
}

std::optional<Real> costAt(const Front& front, Real error) {
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (front[i].error > error) continue;
    if (i == 0 || front[i].error == error) return front[i].cost;
    const CostAndError &a = front[i - 1], &b = front[i];
    const Real part = std::log(a.error / error) / std::log(a.error / b.error);
    return a.cost * std::pow(b.cost / a.cost, part);
  }
  return std::nullopt;
}

std::optional<Cheapest> cheapestAt(std::span<const NamedFront> fronts, Real error) {
  std::optional<Cheapest> best;
  for (const NamedFront& one : fronts) {
    const std::optional<Real> cost = costAt(one.front, error);
    if (cost && (!best || *cost < best->cost)) best = Cheapest{one.name, *cost};
  }
  return best;
}

std::vector<Comparison> compareFronts(std::span<const NamedFront> ours,
                                      std::span<const NamedFront> theirs) {
  std::vector<Real> errors;
  for (const NamedFront& one : theirs) {
    for (const CostAndError& point : one.front) errors.push_back(point.error);
  }
  std::sort(errors.begin(), errors.end(), [](Real a, Real b) { return a > b; });
  errors.erase(std::unique(errors.begin(), errors.end()), errors.end());
  std::vector<Comparison> all;
  for (const Real error : errors) {
    all.push_back({error, *cheapestAt(theirs, error), cheapestAt(ours, error)});
  }
  return all;
}

}  // namespace carom::scenes

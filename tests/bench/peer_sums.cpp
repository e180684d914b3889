#include <numeric>

#include "bench/precision_peers.hpp"

namespace carom::bench {
namespace {

template <class Number>
Number eigen(std::span<const Number> terms) {
  using Column = Eigen::Array<Number, Eigen::Dynamic, 1>;
  return Eigen::Map<const Column>(terms.data(), static_cast<Eigen::Index>(terms.size())).sum();
}

}  // namespace

Real reduceSum(std::span<const Real> terms) {
  return std::reduce(terms.begin(), terms.end());
}

float reduceSum(std::span<const float> terms) {
  return std::reduce(terms.begin(), terms.end());
}

Real eigenSum(std::span<const Real> terms) {
  return eigen(terms);
}

float eigenSum(std::span<const float> terms) {
  return eigen(terms);
}

}  // namespace carom::bench

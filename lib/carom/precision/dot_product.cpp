#include "carom/precision/dot_product.hpp"

#include <string>

#include "carom/core/checks.hpp"
#include "carom/precision/neumaier_sum.hpp"

namespace carom {

Real compensatedDot(std::span<const Real> a, std::span<const Real> b) {
  if (a.size() != b.size()) {
    reject("length of b", std::to_string(b.size()),
           "must be the length of a, " + std::to_string(a.size()));
  }
  NeumaierSum sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.addProduct(a[i], b[i]);
  return sum.value();
}

Real compensatedDot(const Vector3& a, const Vector3& b) {
  return compensatedDot(std::span<const Real>(a.data(), 3), std::span<const Real>(b.data(), 3));
}

}  // namespace carom

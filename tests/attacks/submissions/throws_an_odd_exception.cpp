// Throws an exception whose text is nowhere.
#include "carom/rotation/hamilton_product.hpp"

#include <exception>

struct Odd : std::exception {
  const char* what() const noexcept override {
    return nullptr;
  }
};

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  throw Odd();
}

}  // namespace carom

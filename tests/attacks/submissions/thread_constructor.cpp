// Ends the program in the constructor of a thread's own object.
#include "carom/rotation/hamilton_product.hpp"

#include <cstdlib>
struct Ender {
  Ender() {
    std::abort();
  }
  double one = 1;
};
static thread_local Ender ender;

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {ender.one, 0, 0, 0};
}

}  // namespace carom

#include "carom/core/variant.hpp"

namespace carom {
bool takesPlainPath() {
  return false;
}
}  // namespace carom

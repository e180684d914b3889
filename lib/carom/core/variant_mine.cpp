#include "carom/core/variant.hpp"

namespace carom {
bool takesPlainPath() {
  return true;
}
}  // namespace carom

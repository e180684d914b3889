#include "carom/core/expect.hpp"

#include <cstdio>
#include <cstdlib>

namespace carom::detail {

void expectationFailed(const char* condition, const char* rule, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: %s (%s is false)\n", file, line, rule, condition);
  std::abort();
}

}  // namespace carom::detail

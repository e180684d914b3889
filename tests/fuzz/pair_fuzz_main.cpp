// For libFuzzer: cmake --preset fuzz && cmake --build build/fuzz --target fuzz_pairs && build/fuzz/tests/fuzz/fuzz_pairs

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "fuzz/pair_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    carom_test::tryPair({data, size});
  } catch (const std::logic_error& broken) {
    std::fprintf(stderr, "broken promise: %s\n", broken.what());
    std::abort();
  }
  return 0;
}

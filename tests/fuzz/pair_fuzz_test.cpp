// Pairs from random bytes. CAROM_FUZZ_PAIRS sets how many; a million take a few minutes. libFuzzer, which looks for
// new paths through the code, drives the same function (pair_fuzz_main.cpp).

#include "fuzz/pair_fuzz.hpp"

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "carom/core/random.hpp"
#include "support/catch.hpp"

TEST_CASE("whatever the numbers, every pair of bodies gets a sound answer") {
  const char* text = std::getenv("CAROM_FUZZ_PAIRS");
  const int pairs = text ? std::atoi(text) : 20000;
  int refused = 0;
  int apart = 0;
  int overlapping = 0;
  for (int i = 0; i < pairs; ++i) {
    // A stream of its own for each pair, so that a failure can be run again alone.
    carom::Random random(static_cast<std::uint64_t>(i) + 1);
    std::vector<std::uint8_t> bytes(32 + random.bits() % 256);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    try {
      switch (carom_test::tryPair(bytes)) {
        case carom_test::Tried::refused:
          ++refused;
          break;
        case carom_test::Tried::apart:
          ++apart;
          break;
        case carom_test::Tried::overlapping:
          ++overlapping;
          break;
      }
    } catch (const std::logic_error& broken) {
      FAIL_CHECK("pair " << i << ": " << broken.what());
    }
  }
  CHECK(refused > pairs / 20);
  CHECK(apart > pairs / 100);
  CHECK(overlapping > pairs / 100);
}

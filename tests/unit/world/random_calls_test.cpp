// Any calls in any order (support/random_player.hpp). CAROM_RANDOM_CALLS says how many calls; a few
// thousand if it is not set.

#include <algorithm>
#include <cstdlib>

#include "support/catch.hpp"
#include "support/random_player.hpp"

namespace {

int wantedCalls() {
  constexpr int kFew = 4000;
  const char* text = std::getenv("CAROM_RANDOM_CALLS");
  const int calls = text != nullptr ? std::atoi(text) : 0;
  return calls > 0 ? calls : kFew;
}

}  // namespace

TEST_CASE("any calls in any order, bad ones among them, never break a world") {
  // Worlds of some hundred calls each, so that none fills up for good.
  constexpr int kEach = 500;
  const int calls = wantedCalls();
  for (int done = 0, seed = 1; done < calls; done += kEach, ++seed) {
    INFO("seed " << seed);
    carom_test::Player player(static_cast<std::uint64_t>(seed));
    const auto play = [&] {
      for (int i = 0; i < std::min(kEach, calls - done); ++i) player.call();
      player.sane();
    };
    REQUIRE_NOTHROW(play());
  }
}

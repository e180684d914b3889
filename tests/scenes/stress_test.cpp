// The benchmark `stress` in short: is the world sound in scenes that are hard on it?

#include "scenes/stress.hpp"

#include <string>

#include "support/catch.hpp"

namespace stress = carom::stress;

TEST_CASE("random scenes keep their numbers, their walls and their energy") {
  constexpr std::uint64_t kScenes = 600;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    INFO("seed " << seed);
    CHECK(stress::runRandomScene(seed).failure == "");
  }
}

TEST_CASE("random scenes that once gained energy or lost a body do so no more") {
  for (const std::uint64_t seed : {18353, 38226, 40510, 62208, 67634, 67653, 67779, 86432, 87393,
                                   88370, 88418, 89313, 98297, 98641}) {
    INFO("seed " << seed);
    CHECK(stress::runRandomScene(seed).failure == "");
  }
}

TEST_CASE(
    "what rattles ends its step, and a touch that nothing acts on is not found again and again") {
  CHECK(stress::runRandomScene(1727).tally.impacts < 5'000);
  CHECK(stress::runRandomScene(51695).tally.searches < 200'000);
}

TEST_CASE("hours, ratios, slivers, sizes, distance and overlap, each in short") {
  constexpr double kShare = 0.01;
  for (const stress::Trial& trial : stress::trials()) {
    INFO(trial.name << ": " << trial.asks);
    CHECK(trial.run(kShare).failure == "");
  }
}

TEST_CASE("what must be refused is refused by name, and the world goes on as if nothing had been") {
  const stress::Outcome outcome = stress::refuseAll();
  CHECK(outcome.failure == "");
  CHECK(outcome.tally.refused > 200);
}

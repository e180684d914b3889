#include "carom/world/crowd.hpp"

#include <algorithm>

#include "carom/world/move_body.hpp"

namespace carom::world {

namespace {

constexpr int kMostParts = 64;
constexpr std::size_t kFew = 32;  // bodies: make too few pairs to ask
// What a body, and one of a pile, takes in a part of a step, in expected pairs. A crowd that is not
// spread evenly makes several times as many; what a few pairs more or less cost is not worth a part.
constexpr Real kBody = 0.03, kPileBody = 1, kAny = 8;

// Bodies that move: how many, how wide they and their ways are in the mean, and the box of them all.
struct Crowd {
  Real flying = 0, inPiles = 0;
  Real reach = 0;                                         // [m]
  Real speed = 0;                                         // [m/s]
  Vector3 low = Vector3::Zero(), high = Vector3::Zero();  // [m, world]
};

Crowd crowdOf(const WorldState& state) {
  Crowd crowd;
  for (const Index index : state.awakeBodies) {
    const BodySlot& body = state.bodies[at(index)];
    if (!isDynamic(body)) continue;
    if (isOfPile(state, body)) {
      crowd.inPiles += 1;
      continue;
    }
    if (crowd.flying == 0) crowd.low = crowd.high = body.position;
    crowd.flying += 1;
    crowd.reach += body.reach;
    crowd.speed += body.velocity.linear.norm();
    crowd.low = crowd.low.cwiseMin(body.position);
    crowd.high = crowd.high.cwiseMax(body.position);
  }
  crowd.reach /= std::max(crowd.flying, Real(1));
  crowd.speed /= std::max(crowd.flying, Real(1));
  return crowd;
}

// How many pairs of boxes meet: two do if they are near each other along all three axes.
Real expectedPairs(const Crowd& crowd, Real gravity, Real time) {
  const Real near = 4 * (crowd.reach + crowd.speed * time + gravity * time * time / 2);
  Real pairs = crowd.flying * crowd.flying / 2;
  for (int k = 0; k < 3; ++k) pairs *= near / (crowd.high(k) - crowd.low(k) + near);
  return pairs;
}

}  // namespace

int partsForCrowd(const WorldState& state, Real time) {
  const WorldSettings& settings = state.settings;
  if (!settings.divideCrowds || !settings.locateEvents) return 1;
  if (state.awakeBodies.size() < kFew || settings.pairFinding == PairFinding::allPairs) return 1;
  const Crowd crowd = crowdOf(state);
  const Real gravity = settings.gravity.norm();
  const Real fixed = kBody * crowd.flying + kPileBody * crowd.inPiles + kAny;
  const auto cost = [&](int parts) {
    return parts * (fixed + expectedPairs(crowd, gravity, time / parts));
  };
  int best = 1;
  Real least = cost(1);
  for (int parts = 2; parts <= kMostParts; parts *= 2) {
    const Real now = cost(parts);
    if (now < least) {
      least = now;
      best = parts;
    }
  }
  return best;
}

}  // namespace carom::world

// Grader of 05.geared_inertia: trains that can be worked out by hand, and any trains, by the forces
// at their teeth.

#include "geared_inertia.hpp"

#include <cmath>
#include <vector>

#include "geared_inertia_fields.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

using Train = std::vector<GearWheel>;

void ask(const Train& train, Real expected, const char* what) {
  GRADE(gearedInertia(train), expected, withinRelative(1e-14, kRounding), given("train", train),
        unit("kg m^2"), about(what));
}

// Discs of 2 kg, a tenth of a metre of radius for each tooth, side by side.
Train discs(const std::vector<int>& teeth) {
  Train train;
  Real x = 0, before = 0;
  for (const int n : teeth) {
    const Real radius = n / 10.0;
    if (!train.empty()) x += before + radius;
    train.push_back({n, radius * radius, 2, {x, 0}});
    before = radius;
  }
  return train;
}

Train anyTrain(Random& random) {
  Train train;
  const int count = random.integer(3, 5);
  for (int k = 0; k < count; ++k) {
    GearWheel gear;
    gear.teeth = random.integer(8, 60) + k;
    gear.inertia = random.between(0.1, 3);
    gear.mass = random.between(0.5, 4);
    const Vector3 place = random.vector(2);
    gear.axle = {place.x(), place.y()};
    train.push_back(gear);
  }
  return train;
}

// The first gear speeds up by 1 rad/s^2. From the last gear on: each tooth has to carry what its
// own gear takes and what the next tooth asks for. The torque at the first axle is the answer.
Real torqueForUnitAcceleration(const Train& train) {
  const auto radius = [](const GearWheel& gear) { return gear.teeth / 10.0; };
  Real force = 0;  // at the tooth towards the next gear
  for (std::size_t k = train.size() - 1; k > 0; --k) {
    const Real acceleration = radius(train.front()) / radius(train[k]);
    force += train[k].inertia * acceleration / radius(train[k]);
  }
  return train.front().inertia + force * radius(train.front());
}

}  // namespace

TEST_CASE("pair") {
  ask(discs({10, 40}), 2, "10 teeth with 1 kg m^2 drive 40 teeth with 16 kg m^2");
  ask({{20, 1.5, 3, {0, 0}}, {10, 0.25, 1, {0.3, 0}}}, 2.5, "a gear drives one of half its size");
}

TEST_CASE("turned") {
  ask(discs({40, 10}), 32, "40 teeth with 16 kg m^2 drive 10 teeth with 1 kg m^2");
}

TEST_CASE("three") {
  ask(discs({10, 20, 40}), 3, "a wheel of 20 teeth in between");
  ask(discs({10, 40, 10}), 3, "the last wheel turns as fast as the first");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Train train = anyTrain(random);
    ask(train, torqueForUnitAcceleration(train),
        "the torque at the first axle for 1 rad/s^2, from the forces at all teeth");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(gearedInertia(Train{}), about("no gear at all"));
  GRADE_REFUSES(gearedInertia(Train{{0, 1, 1, {0, 0}}}), about("a gear without teeth"));
}

PROBES() {
  Random random(513);
  for (int n = 0; n < 16; ++n) PROBE(gearedInertia(anyTrain(random)));
}

// Solids that turn while they move: never late, never missed, and hardly early.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/sub_steps.hpp"
#include "carom/toi/toi_rotating.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

struct Scene {
  std::vector<Vector3> cornersA, cornersB;
  Shape a, b;
  Sweep A, B;
};

int pairsOfEachFamily() {
  const char* text = std::getenv("CAROM_TOI_PAIRS");
  return text ? std::atoi(text) : 50;
}

// Corners on an ellipsoid with these half axes: a hull keeps them all, or nearly.
std::vector<Vector3> anyCorners(Random& random, int count, const Vector3& halfAxes) {
  std::vector<Vector3> corners;
  for (int i = 0; i < count; ++i) corners.push_back(halfAxes.cwiseProduct(random.direction()));
  return corners;
}

Sweep anySweep(Random& random, const Vector3& from, Real speed, Real turn) {
  Sweep s;
  const Vector3 axis = random.direction();
  const Quaternion q = integrateOrientation({1, 0, 0, 0}, axis, random.between(-3, 3));
  s.start = poseOf(q, from);
  s.velocity = speed * random.direction();
  s.angularVelocity = turn * random.direction();
  s.acceleration = random.vector(3);
  return s;
}

struct Family {
  const char* name;
  Vector3 halfAxes;  // of A
  Real distance;     // of the centres at the start
  Real speed, turn;  // per step
  Real aim;          // how far off the middle B is thrown
};

const std::array<Family, 5> kFamilies = {{
    {"stones", {1, 0.8, 0.6}, 4, 4, 3, 0.4},
    {"plates and needles", {1, 1, 0.001}, 3, 3, 3, 0.4},
    {"fast", {1, 0.8, 0.6}, 40, 60, 3.1, 0.05},
    {"turning in place", {1, 0.1, 0.1}, 1.2, 0.01, 3.1, 0.4},
    {"small against large", {0.01, 0.01, 0.01}, 1.5, 2, 3, 0.4},
}};

Scene anyScene(Random& random, const Family& family) {
  Scene s;
  s.cornersA = anyCorners(random, static_cast<int>(random.between(6, 64)), family.halfAxes);
  s.cornersB = anyCorners(random, static_cast<int>(random.between(6, 64)), {1, 0.9, 0.5});
  s.a = hullOfPoints(s.cornersA);
  s.b = hullOfPoints(s.cornersB);
  const Vector3 to = family.distance * random.direction();
  s.A = anySweep(random, Vector3::Zero(), 0, family.turn * random.between(0, 1));
  s.B = anySweep(random, to, 0, family.turn * random.between(0, 1));
  s.B.velocity = family.speed * (family.aim * random.direction() - to.normalized());
  return s;
}

// How fast any corner can come nearer: |v| + |a| t + |w| r, for both.
Real fastest(const Scene& s) {
  const auto turning = [](const std::vector<Vector3>& corners, const Sweep& sweep) {
    Real reach = 0;
    for (const Vector3& c : corners) reach = std::max(reach, (c - sweep.centre).norm());
    return sweep.angularVelocity.norm() * reach;
  };
  return (s.B.velocity - s.A.velocity).norm() + (s.B.acceleration - s.A.acceleration).norm() +
         turning(s.cornersA, s.A) + turning(s.cornersB, s.B);
}

// Proves that nothing touches from `from` to `to`, or finds nothing to prove it by: at a time in
// the middle the gap is more than what can close in half the interval, or both halves are looked
// at. It knows nothing of normals, supports or parabolas.
bool certainlyApart(const Scene& s, Real speed, Real from, Real to, int depth = 0) {
  const Real middle = from + (to - from) / 2;
  const Real gap = signedDistance(s.a, poseAt(s.A, middle), s.b, poseAt(s.B, middle)).separation;
  if (gap - 1e-12 > speed * (to - from) / 2) return true;
  if (gap <= 0 || depth == 60) return false;
  return certainlyApart(s, speed, from, middle, depth + 1) &&
         certainlyApart(s, speed, middle, to, depth + 1);
}

}  // namespace

TEST_CASE("turning solids: nothing touches before the time of a hit, nor where there is none") {
  for (const Family& family : kFamilies) {
    DYNAMIC_SECTION(family.name) {
      Random random(7);
      int hits = 0, misses = 0, mostSteps = 0;
      for (int i = 0; i < pairsOfEachFamily(); ++i) {
        const Scene s = anyScene(random, family);
        const TimeOfImpact found = firstContact(s.a, s.A, s.b, s.B, 1);
        if (found.status == ImpactStatus::kOverlapping) continue;
        const Real speed = fastest(s);
        mostSteps = std::max(mostSteps, found.steps);
        INFO("pair " << i << ": status " << static_cast<int>(found.status) << " at " << found.time
                     << ", gap " << found.gap << ", " << found.steps << " steps");
        REQUIRE(found.status != ImpactStatus::kLimit);
        if (found.status == ImpactStatus::kNoHit) {
          ++misses;
          CHECK(certainlyApart(s, speed, 0, 1));
          continue;
        }
        ++hits;
        // Apart until the gap is a few micrometres, touching at the time found.
        const Real before = found.time - 1e-5 / speed;
        if (before > 0) CHECK(certainlyApart(s, speed, 0, before));
        const Separation there =
            signedDistance(s.a, poseAt(s.A, found.time), s.b, poseAt(s.B, found.time));
        CHECK(std::abs(there.separation) < 1e-12 * std::max(1.0, family.distance));
        CHECK(there.separation > -1e-13 * std::max(1.0, family.distance));
      }
      INFO(hits << " hits, " << misses << " misses, at most " << mostSteps << " steps");
      CHECK(hits > pairsOfEachFamily() / 10);
      CHECK(misses > pairsOfEachFamily() / 10);
      CHECK(mostSteps < 100);
    }
  }
}

TEST_CASE("the plain search by the fastest corner finds the same, with more steps") {
  for (const Family& family : kFamilies) {
    DYNAMIC_SECTION(family.name) {
      Random random(11);
      int plainSteps = 0, steps = 0;
      for (int i = 0; i < 60; ++i) {
        const Scene s = anyScene(random, family);
        const TimeOfImpact found = firstContact(s.a, s.A, s.b, s.B, 1, {.tolerance = 1e-9});
        if (found.status == ImpactStatus::kOverlapping) continue;
        const TimeOfImpact plain = toiRotating(s.cornersA, s.A, s.cornersB, s.B, 1, 1e-9);
        INFO("pair " << i);
        REQUIRE(found.status == plain.status);
        plainSteps += plain.steps;
        steps += found.steps;
        if (found.status != ImpactStatus::kHit) continue;
        // Both are early by what closes the last nanometre; grazing makes that longer.
        CHECK(std::abs(found.time - plain.time) < 1e-5);
        CHECK(plain.gap <= 1e-9);
      }
      INFO(plainSteps << " steps against " << steps);
      CHECK(plainSteps > (family.speed > 10 ? 0.8 : 2) * steps);  // a fast body hides its turning
    }
  }
}

TEST_CASE("exchanging the bodies, and moving the world along, changes nothing that matters") {
  Random random(13);
  for (int i = 0; i < 40; ++i) {
    const Scene s = anyScene(random, kFamilies[0]);
    const TimeOfImpact one = firstContact(s.a, s.A, s.b, s.B, 1);
    const TimeOfImpact other = firstContact(s.b, s.B, s.a, s.A, 1);
    REQUIRE(one.status == other.status);
    if (one.status != ImpactStatus::kHit) continue;
    CHECK(std::abs(one.time - other.time) < 1e-9);
    CHECK((one.normal + other.normal).norm() < 1e-5);
    Scene far = s;
    const Vector3 there(1e6, -2e6, 5e5), wind(30, 20, -10);
    for (Sweep* sweep : {&far.A, &far.B}) {
      sweep->start.p_WB += there;
      sweep->velocity += wind;
    }
    const TimeOfImpact moved = firstContact(far.a, far.A, far.b, far.B, 1);
    REQUIRE(moved.status == ImpactStatus::kHit);
    CHECK(std::abs(one.time - moved.time) < 1e-6);
    CHECK((moved.point - there - one.time * wind - one.point).norm() < 1e-4);
  }
}

TEST_CASE("compounds touch where their first part does") {
  const Compound hammer = makeCompound(
      {{Capsule{0.05, 0.5}, Pose{}}, {Box{{0.3, 0.1, 0.1}}, {Matrix3::Identity(), {0, 0, 0.5}}}});
  Sweep thrown;
  thrown.start.p_WB = {0, 0, 3};
  thrown.velocity = {1, 0, 0};
  thrown.acceleration = {0, 0, -9.81};
  thrown.angularVelocity = {0, 7, 0};
  const HalfSpace floor;
  const TimeOfImpact whole = firstContact(hammer, thrown, floor, {}, 2);
  REQUIRE(whole.status == ImpactStatus::kHit);
  Real first = 2;
  for (const CompoundPart& part : hammer.parts) {
    Sweep own = thrown;
    own.start = composed(thrown.start, part.pose);
    own.centre = pointToBody(part.pose, Vector3::Zero());
    const Shape shape = std::visit([](const auto& s) { return Shape(s); }, part.shape);
    first = std::min(first, firstContact(shape, own, floor, {}, 2).time);
  }
  CHECK(whole.time == first);
  CHECK(std::abs(signedDistance(hammer, poseAt(thrown, whole.time), floor, {}).separation) < 1e-13);
}

TEST_CASE("looking more often finds the same, unless the overlap is shallow") {
  Random random(17);
  int same = 0, missed = 0;
  for (int i = 0; i < 150; ++i) {
    const Scene s = anyScene(random, kFamilies[0]);
    const TimeOfImpact found = firstContact(s.a, s.A, s.b, s.B, 1);
    if (found.status == ImpactStatus::kOverlapping) continue;
    const TimeOfImpact looked = contactBySubSteps(s.a, s.A, s.b, s.B, 1, 3, 1e-10);
    INFO("pair " << i);
    if (found.status == ImpactStatus::kNoHit) CHECK(looked.status == ImpactStatus::kNoHit);
    if (found.status != ImpactStatus::kHit) continue;
    if (looked.status == ImpactStatus::kHit) {
      ++same;
      CHECK(looked.time > found.time - 1e-9);
    } else {
      ++missed;
    }
  }
  CHECK(same > 10);
  CHECK(missed > 0);
}

// Going from impact to impact: many of them, several at once, and bullets that must not pass.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/core/two_sum.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/sub_steps.hpp"
#include "carom/toi/swept_ball_plane.hpp"
#include "carom/toi/swept_balls.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

struct Bead {
  Real mass;
  MovingBall ball;  // along x
  Real lost = 0;    // what rounding has taken from its velocity
};

// Tens of thousands of impacts round nearly the same sum nearly the same way, so that the errors
// add up; what each rounding takes is added to the next change.
void accelerate(Bead& bead, Real change) {
  Real& v = bead.ball.velocity.x();
  const TwoSum next = twoSum(v, change + bead.lost);
  v = next.sum;
  bead.lost = next.error;
}

// The next impact of neighbours that approach; what touches and parts is done with.
struct Event {
  Real time = std::numeric_limits<Real>::infinity();
  std::size_t left = 0;
};

Event nextOf(const std::vector<Bead>& beads) {
  Event next;
  for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
    const MovingBall &a = beads[i].ball, &b = beads[i + 1].ball;
    if (b.velocity.x() >= a.velocity.x()) continue;
    const TimeOfImpact t = sweptBalls(a, b, 1e9);
    const Real time = t.status == ImpactStatus::kNoHit ? next.time : t.time;
    if (time < next.time) next = {time, i};
  }
  return next;
}

void advance(std::vector<Bead>& beads, Real time) {
  for (Bead& b : beads) b.ball.centre += time * b.ball.velocity;
}

// An elastic impact; a mass of infinity is a wall.
void collide(Bead& a, Bead& b) {
  const Real u = b.ball.velocity.x() - a.ball.velocity.x();
  const Real mobility = 1 / a.mass + 1 / b.mass;
  // The heavier one gets its small share; the lighter one the rest, as a difference, so that an
  // error of the share is one of a small number for both.
  const Real light = a.mass < b.mass ? 1 : -1;
  Bead &heavy = light > 0 ? b : a, &other = light > 0 ? a : b;
  const Real little = 2 * u * (1 / heavy.mass / mobility);
  accelerate(heavy, -light * little);
  accelerate(other, light * 2 * u);
  accelerate(other, -light * little);
}

}  // namespace

TEST_CASE("T13: two blocks and a wall count the digits of pi") {
  const json expected = readCase("toi", "T13");
  for (int n = 0; n <= 4; ++n) {
    const Real big = std::pow(100.0, n);
    const Real infinity = std::numeric_limits<Real>::infinity();
    std::vector<Bead> beads = {{infinity, {.radius = 0.5, .centre = {-0.5, 0, 0}}},
                               {1, {.radius = 0.5, .centre = {1.5, 0, 0}}},
                               {big, {0.5, {4.5, 0, 0}, {-1, 0, 0}}}};
    const Real energy = big / 2;
    int count = 0;
    for (Event e = nextOf(beads); std::isfinite(e.time); e = nextOf(beads)) {
      advance(beads, e.time);
      collide(beads[e.left], beads[e.left + 1]);
      REQUIRE(++count < 40000);
    }
    CHECK(count == number(expected["counts"][static_cast<std::size_t>(n)]));
    const Real small = beads[1].ball.velocity.x(), large = beads[2].ball.velocity.x();
    const Real gained = (small * small + big * large * large) / 2 / energy - 1;
    INFO(count << " impacts, energy off by " << gained << ", of which 1e-12 is allowed");
    CHECK(std::abs(gained) < 1e-12);
    if (n == 2) {
      CHECK(std::abs(small / number(expected["small_velocity"]) - 1) < 1e-11);
      CHECK(std::abs(large / number(expected["big_velocity"]) - 1) < 1e-13);
    }
  }
}

TEST_CASE("T14: impacts at once, and one a moment after the other") {
  const json expected = readCase("toi", "T14");
  for (const Real delta : {0.0, std::ldexp(1.0, -40), -std::ldexp(1.0, -40)}) {
    std::vector<Bead> beads = {{1, {0.5, {0, 0, 0}, {1, 0, 0}}},
                               {1, {.radius = 0.5, .centre = {2, 0, 0}}},
                               {1, {0.5, {4 * (1 + delta), 0, 0}, {-1, 0, 0}}}};
    std::vector<Real> times;
    Real now = 0;
    for (Event e = nextOf(beads); std::isfinite(e.time); e = nextOf(beads)) {
      advance(beads, e.time);
      now += e.time;
      times.push_back(now);
      collide(beads[e.left], beads[e.left + 1]);
      REQUIRE(times.size() < 10);
    }
    REQUIRE(times.size() == 3);
    CHECK(beads[0].ball.velocity.x() == -1);
    CHECK(beads[1].ball.velocity.x() == 0);
    CHECK(beads[2].ball.velocity.x() == 1);
    CHECK(times[0] == (delta < 0 ? 1 + 4 * delta : 1));
    if (delta > 0) {
      CHECK(std::abs(times[1] - number(expected["second_time"])) < 5e-16);
      CHECK(std::abs(times[2] - number(expected["third_time"])) < 5e-16);
    }
  }
}

TEST_CASE("no bullet passes a thin wall, at any speed") {
  // A ball of 5 cm from a thousand directions at a wall of 2 cm, sixty steps a second.
  const Ball ball{0.05};
  const Box wall{{0.01, 5, 5}};
  for (const Real speed : {50.0, 100.0, 350.0, 1000.0, 3000.0, 10000.0}) {
    Random random(3);
    int passed = 0, seenAtTheEnd = 0;
    for (int i = 0; i < 1000; ++i) {
      Vector3 direction = random.direction();
      direction.x() = std::abs(direction.x()) + 0.2;
      direction.normalize();
      Sweep bullet;
      bullet.velocity = speed * direction;
      bullet.angularVelocity = 100 * random.direction();
      // It would be through the middle of the wall somewhere in the middle of its first steps.
      const Vector3 target{0, random.between(-1, 1), random.between(-1, 1)};
      bullet.start.p_WB = target - random.between(0.1, 2.0) * direction;
      bool stopped = false;
      for (int step = 0; step < 10 && !stopped; ++step) {
        const TimeOfImpact hit = firstContact(ball, bullet, wall, {}, 1.0 / 60);
        REQUIRE(hit.status != ImpactStatus::kLimit);
        stopped = hit.status != ImpactStatus::kNoHit;
        if (step == 0 && contactBySubSteps(ball, bullet, wall, {}, 1.0 / 60, 1, 1e-9).status !=
                             ImpactStatus::kNoHit) {
          ++seenAtTheEnd;
        }
        bullet.start = poseAt(bullet, 1.0 / 60);
        if (bullet.start.p_WB.x() > 0.06) break;
      }
      if (!stopped) ++passed;
    }
    INFO(speed << " m/s");
    CHECK(passed == 0);
    CHECK(seenAtTheEnd < 200);  // looking at the ends of steps alone is no help
  }
}

// Many contacts at once: cradles, breaks, piles.

#include <cmath>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/impulse/bounded_impact.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/coulomb_impact.hpp"
#include "carom/impulse/simultaneous_impacts.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

MovingBody ball(Real mass, const Vector3& velocity) {
  MovingBody body;
  body.mass = {1 / mass, 2.5 / mass * Matrix3::Identity()};
  body.velocity.linear = velocity;
  return body;
}

// Touching balls of radius 1 in a row.
struct Row {
  std::vector<MovingBody> balls;
  std::vector<BodyContact> contacts;
};

Row row(const std::vector<Real>& masses, const std::vector<Real>& speeds, Real e) {
  Row r;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    r.balls.push_back(ball(masses[i], {speeds[i], 0, 0}));
    if (i == 0) continue;
    const int b = static_cast<int>(i);
    r.contacts.push_back({b - 1, b, {{1, 0, 0}, {1, 0, 0}, {-1, 0, 0}}, {.restitution = e}});
  }
  return r;
}

Row equalRow(const std::vector<Real>& speeds, Real e) {
  return row(std::vector<Real>(speeds.size(), 1), speeds, e);
}

std::vector<Real> speedsOf(const Row& r) {
  std::vector<Real> speeds;
  for (const MovingBody& body : r.balls) speeds.push_back(body.velocity.linear.x());
  return speeds;
}

Real energyOf(const std::vector<MovingBody>& bodies) {
  Real energy = 0;
  for (const MovingBody& body : bodies) {
    if (body.mass.inverseMass == 0) continue;
    energy += body.velocity.linear.squaredNorm() / body.mass.inverseMass / 2;
    if (body.mass.inverseInertia(0, 0) > 0) {
      energy += body.velocity.angular.squaredNorm() / body.mass.inverseInertia(0, 0) / 2;
    }
  }
  return energy;
}

// Balls one after the other with gaps between them: every approach is an impact of two.
std::vector<Real> oneByOne(std::vector<Real> speeds) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 1; i < speeds.size(); ++i) {
      if (speeds[i - 1] > speeds[i]) {
        std::swap(speeds[i - 1], speeds[i]);
        again = true;
      }
    }
  }
  return speeds;
}

}  // namespace

TEST_CASE("I5: as many balls leave the cradle as came in") {
  for (int n = 2; n <= 40; ++n) {
    for (int in = 1; in < n; in += 1 + n / 7) {
      std::vector<Real> speeds(at(n), 0), expected(at(n), 0);
      for (int i = 0; i < in; ++i) speeds[at(i)] = expected[at(n - 1 - i)] = 1;
      Row cradle = equalRow(speeds, 1);
      const SimultaneousImpacts result = simultaneousImpacts(cradle.balls, cradle.contacts);
      INFO(in << " of " << n);
      REQUIRE(result.status == ImpactsStatus::settled);
      REQUIRE(speedsOf(cradle) == expected);  // to the last bit
    }
  }
}

TEST_CASE("I5: balls that come in from both sides at different speeds change places") {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<Real> speeds(at(random.integer(2, 12)));
    for (Real& v : speeds) v = random.integer(0, 2) == 0 ? 0 : random.between(-2, 2);
    Row cradle = equalRow(speeds, 1);
    const SimultaneousImpacts result = simultaneousImpacts(cradle.balls, cradle.contacts);
    REQUIRE(result.status == ImpactsStatus::settled);
    const std::vector<Real> expected = oneByOne(speeds), got = speedsOf(cradle);
    INFO("seed 5, cradle " << i);
    for (std::size_t k = 0; k < got.size(); ++k) REQUIRE(std::abs(got[k] - expected[k]) < 1e-14);
  }
}

TEST_CASE("I5: falling masses speed the blow up, and e < 1 weakens it") {
  const json expected = impulseCase("I5");
  Row geometric = row({1, 0.5, 0.25, 0.125, 0.0625}, {1, 0, 0, 0, 0}, 1);
  simultaneousImpacts(geometric.balls, geometric.contacts);
  CHECK(near(speedsOf(geometric).back(), number(expected["geometric"]), 4));
  Row direct = row({1, 0.0625}, {1, 0}, 1);
  simultaneousImpacts(direct.balls, direct.contacts);
  CHECK(near(speedsOf(direct).back(), number(expected["direct"]), 2));
  Row lossy = equalRow({1, 0, 0, 0, 0}, 0.9);
  const SimultaneousImpacts result = simultaneousImpacts(lossy.balls, lossy.contacts);
  CHECK(result.status == ImpactsStatus::settled);
  CHECK(near(speedsOf(lossy).back(), number(expected["lossy"]), 4));
  // Newton's restitution for all contacts at once would throw the first ball back.
  Row three = equalRow({1, 0, 0}, 1);
  simultaneousImpacts(three.balls, three.contacts);
  CHECK(speedsOf(three).front() - number(expected["wrong"]["simultaneous_newton_of_three"][0]) >
        0.3);
}

TEST_CASE("I12: a cue ball between two others leaves them mirrored, to the last bit") {
  const json expected = impulseCase("I12");
  const Real c = std::sqrt(3.0) / 2, s = 0.5;
  for (const bool swapped : {false, true}) {
    std::vector<MovingBody> balls = {ball(1, {1, 0, 0}), ball(1, {0, 0, 0}), ball(1, {0, 0, 0})};
    const Vector3 up(c, s, 0), down(c, -s, 0);
    std::vector<BodyContact> contacts = {{0, 1, {up, up, -up}, {.restitution = 1}},
                                         {0, 2, {down, down, -down}, {.restitution = 1}}};
    // The two balls touch each other as well; they part, so that contact does nothing.
    contacts.push_back({1, 2, {{0, -1, 0}, {0, -1, 0}, {0, 1, 0}}, {.restitution = 1}});
    if (swapped) std::swap(contacts[0], contacts[1]);
    simultaneousImpacts(balls, contacts);
    const Vector3 cue = balls[0].velocity.linear, first = balls[1].velocity.linear,
                  second = balls[2].velocity.linear;
    CHECK(std::abs(cue.x() - number(expected["cue_after"])) < 1e-15);
    CHECK(cue.y() == 0);
    CHECK(first.x() == second.x());
    CHECK(first.y() == -second.y());
    CHECK(nearVector(Vector2(first.x(), first.y()), vector2(expected["ball"])));
    CHECK(near(first.norm(), number(expected["ball_speed"]), 4));
  }
}

TEST_CASE("a break of fifteen balls keeps momentum and energy, and stays mirrored") {
  // A triangle of touching balls; the cue ball meets its tip along the axis.
  std::vector<MovingBody> balls = {ball(1, {1, 0, 0})};
  std::vector<Vector2> places = {{-2, 0}};
  for (int r = 0; r < 5; ++r) {
    for (int k = 0; k <= r; ++k) {
      places.emplace_back(std::sqrt(3.0) * r, 2.0 * k - r);
      balls.push_back(ball(1, {0, 0, 0}));
    }
  }
  std::vector<BodyContact> contacts;
  for (int i = 0; i < 16; ++i) {
    for (int j = i + 1; j < 16; ++j) {
      const Vector2 d = places[at(j)] - places[at(i)];
      if (d.norm() > 2 + 1e-9) continue;
      const Vector3 n(d.x() / d.norm(), d.y() / d.norm(), 0);
      contacts.push_back({i, j, {n, n, -n}, {.restitution = 1}});
    }
  }
  REQUIRE(contacts.size() == 31);
  const SimultaneousImpacts result = simultaneousImpacts(balls, contacts);
  REQUIRE(result.status == ImpactsStatus::settled);
  Vector3 momentum = Vector3::Zero();
  for (const MovingBody& body : balls) momentum += body.velocity.linear;
  CHECK((momentum - Vector3(1, 0, 0)).norm() < 1e-14);
  CHECK(std::abs(energyOf(balls) - 0.5) < 1e-13);
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < 16; ++j) {
      if (std::abs(places[at(i)].x() - places[at(j)].x()) > 1e-9) continue;
      if (std::abs(places[at(i)].y() + places[at(j)].y()) > 1e-9) continue;
      const Vector3 &v = balls[at(i)].velocity.linear, &w = balls[at(j)].velocity.linear;
      CHECK(std::abs(v.x() - w.x()) < 1e-13);
      CHECK(std::abs(v.y() + w.y()) < 1e-13);
    }
  }
}

TEST_CASE("heaps of balls of any mass, bounce and friction never gain energy and end apart") {
  Random random(2012);
  int limits = 0;
  for (int i = 0; i < 300; ++i) {
    const int n = random.integer(2, 8);
    std::vector<MovingBody> bodies = {MovingBody{}};  // a wall
    for (int k = 0; k < n; ++k) {
      bodies.push_back(ball(std::pow(10, random.between(-2, 2)), random.vector(1)));
    }
    std::vector<BodyContact> contacts;
    const int pairs = random.integer(1, 2 * n);
    const bool mixed = random.integer(0, 1) == 0;
    const Real common = random.between(0, 1);
    for (int k = 0; k < pairs; ++k) {
      const int a = random.integer(0, n - 1), b = random.integer(a + 1, n);
      const Vector3 normal = random.direction();
      const Real e = mixed ? random.between(0, 1) : common;
      contacts.push_back({a, b, {normal, normal, -normal}, {e, random.between(0, 1), 0}});
    }
    const Real before = energyOf(bodies);
    const SimultaneousImpacts result = simultaneousImpacts(bodies, contacts);
    INFO("seed 2012, heap " << i << ", rounds " << result.rounds);
    REQUIRE(energyOf(bodies) <= before * (1 + 1e-12));
    REQUIRE(result.approach < 1e-12);
    limits += result.status == ImpactsStatus::roundLimit;
    for (const Real j : result.normalImpulses) REQUIRE(j >= 0);
  }
  INFO(limits << " heaps reached the limit of rounds");
  CHECK(limits < 30);
}

TEST_CASE("a box that lands flat on four corners stops at once, and one that rocks does not sink") {
  MovingBody box;
  box.mass = {1, Vector3(1.5, 1.5, 1.5).asDiagonal()};
  std::vector<MovingBody> bodies = {MovingBody{}, box};
  std::vector<BodyContact> contacts;
  for (const Real x : {-1.0, 1.0}) {
    for (const Real y : {-1.0, 1.0}) {
      contacts.push_back({0, 1, {{0, 0, 1}, {0, 0, 0}, {x, y, -1}}, {}});
    }
  }
  bodies[1].velocity.linear = {0, 0, -3};
  SimultaneousImpacts result = simultaneousImpacts(bodies, contacts);
  CHECK(result.rounds == 1);
  CHECK(bodies[1].velocity.linear.norm() < 1e-15);
  CHECK(bodies[1].velocity.angular.norm() < 1e-15);
  for (const Real j : result.normalImpulses) CHECK(near(j, 0.75));  // all four carry alike
  // Turning: two corners go down and two up.
  bodies[1].velocity = {{0, 0, -0.1}, {1, 0, 0}};
  result = simultaneousImpacts(bodies, contacts);
  CHECK(result.status == ImpactsStatus::settled);
  CHECK(result.approach < 1e-15);
}

TEST_CASE("an edge that hits and sticks stops its slip, both its ends at once (case I19)") {
  for (const int points : {1, 2}) {
    std::vector<MovingBody> bodies(2);
    bodies[1].mass = {1, Vector3(1, 1.5, 1).asDiagonal()};
    bodies[1].velocity = {{1, 0, -3}, {0, -2, 0}};
    std::vector<BodyContact> contacts;
    for (int i = 0; i < points; ++i) {
      const Real y = points == 1 ? 0 : i - 0.5;
      contacts.push_back(
          {0, 1, {{0, 0, 1}, {-0.8, y, 0}, {-0.8, y, -1.1}}, {.restitution = 0.5, .friction = 1}});
    }
    simultaneousImpacts(bodies, contacts, {.stopsSlip = true});
    const Velocity& after = bodies[1].velocity;
    CHECK((after.linear - Vector3(6611.0 / 3775, 0, 7749.0 / 7550)).norm() < 1e-14);
    CHECK((after.angular - Vector3(0, 1202.0 / 755, 0)).norm() < 1e-14);
  }
}

TEST_CASE("where Newton's and Coulomb's laws make energy the law that makes none is taken") {
  // A rod that leans: friction can turn it into the floor, and the bounce then gives back more.
  int differ = 0, all = 0;
  for (int i = 1; i < 40; ++i) {
    for (const Real speed : {-3.0, -1.0, -0.3, 0.3, 1.0, 3.0}) {
      const Real angle = i * 0.04;
      std::vector<MovingBody> bodies(2);
      bodies[1].mass = {1, Vector3(3, 3, 3).asDiagonal()};
      bodies[1].velocity = {{speed, 0, -1}, {0, 0, 0}};
      const Contact tip{{0, 0, 1}, Vector3::Zero(), {std::cos(angle), 0, -std::sin(angle)}};
      const ImpactLaw law{.restitution = 1, .friction = 0.6};
      const Impact impact = boundedImpact(bodies[0], bodies[1], tip, law);
      differ += impact.impulse != coulombImpact(bodies[0], bodies[1], tip, law).impulse;
      ++all;
      const Real before = energyOf(bodies);
      changeVelocities(bodies[0], bodies[1], tip, impact.impulse);
      CHECK(energyOf(bodies) <= before * (1 + 1e-14));
    }
  }
  CHECK(differ > 0);
  CHECK(differ < all);
}

TEST_CASE("too few rounds end plastically and say so") {
  Row cradle = equalRow({1, 0, 0, 0, 0}, 1);
  const SimultaneousImpacts result =
      simultaneousImpacts(cradle.balls, cradle.contacts, {.maxRounds = 2});
  CHECK(result.status == ImpactsStatus::roundLimit);
  CHECK(result.rounds == 2);
  CHECK(result.approach < 1e-15);
  CHECK(energyOf(cradle.balls) < 0.5);
}

TEST_CASE("contacts that name no body are refused, and nothing moves") {
  Row cradle = equalRow({1, 0}, 1);
  cradle.contacts[0].bodyB = 7;
  CHECK_THROWS_WITH(simultaneousImpacts(cradle.balls, cradle.contacts),
                    ContainsSubstring("7 names no body"));
  cradle.contacts[0].bodyB = 0;
  CHECK_THROWS_WITH(simultaneousImpacts(cradle.balls, cradle.contacts),
                    ContainsSubstring("touches itself"));
  CHECK(speedsOf(cradle) == std::vector<Real>{1, 0});
}

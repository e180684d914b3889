// How large impulses are, what they do, and what the slips of the source would do instead.

#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/impulse/apply_impulse.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/combine_restitution.hpp"
#include "carom/impulse/effective_mass.hpp"
#include "carom/impulse/impulse_2d.hpp"
#include "carom/impulse/impulse_3d.hpp"
#include "carom/impulse/impulse_wall.hpp"
#include "carom/impulse/planar_motion.hpp"
#include "carom/impulse/point_velocity.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

PlanarBody planar(Real mass, Real inertia, const Vector2& v, Real w = 0) {
  return {planarBodyMass(mass, inertia), {v, w}};
}

// A body whose own axes are turned against the world's.
OrientedBody tumbling(Random& random, Real mass) {
  MassProperties body;
  body.mass = mass;
  body.inertia = randomMoments(random, mass, 1).asDiagonal();
  return orientedBody(body, randomRotation(random), {random.vector(3), random.vector(3)});
}

MovingBody inWorld(const OrientedBody& body) {
  return {massInWorld(body), body.velocity};
}

Contact randomContact(Random& random) {
  Contact contact;
  contact.normal = random.direction();
  contact.armA = random.vector();
  contact.armB = random.vector();
  return contact;
}

Real partingSpeed(const OrientedBody& a, const OrientedBody& b, const Contact& contact) {
  return (pointVelocity(b.velocity, contact.armB) - pointVelocity(a.velocity, contact.armA))
      .dot(contact.normal);
}

Vector3 spinOf(const OrientedBody& body) {
  return body.R_WB * Matrix3(body.inverseInertia.diagonal().cwiseInverse().asDiagonal()) *
         body.R_WB.transpose() * body.velocity.angular;
}

Real energyOf(const OrientedBody& body) {
  return body.velocity.linear.squaredNorm() / body.inverseMass / 2 +
         body.velocity.angular.dot(spinOf(body)) / 2;
}

}  // namespace

TEST_CASE("the effective mass of free centres is that of two masses in series") {
  BodyMass a, b;
  a.inverseMass = 1.0 / 2;
  b.inverseMass = 1.0 / 6;
  CHECK(effectiveMass(a, b, Contact{}) == 1.5);
  CHECK(effectiveMass(a, BodyMass{}, Contact{}) == 2);  // against a wall
  CHECK(std::isinf(effectiveMass(BodyMass{}, BodyMass{}, Contact{})));
}

TEST_CASE("a body is lighter where it is hit off-centre") {
  BodyMass rod;  // along x: 3 kg, 2 m
  rod.inverseMass = 1.0 / 3;
  rod.inverseInertia = Vector3(1000, 1, 1).asDiagonal();
  const Real x = 0.8;
  const Contact hit{{0, 1, 0}, {0, 0, 0}, {x, 0, 0}};
  CHECK(near(effectiveMass({}, rod, hit), 1 / (1.0 / 3 + x * x)));
  // An impulse along the arm does not turn the rod.
  CHECK(effectiveMass({}, rod, Contact{{1, 0, 0}, {0, 0, 0}, {x, 0, 0}}) == 3);
}

TEST_CASE("the effective mass says how much a unit impulse parts the points") {
  Random random(32);
  for (int i = 0; i < 1000; ++i) {
    OrientedBody a = tumbling(random, std::pow(10, random.between(-3, 3)));
    OrientedBody b = tumbling(random, std::pow(10, random.between(-3, 3)));
    const Contact contact = randomContact(random);
    const Real mass = effectiveMass(massInWorld(a), massInWorld(b), contact);
    a.velocity = b.velocity = Velocity{};  // so that the change is the whole
    applyImpulse(a, contact.armA, b, contact.armB, contact.normal);
    INFO("seed 32, pair " << i);
    REQUIRE(std::abs(partingSpeed(a, b, contact) * mass - 1) < 1e-13);
  }
}

TEST_CASE("planar bodies that do not approach get no impulse") {
  const PlanarContact touch{{1, 0}, {0, 0}, {0, 0}};
  CHECK(impulse2d(planar(1, 1, {0, 0}), planar(1, 1, {2, 0}), touch, 1) == 0);
  CHECK(impulse2d(planar(1, 1, {0, 0}), planar(1, 1, {0, 5}), touch, 1) == 0);
  CHECK(impulse2d(PlanarBody{}, PlanarBody{{}, {{-1, 0}, 0}}, touch, 1) == 0);  // both immovable
}

TEST_CASE("erratum 6.5: a smooth disc that meets a wall head-on turns round") {
  // With (r . n)^2 in place of (r x n)^2 the impulse would be 2/3, and the disc go on at 1/3.
  const PlanarContact touch{{0, 1}, {0, 0}, {0, -1}};
  const PlanarBody disc = planar(1, 0.5, {0, -1});
  const Real j = impulse2d(PlanarBody{}, disc, touch, 1);
  CHECK(j == 2);
  const Real slip = 2 / (1 + 1 / 0.5);  // r . n = -1
  CHECK(std::abs(j - slip) > 1);
}

TEST_CASE("a planar impact is the spatial one seen from above") {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 d = random.direction();
    const Vector2 n = Vector2(d.x(), d.y()).normalized();
    const PlanarContact contact{n,
                                {random.between(-1, 1), random.between(-1, 1)},
                                {random.between(-1, 1), random.between(-1, 1)}};
    const PlanarBody a = planar(2, 0.3, {random.between(-1, 1), 0.5}, random.between(-3, 3));
    const PlanarBody b = planar(0.7, 0.1, {-0.2, random.between(-1, 1)}, random.between(-3, 3));
    const auto lift = [](const PlanarBody& p) {
      MovingBody body;
      body.mass.inverseMass = p.mass.inverseMass;
      body.mass.inverseInertia = p.mass.inverseInertia * Matrix3::Identity();
      body.velocity = {{p.velocity.linear.x(), p.velocity.linear.y(), 0},
                       {0, 0, p.velocity.angular}};
      return body;
    };
    const auto raise = [](const Vector2& v) { return Vector3(v.x(), v.y(), 0); };
    const Real j = impulse2d(a, b, contact, 0.4);
    const Real spatial = impulse3d(
        lift(a), lift(b), Contact{raise(n), raise(contact.armA), raise(contact.armB)}, 0.4);
    REQUIRE(std::abs(j - spatial) <= 1e-14 * std::max(1.0, j));
  }
}

TEST_CASE("after a spatial impact the points part at e times the speed at which they met") {
  Random random(3);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    OrientedBody a = tumbling(random, 1.7), b = tumbling(random, 0.4);
    const Contact contact = randomContact(random);
    const Real e = random.between(0, 1);
    const Real before = partingSpeed(a, b, contact);
    const Real energy = energyOf(a) + energyOf(b);
    const Vector3 momentum = a.velocity.linear / a.inverseMass + b.velocity.linear / b.inverseMass;
    // Angular momentum about the contact: centres lie at minus the arms.
    const auto angular = [&] {
      return Vector3(spinOf(a) + spinOf(b) -
                     cross(contact.armA, a.velocity.linear) / a.inverseMass -
                     cross(contact.armB, b.velocity.linear) / b.inverseMass);
    };
    const Vector3 angularBefore = angular();
    const Real j = impulse3d(inWorld(a), inWorld(b), contact, e);
    REQUIRE(j >= 0);
    if (before >= 0) {
      REQUIRE(j == 0);
      continue;
    }
    ++hits;
    const Real mass = effectiveMass(massInWorld(a), massInWorld(b), contact);
    applyImpulse(a, contact.armA, b, contact.armB, j * contact.normal);
    INFO("seed 3, pair " << i);
    REQUIRE(std::abs(partingSpeed(a, b, contact) + e * before) < 1e-13);
    // Erratum 1.2: the loss is not a matter of taste.
    const Real loss = (1 - e * e) * before * before * mass / 2;
    REQUIRE(std::abs(energy - energyOf(a) - energyOf(b) - loss) < 1e-12 * energy);
    REQUIRE(
        (a.velocity.linear / a.inverseMass + b.velocity.linear / b.inverseMass - momentum).norm() <
        1e-13);
    REQUIRE((angular() - angularBefore).norm() < 1e-12);
  }
  CHECK(hits > 800);
}

TEST_CASE("a wall is a body without inverse mass") {
  Random random(33);
  for (int i = 0; i < 500; ++i) {
    const MovingBody body = inWorld(tumbling(random, 2));
    const Contact contact = randomContact(random);
    REQUIRE(impulseWall(body, contact.armB, contact.normal, 0.7) ==
            impulse3d(MovingBody{}, body, contact, 0.7));
  }
  MovingBody ball;
  ball.mass.inverseMass = 0.25;
  ball.velocity.linear = {1, 0, -3};
  CHECK(impulseWall(ball, {0, 0, -1}, {0, 0, 1}, 0.5) == 18);
  CHECK(impulseWall(ball, {0, 0, -1}, {0, 0, -1}, 0.5) == 0);  // flies away from a ceiling
}

TEST_CASE("impulses refuse what is not a contact, a body or a restitution") {
  const MovingBody body{{1, Matrix3::Identity()}, {{0, 0, -1}, {0, 0, 0}}};
  const PlanarBody flat = planar(1, 1, {0, -1});
  CHECK_THROWS_WITH(impulse3d({}, body, Contact{}, 1.6), ContainsSubstring("restitution = 1.6"));
  CHECK_THROWS_AS(impulse3d({}, body, Contact{{0, 0, 2}, {0, 0, 0}, {0, 0, 0}}, 1), InvalidInput);
  CHECK_THROWS_AS(impulseWall(body, {kNan, 0, 0}, {0, 0, 1}, 1), InvalidInput);
  CHECK_THROWS_AS(impulse2d({}, flat, PlanarContact{}, -0.1), InvalidInput);
  CHECK_THROWS_AS(impulse2d({}, flat, PlanarContact{{kNan, 1}, {0, 0}, {0, 0}}, 1), InvalidInput);
  CHECK_THROWS_AS(effectiveMass({}, body.mass, Contact{{1, 1, 0}, {0, 0, 0}, {0, 0, 0}}),
                  InvalidInput);
}

TEST_CASE("errata 6.3 and 6.4: what B gets, A loses, in momentum and in angular momentum") {
  OrientedBody a{1.0, Matrix3::Identity(), Matrix3::Identity(), {{3, 0, 0}, {0, 0, 0}}};
  OrientedBody b{0.5, Matrix3::Identity(), Matrix3::Identity(), {{-1, 0, 0}, {0, 0, 0}}};
  applyImpulse(a, {1, 0.5, 0}, b, {-1, 0.25, 0}, {16.0 / 3, 0, 0});
  // With a plus sign for both, total momentum would be -9.67 or 11.67, not 1.
  CHECK(near(a.velocity.linear.x() + 2 * b.velocity.linear.x(), 1, 8));
  CHECK(near(a.velocity.angular.z(), 0.5 * 16 / 3));    // r x (-J): counter-clockwise
  CHECK(near(b.velocity.angular.z(), -0.25 * 16 / 3));  // r x J: clockwise
}

TEST_CASE("erratum 6.4: an impulse across the arm turns a body, one along it does not") {
  // The source's r . jn says the opposite in both cases.
  OrientedBody wall;
  OrientedBody rod{1.0, Matrix3::Identity(), Matrix3::Identity(), {}};
  applyImpulse(wall, {0, 0, 0}, rod, {2, 0, 0}, {5, 0, 0});
  CHECK(rod.velocity.angular == Vector3(0, 0, 0));
  applyImpulse(wall, {0, 0, 0}, rod, {2, 0, 0}, {0, 5, 0});
  CHECK(rod.velocity.angular == Vector3(0, 0, 10));
  CHECK(wall.velocity.linear == Vector3(0, 0, 0));
}

TEST_CASE("erratum 4.4: the inertia along the body's axes is not that along the world's") {
  // A rod along its own x axis that stands upright, hit at its upper end, sideways.
  OrientedBody rod;
  rod.inverseMass = 1;
  rod.inverseInertia = Vector3(1000, 1, 1).asDiagonal();
  rod.R_WB << 0, 0, -1, 0, 1, 0, 1, 0, 0;  // its x axis points up
  OrientedBody wall;
  applyImpulse(wall, {0, 0, 0}, rod, {0, 0, 1}, {0, 1, 0});
  CHECK(rod.velocity.angular == Vector3(-1, 0, 0));  // forgetting the rotation gives -1000
}

TEST_CASE("an impulse that is not a number changes nothing") {
  OrientedBody a{1, Matrix3::Identity(), Matrix3::Identity(), {{1, 2, 3}, {4, 5, 6}}};
  OrientedBody b = a;
  CHECK_THROWS_WITH(applyImpulse(a, {0, 0, 0}, b, {0, 0, 0}, {kNan, 0, 0}),
                    ContainsSubstring("impulse"));
  CHECK_THROWS_AS(applyImpulse(a, {0, 0, kNan}, b, {0, 0, 0}, {1, 0, 0}), InvalidInput);
  CHECK(a.velocity.linear == Vector3(1, 2, 3));
  CHECK(b.velocity.angular == Vector3(4, 5, 6));
}

TEST_CASE("every rule for two coefficients of restitution stays between zero and one") {
  using Rule = RestitutionRule;
  CHECK(combineRestitution(0.5, 1, Rule::average) == 0.75);
  CHECK(combineRestitution(0.5, 0.25, Rule::product) == 0.125);
  CHECK(combineRestitution(0.5, 0.25, Rule::minimum) == 0.25);
  CHECK(combineRestitution(0.5, 0.25, Rule::maximum) == 0.5);
  CHECK(combineRestitution(0.25, 1, Rule::geometricMean) == 0.5);
  CHECK(combineRestitution(1e-200, 1e-200, Rule::geometricMean) > 0);
  for (const Rule rule :
       {Rule::average, Rule::product, Rule::minimum, Rule::maximum, Rule::geometricMean}) {
    for (Real a = 0; a <= 1; a += 0.125) {
      for (Real b = 0; b <= 1; b += 0.125) {
        const Real e = combineRestitution(a, b, rule);
        CHECK((e >= 0 && e <= 1));
        CHECK(e == combineRestitution(b, a, rule));
      }
    }
    CHECK(combineRestitution(1, 1, rule) == 1);
    CHECK_THROWS_WITH(combineRestitution(0.5, 1.2, rule), ContainsSubstring("1.2"));
    CHECK_THROWS_AS(combineRestitution(kNan, 1, rule), InvalidInput);
  }
}

// Grader of 05.impulse_2d: hits that are worked out by hand, and any hits, after which the points
// must part as fast as was asked for.

#include "carom/impulse/impulse_2d.hpp"

#include <cmath>
#include <limits>

#include "grading/fields_impulse.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

PlanarBody body(Real mass, Real inertia, const Vector2& velocity, Real rate) {
  PlanarBody made;
  made.mass = {1 / mass, 1 / inertia};
  made.velocity = {velocity, rate};
  return made;
}

void ask(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact, Real e,
         Real expected, const char* what) {
  GRADE(impulse2d(a, b, contact, e), expected, within(4e-15, kRounding), given("a", a),
        given("b", b), given("normal", contact.normal), given("armA", contact.armA, "m"),
        given("armB", contact.armB, "m"), given("restitution", e), unit("N s"), about(what));
}

// The speed at which the points part: what turning adds to a point is its arm, turned by a quarter.
Real partingSpeed(const PlanarVelocity& a, const PlanarVelocity& b, const PlanarContact& contact) {
  const auto speed = [&contact](const PlanarVelocity& v, const Vector2& arm) {
    const Vector2 quarterTurned(-arm.y(), arm.x());
    return contact.normal.dot(v.linear) + v.angular * contact.normal.dot(quarterTurned);
  };
  return speed(b, contact.armB) - speed(a, contact.armA);
}

// The velocity after an impulse at the end of an arm. The lever is what the arm measures across the
// impulse.
PlanarVelocity after(const PlanarBody& body, const Vector2& arm, const Vector2& impulse) {
  const Vector2 quarterTurned(-arm.y(), arm.x());
  PlanarVelocity v = body.velocity;
  v.linear += body.mass.inverseMass * impulse;
  v.angular += body.mass.inverseInertia * quarterTurned.dot(impulse);
  return v;
}

// How the points part after the impulse, as a share of the speed at which they met.
Real bounce(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact, Real j) {
  const Real met = -partingSpeed(a.velocity, b.velocity, contact);
  const Vector2 impulse = j * contact.normal;
  return partingSpeed(after(a, contact.armA, -impulse), after(b, contact.armB, impulse), contact) /
         met;
}

PlanarBody anyBody(Random& random) {
  const Real mass = random.between(0.5, 4), inertia = random.between(0.1, 2);
  const Vector3 v = random.vector(3);
  return body(mass, inertia, {v.x(), v.y()}, v.z());
}

PlanarContact anyContact(Random& random) {
  PlanarContact contact;
  const Real angle = random.between(0, 6.28);
  contact.normal = {std::cos(angle), std::sin(angle)};
  const Vector3 a = random.vector(), b = random.vector();
  contact.armA = {a.x(), a.y()};
  contact.armB = {b.x(), b.y()};
  return contact;
}

// A hit that is clear enough to be divided by its speed; B is moved so that it approaches.
struct Hit {
  PlanarBody a, b;
  PlanarContact contact;
  Real e = 0;
};
Hit anyHit(Random& random) {
  Hit hit;
  hit.a = anyBody(random);
  hit.b = anyBody(random);
  hit.contact = anyContact(random);
  hit.e = random.between(0.05, 1);
  const Real parting = partingSpeed(hit.a.velocity, hit.b.velocity, hit.contact);
  hit.b.velocity.linear -= (parting + random.between(0.5, 4)) * hit.contact.normal;
  return hit;
}

}  // namespace

TEST_CASE("head_on") {
  const PlanarContact contact{{1, 0}, {0.5, 0}, {-0.5, 0}};
  const PlanarBody a = body(1, 0.1, {3, 0}, 0), b = body(2, 0.2, {-1, 0}, 0);
  ask(a, b, contact, 1, 16.0 / 3, "1 kg at 3 m/s meets 2 kg at -1 m/s, without loss");
  ask(a, b, contact, 0.5, 4, "1 kg at 3 m/s meets 2 kg at -1 m/s, e = 1/2");
  ask(a, b, contact, 0, 8.0 / 3, "1 kg at 3 m/s meets 2 kg at -1 m/s, and they go on together");
}

TEST_CASE("through_the_centre") {
  const PlanarContact ground{{0, 1}, {0, 0}, {0, -1}};
  ask({}, body(1, 0.5, {0, -1}, 0), ground, 1, 2,
      "a disc of 1 kg and 1 m falls on the ground at 1 m/s and comes back as fast");
  ask({}, body(1, 0.5, {3, -2}, 4), ground, 0.5, 3,
      "the same disc spins and flies sideways: without friction that changes nothing");
}

TEST_CASE("off_centre") {
  // A rod of 3 kg and 2 m along x has I = 1 kg m^2.
  const PlanarBody rod = body(3, 1, {0, 0}, 0);
  ask(body(1, 0.1, {0, 5}, 0), rod, {{0, 1}, {0, 0.25}, {0.8, 0}}, 1, 375.0 / 74,
      "a rod along x at rest is hit across, 0.8 m beside its centre, by a ball of 1 kg");
  ask(rod, body(1, 0.1, {0, -5}, 0), {{0, 1}, {0.8, 0}, {0, -0.25}}, 0, 375.0 / 148,
      "the rod is A, and the ball stays with it");
}

TEST_CASE("parting") {
  const PlanarContact contact{{1, 0}, {0.5, 0}, {-0.5, 0}};
  const PlanarBody slow = body(1, 0.1, {1, 0}, 0), fast = body(1, 0.1, {3, 0}, 0);
  ask(fast, slow, contact, 1, 2, "A catches up with B");
  ask(slow, fast, contact, 1, 0, "B runs away from A");
  ask(body(1, 0.1, {3, 7}, 2), fast, contact, 1, 0, "they touch, and neither approaches nor parts");
  ask({}, {{}, {{-1, 0}, 0}}, contact, 1, 0, "neither can be moved, although B comes nearer");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Hit hit = anyHit(random);
    const PlanarBody a = hit.a, b = hit.b;
    const PlanarContact contact = hit.contact;
    const Real e = hit.e;
    GRADE(bounce(a, b, contact, impulse2d(a, b, contact, e)), e, within(1e-13, kRounding),
          given("a", a), given("b", b), given("normal", contact.normal),
          given("armA", contact.armA, "m"), given("armB", contact.armB, "m"),
          given("restitution", e),
          about("the speed at which the points part, over that at which they met"));
  }
}

TEST_CASE("refuses") {
  const PlanarContact contact{{1, 0}, {0, 0}, {0, 0}};
  const PlanarBody a = body(1, 1, {1, 0}, 0), b = body(1, 1, {-1, 0}, 0);
  GRADE_REFUSES(impulse2d(a, b, contact, 1.6), given("restitution", 1.6));
  GRADE_REFUSES(impulse2d(a, b, {{3, 4}, {0, 0}, {0, 0}}, 1), given("normal", Vector2(3, 4)));
}

PROBES() {
  Random random(503);
  for (int n = 0; n < 16; ++n) {
    const Hit hit = anyHit(random);
    PROBE(impulse2d(hit.a, hit.b, hit.contact, hit.e));
    // And the other way round in time.
    PlanarBody a = hit.a, b = hit.b;
    a.velocity = {-a.velocity.linear, -a.velocity.angular};
    b.velocity = {-b.velocity.linear, -b.velocity.angular};
    PROBE(impulse2d(a, b, hit.contact, hit.e));
  }
}

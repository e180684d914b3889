// Grader of 05.impulse_3d: a hit worked out in fractions, and any hits, after which the points must
// part as fast as was asked for.

#include "carom/impulse/impulse_3d.hpp"

#include "graders/05_impulse/bodies.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

void ask(const MovingBody& a, const MovingBody& b, const Contact& contact, Real e, Real expected,
         const char* what) {
  GRADE(impulse3d(a, b, contact, e), expected, within(1e-14, kRounding), given("a", a),
        given("b", b), given("normal", contact.normal), given("armA", contact.armA, "m"),
        given("armB", contact.armB, "m"), given("restitution", e), unit("N s"), about(what));
}

MovingBody ball(Real mass, Real speed) {
  return {{1 / mass, 10 / mass * Matrix3::Identity()}, {{0, speed, 0}, {0, 0, 0}}};
}

struct Hit {
  Solid a, b;
  Contact contact;
  Real e = 0;
};

// B is moved so that the points approach.
Hit anyHit(Random& random) {
  Hit hit;
  hit.a = anySolid(random);
  hit.b = anySolid(random);
  hit.contact = anyContact(random);
  hit.e = random.between(0.05, 1);
  const Real parting = partingSpeed(hit.a.velocity, hit.b.velocity, hit.contact);
  const Real faster = random.between(0.5, 4);
  hit.b.velocity.linear -= (parting + faster) * hit.contact.normal;
  return hit;
}

// The speed at which the points part after the impulse, as a share of that at which they met.
Real bounce(const Hit& hit, Real j) {
  const auto v = after(hit.a, hit.b, hit.contact, j * hit.contact.normal);
  return partingSpeed(v[0], v[1], hit.contact) /
         -partingSpeed(hit.a.velocity, hit.b.velocity, hit.contact);
}

}  // namespace

TEST_CASE("balls") {
  const Contact contact{{0, 1, 0}, {0, 0.5, 0}, {0, -0.5, 0}};
  ask(ball(1, 3), ball(2, -1), contact, 1, 16.0 / 3,
      "1 kg at 3 m/s meets 2 kg at -1 m/s, without loss");
  ask(ball(1, 3), ball(2, -1), contact, 0.5, 4, "1 kg at 3 m/s meets 2 kg at -1 m/s, e = 1/2");
  ask({}, ball(2, -1), contact, 0, 2, "A is a wall, and the ball stays at it");
}

TEST_CASE("rods") {
  // A is a slanted rod, B a block along the axes. All numbers are fractions, and so is the answer.
  Solid a, b;
  a.mass = 2;
  a.moments = {0.1, 2, 2};
  a.axes << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  a.axes /= 3;
  a.velocity = {{1, -2, 0.5}, {0.5, 1, -1}};
  b.mass = 3;
  b.moments = {3, 4, 5};
  b.velocity = {{-1, 1, 0}, {0, -2, 1}};
  // From A to B: the points approach at 131/56 m/s.
  const Contact contact{{6.0 / 7, -2.0 / 7, -3.0 / 7}, {0.5, -0.75, 0.25}, {-1, 0.5, 1.0 / 3}};
  ask(a.moving(), b.moving(), contact, 1, 990360.0 / 533419, "a rod and a block, without loss");
  ask(a.moving(), b.moving(), contact, 0.3, 643734.0 / 533419, "a rod and a block, e = 0.3");
}

TEST_CASE("parting") {
  const Contact contact{{0, 1, 0}, {0, 0.5, 0}, {0, -0.5, 0}};
  ask(ball(1, 3), ball(1, 1), contact, 1, 2, "A catches up with B");
  ask(ball(1, 1), ball(1, 3), contact, 1, 0, "B runs away from A");
  ask({}, {{}, {{0, -1, 0}, {0, 0, 0}}}, contact, 1, 0,
      "neither can be moved, although B comes nearer");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Hit hit = anyHit(random);
    const MovingBody a = hit.a.moving(), b = hit.b.moving();
    const Contact contact = hit.contact;
    const Real e = hit.e;
    GRADE(bounce(hit, impulse3d(a, b, contact, e)), e, within(1e-13, kRounding), given("a", a),
          given("b", b), given("normal", contact.normal), given("armA", contact.armA, "m"),
          given("armB", contact.armB, "m"), given("restitution", e),
          about("the speed at which the points part, over that at which they met"));
  }
}

TEST_CASE("refuses") {
  const Contact contact{{0, 1, 0}, {0, 0.5, 0}, {0, -0.5, 0}};
  GRADE_REFUSES(impulse3d(ball(1, 3), ball(2, -1), contact, 1.6), given("restitution", 1.6));
  GRADE_REFUSES(impulse3d(ball(1, 3), ball(2, -1), {{0, 0.5, 0}, {0, 0, 0}, {0, 0, 0}}, 1),
                given("normal", Vector3(0, 0.5, 0)));
}

PROBES() {
  Random random(505);
  for (int n = 0; n < 16; ++n) {
    const Hit hit = anyHit(random);
    MovingBody a = hit.a.moving(), b = hit.b.moving();
    PROBE(impulse3d(a, b, hit.contact, hit.e));
    // And the other way round in time.
    a.velocity = {-a.velocity.linear, -a.velocity.angular};
    b.velocity = {-b.velocity.linear, -b.velocity.angular};
    PROBE(impulse3d(a, b, hit.contact, hit.e));
  }
}

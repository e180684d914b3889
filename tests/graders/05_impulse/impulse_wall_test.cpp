// Grader of 05.impulse_wall: balls and a falling rod that can be worked out by hand, and any body,
// whose point must leave the wall as fast as was asked for.

#include "carom/impulse/impulse_wall.hpp"

#include <cmath>

#include "graders/05_impulse/bodies.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

// A body whose own axes are those of the world.
MovingBody body(Real mass, const Vector3& moments, const Vector3& velocity, const Vector3& rate) {
  return {{1 / mass, moments.cwiseInverse().asDiagonal()}, {velocity, rate}};
}

void ask(const MovingBody& body, const Vector3& arm, const Vector3& normal, Real e, Real expected,
         const char* what) {
  GRADE(impulseWall(body, arm, normal, e), expected, within(1e-14, kRounding), given("body", body),
        given("arm", arm, "m"), given("normal", normal), given("restitution", e), unit("N s"),
        about(what));
}

struct Hit {
  Solid solid;
  Contact contact;  // the wall is A
  Real e = 0;

  Real parting() const {
    return partingSpeed({}, solid.velocity, contact);
  }
};

// A body whose point comes towards the wall.
Hit anyHit(Random& random) {
  Hit hit;
  hit.solid = anySolid(random);
  hit.contact = anyContact(random);
  hit.e = random.between(0.05, 1);
  const Real faster = random.between(0.5, 4);
  hit.solid.velocity.linear -= (hit.parting() + faster) * hit.contact.normal;
  return hit;
}

// The speed at which the point leaves the wall, as a share of the speed at which it came.
Real bounce(const Hit& hit, Real j) {
  const Velocity d = hit.solid.change(hit.contact.armB, j * hit.contact.normal);
  Velocity v = hit.solid.velocity;
  v.linear += d.linear;
  v.angular += d.angular;
  return partingSpeed({}, v, hit.contact) / -hit.parting();
}

}  // namespace

TEST_CASE("ball") {
  const Vector3 up = Vector3::UnitZ(), down(0, 0, -0.5);
  const Vector3 moments(0.2, 0.2, 0.2);
  ask(body(2, moments, {0, 0, -3}, {0, 0, 0}), down, up, 0.5, 9,
      "a ball of 2 kg falls at 3 m/s and comes back at half of it");
  ask(body(2, moments, {0, 0, -3}, {0, 0, 0}), down, up, 0, 6, "the same ball does not bounce");
  ask(body(2, moments, {4, 1, -3}, {5, -2, 7}), down, up, 1, 12,
      "the ball flies askew and spins: without friction that makes no difference");
}

TEST_CASE("rod") {
  // 1 kg, 1 m, at 0.5 rad to the floor; its lower end is hit. About any axis across it I = 1/12.
  const Real c = std::cos(0.5), s = std::sin(0.5), fall = std::sqrt(2 * 9.81);
  Solid rod;
  rod.moments = {1e-3, 1.0 / 12, 1.0 / 12};
  rod.axes << c, 0, -s, 0, 1, 0, s, 0, c;
  rod.velocity.linear = {0, 0, -fall};
  const Vector3 arm(-c / 2, 0, -s / 2);
  for (const Real e : {0.0, 0.5, 1.0}) {
    ask(rod.moving(), arm, Vector3::UnitZ(), e, (1 + e) * fall / (1 + 3 * c * c),
        "a rod of 1 m and 1 kg has fallen 1 m and lands on its lower end, 0.5 rad to the floor");
  }
}

TEST_CASE("leaving") {
  const Vector3 x = Vector3::UnitX();
  const MovingBody slow = body(1, {1, 1, 1}, {-1, 0, 0}, {0, 0, 3});
  ask(slow, {-1, 1, 0}, x, 1, 4, "the upper end of a body that turns comes nearer: at 4 m/s");
  ask(slow, {-1, -1, 0}, x, 1, 0,
      "its lower end goes away at 2 m/s, although the body comes nearer");
  ask({{}, {{-1, 0, 0}, {0, 0, 0}}}, {-1, 0, 0}, x, 1, 0, "a body that cannot be moved either");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Hit hit = anyHit(random);
    const MovingBody body = hit.solid.moving();
    const Vector3 arm = hit.contact.armB, normal = hit.contact.normal;
    const Real e = hit.e;
    GRADE(bounce(hit, impulseWall(body, arm, normal, e)), e, within(1e-13, kRounding),
          given("body", body), given("arm", arm, "m"), given("normal", normal),
          given("restitution", e),
          about("the speed at which the point leaves the wall, over that at which it came"));
  }
}

TEST_CASE("refuses") {
  const MovingBody ball = body(1, {1, 1, 1}, {-1, 0, 0}, {0, 0, 0});
  GRADE_REFUSES(impulseWall(ball, {-1, 0, 0}, {1, 0, 0}, -0.5), given("restitution", -0.5));
  GRADE_REFUSES(impulseWall(ball, {-1, 0, 0}, {2, 0, 0}, 0.5), given("normal", Vector3(2, 0, 0)));
}

PROBES() {
  Random random(504);
  for (int n = 0; n < 16; ++n) {
    const Hit hit = anyHit(random);
    const Contact& c = hit.contact;
    PROBE(impulseWall(hit.solid.moving(), c.armB, c.normal, hit.e));
    MovingBody back = hit.solid.moving();
    back.velocity = {-back.velocity.linear, -back.velocity.angular};
    PROBE(impulseWall(back, c.armB, c.normal, hit.e));
  }
}

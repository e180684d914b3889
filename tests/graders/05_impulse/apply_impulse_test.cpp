// Grader of 05.apply_impulse: hits that are worked out by hand, bodies that lie askew, and the two
// sums that no impulse between two bodies can change.

#include "carom/impulse/apply_impulse.hpp"

#include <limits>

#include "graders/05_impulse/bodies.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

// What is asked about: one impulse between two bodies.
struct Hit {
  OrientedBody a, b;
  Vector3 armA = Vector3::Zero(), armB = Vector3::Zero(), impulse = Vector3::Zero();
};

using Velocities = std::array<Velocity, 2>;

// The velocities of A and B afterwards.
Velocities velocitiesAfter(Hit hit) {
  applyImpulse(hit.a, hit.armA, hit.b, hit.armB, hit.impulse);
  return {hit.a.velocity, hit.b.velocity};
}

template <class... More>
void ask(const Hit& hit, const Velocities& expected, Real tolerance, const More&... more) {
  GRADE(velocitiesAfter(hit), expected, within(tolerance, kRounding), given("a", hit.a),
        given("armA", hit.armA, "m"), given("b", hit.b), given("armB", hit.armB, "m"),
        given("impulse", hit.impulse, "N s"), unit("m/s, rad/s"), more...);
}

OrientedBody body(Real mass, const Vector3& moments, const Vector3& velocity) {
  OrientedBody made;
  made.inverseMass = 1 / mass;
  made.inverseInertia = moments.cwiseInverse().asDiagonal();
  made.velocity.linear = velocity;
  return made;
}

struct Pair {
  Solid a, b;
  Contact contact;
  Vector3 impulse = Vector3::Zero();

  Hit hit() const {
    return {a.oriented(), b.oriented(), contact.armA, contact.armB, impulse};
  }
};

Pair anyPair(Random& random) {
  Pair pair;
  pair.a = anySolid(random);
  pair.b = anySolid(random);
  pair.contact = anyContact(random);
  pair.impulse = random.vector(3);
  return pair;
}

// What the two bodies have together after the impulse: momentum, and angular momentum about the
// point where the impulse acts.
std::array<Vector3, 2> totals(const Pair& pair, const Velocities& v) {
  const Vector3 pA = pair.a.mass * v[0].linear, pB = pair.b.mass * v[1].linear;
  return {pA + pB, pair.a.inertia() * v[0].angular + pair.b.inertia() * v[1].angular -
                       cross(pair.contact.armA, pA) - cross(pair.contact.armB, pB)};
}

std::array<Vector3, 2> totalsAfter(const Pair& pair) {
  return totals(pair, velocitiesAfter(pair.hit()));
}

}  // namespace

TEST_CASE("pucks") {
  const Vector3 moments(0.1, 0.1, 0.2);
  Hit hit{body(1, moments, {3, 0, 0}),
          body(2, moments, {-1, 0, 0}),
          {0.5, 0, 0},
          {-0.5, 0, 0},
          {4, 0, 0}};
  ask(hit, {Velocity{{-1, 0, 0}, {0, 0, 0}}, Velocity{{1, 0, 0}, {0, 0, 0}}}, 1e-15,
      about("4 N s between a puck of 1 kg at 3 m/s and one of 2 kg at -1 m/s"));
  hit.a = OrientedBody{};
  ask(hit, {Velocity{}, Velocity{{1, 0, 0}, {0, 0, 0}}}, 1e-15, about("A is a wall"));
}

TEST_CASE("stick") {
  // 3 kg and 2 m along x: I = 1 kg m^2 across, and 1/8 kg m^2 along. The ball is hit through its
  // centre.
  const OrientedBody stick = body(3, {0.125, 1, 1}, {0, 0, 0});
  const OrientedBody ball = body(1, {0.1, 0.1, 0.1}, {0, 5, 0});
  ask({ball, stick, {0, 0.25, 0}, {0.8, 0, 0}, {0, 3, 0}},
      {Velocity{{0, 2, 0}, {0, 0, 0}}, Velocity{{0, 1, 0}, {0, 0, 2.4}}}, 4e-15,
      about("3 N s along y on a stick along x, 0.8 m beside its centre"));
  ask({stick, ball, {1, 0, 0.25}, {0, 0.25, 0}, {0, 3, 0}},
      {Velocity{{0, -1, 0}, {6, 0, -3}}, Velocity{{0, 8, 0}, {0, 0, 0}}}, 4e-15,
      about("the stick is A and is hit at its end, on its upper side"));
}

TEST_CASE("slanted") {
  // The same stick, turned by a quarter about y: its own x axis points down.
  OrientedBody stick = body(3, {0.125, 1, 1}, {0, 0, 0});
  stick.R_WB << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  const OrientedBody ball = body(1, {0.1, 0.1, 0.1}, {0, 5, 0});
  ask({ball, stick, {0, 0.25, 0}, {0.25, 0, -0.8}, {0, 3, 0}},
      {Velocity{{0, 2, 0}, {0, 0, 0}}, Velocity{{0, 1, 0}, {2.4, 0, 6}}}, 4e-15,
      about("an upright stick is hit 0.8 m below its centre, and 0.25 m beside its axis"));
  Random random(seed());
  for (int n = 0; n < 15; ++n) {
    const Pair pair = anyPair(random);
    ask(pair.hit(), after(pair.a, pair.b, pair.contact, pair.impulse), 1e-12,
        about("any bodies, lying askew"));
  }
}

TEST_CASE("kept") {
  Random random(seed() + 1);
  for (int n = 0; n < 10; ++n) {
    Pair pair = anyPair(random);
    GRADE(totalsAfter(pair), totals(pair, {pair.a.velocity, pair.b.velocity}),
          within(1e-13, kRounding), given("a", pair.hit().a), given("armA", pair.contact.armA, "m"),
          given("b", pair.hit().b), given("armB", pair.contact.armB, "m"),
          given("impulse", pair.impulse, "N s"), unit("kg m/s, kg m^2/s"),
          about("momentum and angular momentum of both bodies, as before the impulse"));
  }
  // To leave everything as it is keeps them too, and is no answer.
  const Pair pair = anyPair(random);
  ask(pair.hit(), after(pair.a, pair.b, pair.contact, pair.impulse), 1e-12,
      about("the impulse has done something"));
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const OrientedBody puck = body(1, {1, 1, 1}, {0, 0, 0});
  GRADE_REFUSES(velocitiesAfter({puck, puck, {1, 0, 0}, {-1, 0, 0}, {nan, 0, 0}}),
                given("impulse", Vector3(nan, 0, 0), "N s"));
}

PROBES() {
  Random random(506);
  for (int n = 0; n < 16; ++n) PROBE(velocitiesAfter(anyPair(random).hit()));
}

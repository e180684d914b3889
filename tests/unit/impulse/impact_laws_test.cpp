// Normal impulse and friction together: Newton with Coulomb, and the law that makes no energy.

#include <cmath>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/contact_equations.hpp"
#include "carom/impulse/contact_matrix.hpp"
#include "carom/impulse/coulomb_impact.hpp"
#include "carom/impulse/effective_mass.hpp"
#include "carom/impulse/impulse_3d.hpp"
#include "carom/impulse/passive_impact.hpp"
#include "carom/impulse/planar_to_spatial.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

// A body with its true mass and inertia beside the inverse ones, so that momenta can be weighed.
struct Weighed {
  Real mass = 1;
  Matrix3 inertia = Matrix3::Identity();
  MovingBody body;
};

Weighed randomBody(Random& random, Real decades) {
  Weighed w;
  MassProperties solid;
  solid.mass = std::pow(10, random.between(-decades, decades));
  solid.inertia = randomMoments(random, solid.mass, 1).asDiagonal();
  const Matrix3 R = randomRotation(random);
  w.mass = solid.mass;
  w.inertia = R * solid.inertia * R.transpose();
  w.body.mass = bodyMass(solid, R);
  w.body.velocity = {random.vector(3), random.vector(3)};
  return w;
}

Contact randomContact(Random& random) {
  Contact contact;
  contact.normal = random.direction();
  contact.armA = random.vector();
  contact.armB = random.vector();
  return contact;
}

Real energyOf(const Weighed& w) {
  const Velocity& v = w.body.velocity;
  return (w.mass * v.linear.squaredNorm() + v.angular.dot(w.inertia * v.angular)) / 2;
}

// About the contact: the centre of a body lies at minus its arm.
Vector3 angularMomentumOf(const Weighed& w, const Vector3& arm) {
  const Velocity& v = w.body.velocity;
  return w.inertia * v.angular - w.mass * cross(arm, v.linear);
}

using Law = Impact (*)(const MovingBody&, const MovingBody&, const Contact&, const ImpactLaw&);

}  // namespace

TEST_CASE("the contact matrix says what an impulse does to the relative velocity") {
  Random random(21);
  for (int i = 0; i < 500; ++i) {
    Weighed a = randomBody(random, 2), b = randomBody(random, 2);
    const Contact contact = randomContact(random);
    const Vector3 before = relativeVelocity(a.body, b.body, contact);
    const Matrix3 K = contactMatrix(a.body.mass, b.body.mass, contact);
    const Vector3 J = random.vector();
    const Real energy = energyOf(a) + energyOf(b);
    changeVelocities(a.body, b.body, contact, J);
    const Real size = (K * J).norm();
    INFO("seed 21, pair " << i);
    REQUIRE((relativeVelocity(a.body, b.body, contact) - before - K * J).norm() <
            1e-12 * (size + 10));
    REQUIRE(std::abs(energyOf(a) + energyOf(b) - energy - impactEnergyChange(K, before, J)) <
            1e-12 * (energy + size));
    REQUIRE(K == K.transpose());
    // Its diagonal holds the inverse effective masses.
    REQUIRE(std::abs(contact.normal.dot(K * contact.normal) *
                         effectiveMass(a.body.mass, b.body.mass, contact) -
                     1) < 1e-13);
  }
}

TEST_CASE("the equations of a contact are its matrix in other axes, with the normal eliminated") {
  Random random(22);
  for (int i = 0; i < 500; ++i) {
    const Weighed a = randomBody(random, 1), b = randomBody(random, 1);
    const Contact contact = randomContact(random);
    const ContactEquations eq = contactEquations(a.body, b.body, contact);
    Matrix3 axes;
    axes << eq.tangent1, eq.tangent2, eq.normal;
    REQUIRE((axes.transpose() * axes - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-15);
    REQUIRE((cross(eq.tangent1, eq.tangent2) - eq.normal).norm() < 1e-15);
    const Matrix3 K = axes.transpose() * contactMatrix(a.body.mass, b.body.mass, contact) * axes;
    const Real scale = K.cwiseAbs().maxCoeff();
    REQUIRE(std::abs(K(2, 2) - eq.inverseMass) < 1e-14 * scale);
    REQUIRE((Vector2(K(0, 2), K(1, 2)) - eq.inverseMass * eq.coupling).norm() < 1e-14 * scale);
    const Matrix2 whole = eq.tangential + eq.inverseMass * eq.coupling * eq.coupling.transpose();
    REQUIRE((whole - K.topLeftCorner<2, 2>()).cwiseAbs().maxCoeff() < 1e-13 * scale);
  }
}

TEST_CASE("a direction that cannot give way gets no impulse") {
  Matrix2 S;
  S << 1, 2, 2, 4;  // singular along (2, -1)
  const Vector2 x = solvePositive(S, {1, 2});
  CHECK((S * x - Vector2(1, 2)).norm() < 1e-15);
  CHECK(solvePositive(Matrix2::Zero(), {1, 1}) == Vector2(0, 0));
  // A door: it can only turn about its hinge, so a push along it does nothing.
  MovingBody door;
  door.mass.inverseInertia(2, 2) = 1;
  door.velocity.angular = {0, 0, 2};
  const Contact edge{{0, -1, 0}, {0, 0, 0}, {1, 0, 0}};  // the stop is A, at the edge
  const Impact impact = passiveImpact({}, door, edge, {.restitution = 0.5, .friction = 1});
  CHECK((impact.impulse - Vector3(0, -3, 0)).norm() < 1e-15);
}

TEST_CASE("ten thousand random impacts keep momentum and angular momentum and make no energy") {
  // Masses over twelve decades, any inertia, friction from none to rubber, any restitution.
  Random random(1998);
  int hits = 0, sliding = 0;
  Real worstMomentum = 0, worstAngular = 0, worstVelocity = 0, worstEnergy = -1;
  while (hits < 10000) {
    Weighed a = randomBody(random, 6), b = randomBody(random, 6);
    if (random.integer(0, 9) == 0) {  // a wall
      a.body = MovingBody{};
    }
    const Contact contact = randomContact(random);
    const ImpactLaw law{random.between(0, 1), random.between(0, 2), random.between(-1, 1)};
    const Vector3 u = relativeVelocity(a.body, b.body, contact);
    if (u.dot(contact.normal) >= 0) continue;
    ++hits;
    const bool wall = a.body.mass.inverseMass == 0;
    const auto momentum = [&] {
      return Vector3(a.mass * a.body.velocity.linear + b.mass * b.body.velocity.linear);
    };
    const auto angular = [&] {
      return Vector3(angularMomentumOf(a, contact.armA) + angularMomentumOf(b, contact.armB));
    };
    const Real larger =
        std::max(a.mass * a.body.velocity.linear.norm(), b.mass * b.body.velocity.linear.norm());
    const Real largerAngular = std::max(angularMomentumOf(a, contact.armA).norm(),
                                        angularMomentumOf(b, contact.armB).norm());
    const Vector3 p = momentum(), L = angular();
    const Real energy = energyOf(b) + (wall ? 0 : energyOf(a));

    const Impact impact = passiveImpact(a.body, b.body, contact, law);
    changeVelocities(a.body, b.body, contact, impact.impulse);
    if (impact.motion == ContactMotion::slides) ++sliding;

    if (!wall) {
      worstMomentum = std::max(worstMomentum, (momentum() - p).norm() / larger);
      worstAngular = std::max(worstAngular, (angular() - L).norm() / largerAngular);
    }
    const Real after = energyOf(b) + (wall ? 0 : energyOf(a));
    worstEnergy = std::max(worstEnergy, (after - energy) / energy);
    const Real asked = -law.restitution * u.dot(contact.normal);
    const Real got = relativeVelocity(a.body, b.body, contact).dot(contact.normal);
    worstVelocity = std::max(worstVelocity, std::abs(got - asked) / u.norm());

    const Real jn = impact.impulse.dot(contact.normal);
    const Real jt = (impact.impulse - jn * contact.normal).norm();
    INFO("seed 1998, impact " << hits);
    REQUIRE(jn >= 0);
    REQUIRE(jt <= law.friction * jn * (1 + 1e-12) + 1e-14 * jn);
  }
  INFO("momentum " << worstMomentum << ", angular " << worstAngular << ", velocity "
                   << worstVelocity << ", energy " << worstEnergy);
  CHECK(worstMomentum < 1e-12);
  CHECK(worstAngular < 1e-12);
  CHECK(worstVelocity < 1e-12);
  CHECK(worstEnergy < 1e-12);
  CHECK(sliding > 1000);
  CHECK(sliding < 9000);
}

TEST_CASE("Newton with Coulomb: normal velocity, cone, and friction against the slip at the end") {
  Random random(40);
  int sliding = 0, sticking = 0;
  for (int i = 0; i < 10000; ++i) {
    Weighed a = randomBody(random, 3), b = randomBody(random, 3);
    const Contact contact = randomContact(random);
    const ImpactLaw law{.restitution = random.between(0, 1), .friction = random.between(0, 2)};
    const Vector3 u = relativeVelocity(a.body, b.body, contact);
    const Impact impact = coulombImpact(a.body, b.body, contact, law);
    const Vector3& n = contact.normal;
    if (u.dot(n) >= 0) {
      REQUIRE(impact.motion == ContactMotion::none);
      continue;
    }
    changeVelocities(a.body, b.body, contact, impact.impulse);
    const Vector3 after = relativeVelocity(a.body, b.body, contact);
    const Real scale = 1e-11 * u.norm();
    INFO("seed 40, impact " << i);
    REQUIRE(std::abs(after.dot(n) + law.restitution * u.dot(n)) < scale);
    const Real jn = impact.impulse.dot(n);
    const Vector3 jt = impact.impulse - jn * n;
    const Vector3 slip = after - after.dot(n) * n;
    REQUIRE(jn > 0);
    if (impact.motion == ContactMotion::sticks) {
      ++sticking;
      REQUIRE(jt.norm() <= law.friction * jn * (1 + 1e-12));
      REQUIRE(slip.norm() < scale);
    } else {
      ++sliding;
      REQUIRE(std::abs(jt.norm() - law.friction * jn) < 1e-12 * jn);
      // Parallel and against: jt . slip = -|jt| |slip|.
      REQUIRE(jt.dot(slip) <= 1e-12 * jt.norm() * u.norm());
      REQUIRE(cross(jt, slip).norm() < 1e-10 * jt.norm() * u.norm());
    }
  }
  CHECK(sliding > 1000);
  CHECK(sticking > 1000);
}

TEST_CASE("without friction both laws are the normal impulse") {
  Random random(41);
  for (int i = 0; i < 300; ++i) {
    const Weighed a = randomBody(random, 1), b = randomBody(random, 1);
    const Contact contact = randomContact(random);
    const Vector3 J = impulse3d(a.body, b.body, contact, 0.6) * contact.normal;
    for (const Law law : {Law(coulombImpact), Law(passiveImpact)}) {
      const Impact impact = law(a.body, b.body, contact, {.restitution = 0.6});
      REQUIRE((impact.impulse - J).norm() <= 1e-14 * J.norm());
    }
  }
}

TEST_CASE("two balls: both laws agree, for there the directions are not coupled") {
  Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const auto ball = [&random](Real mass, Real radius) {
      MovingBody body;
      body.mass = {1 / mass, 2.5 / (mass * radius * radius) * Matrix3::Identity()};
      body.velocity = {random.vector(2), random.vector(2)};
      return body;
    };
    const MovingBody a = ball(1, 0.5), b = ball(3, 1);
    const Vector3 n = random.direction();
    const Contact contact{n, 0.5 * n, -1 * n};
    const ImpactLaw law{.restitution = random.between(0, 1), .friction = random.between(0, 0.6)};
    const Impact one = coulombImpact(a, b, contact, law);
    const Impact other = passiveImpact(a, b, contact, law);
    REQUIRE((one.impulse - other.impulse).norm() < 1e-13);
    REQUIRE(one.motion == other.motion);
  }
}

TEST_CASE("planar impacts are spatial ones seen from above, under both laws") {
  Random random(43);
  for (int i = 0; i < 2000; ++i) {
    const auto body = [&random](Real mass) {
      return PlanarBody{planarBodyMass(mass, mass * random.between(0.1, 1)),
                        {{random.between(-1, 1), random.between(-1, 1)}, random.between(-3, 3)}};
    };
    const PlanarBody a = body(2), b = body(0.5);
    const Real angle = random.between(-3, 3);
    const PlanarContact contact{{std::cos(angle), std::sin(angle)},
                                {random.between(-1, 1), random.between(-1, 1)},
                                {random.between(-1, 1), random.between(-1, 1)}};
    const Contact above = inSpace(contact);
    const ImpactLaw law{.restitution = random.between(0, 1), .friction = random.between(0, 2)};
    INFO("seed 43, impact " << i);
    const Vector3 spatial = passiveImpact(inSpace(a), inSpace(b), above, law).impulse;
    const Vector2 planar = passiveImpact(a, b, contact, law).impulse;
    REQUIRE((inSpace(planar) - spatial).norm() < 1e-13 * (1 + planar.norm()));
    const Vector3 newton = coulombImpact(inSpace(a), inSpace(b), above, law).impulse;
    const Vector2 flat = coulombImpact(a, b, contact, law).impulse;
    REQUIRE((inSpace(flat) - newton).norm() < 1e-11 * (1 + flat.norm()));
    // And back: what the impulse does in space lies in the plane.
    MovingBody liftedA = inSpace(a), liftedB = inSpace(b);
    PlanarBody flatA = a, flatB = b;
    changeVelocities(liftedA, liftedB, above, spatial);
    changeVelocities(flatA, flatB, contact, planar);
    const PlanarVelocity back = inPlane(liftedB.velocity);
    REQUIRE((back.linear - flatB.velocity.linear).norm() < 1e-12);
    REQUIRE(std::abs(back.angular - flatB.velocity.angular) < 1e-11);
    REQUIRE(std::abs(liftedB.velocity.linear.z()) < 1e-15);
  }
}

TEST_CASE(
    "Newton's restitution with Coulomb's friction can make energy; the passive law does not") {
  // A rod of 1 kg and 2 m meets the floor with its lower end, which slides backwards: friction
  // turns the rod so that its end is pressed down harder, and all of that comes back.
  const auto change = [](Real angle, const PlanarVelocity& velocity, const ImpactLaw& law,
                         auto rule) {
    const PlanarBody rod{planarBodyMass(1, 1.0 / 3), velocity};
    const PlanarContact floor{{0, 1}, {0, 0}, {-std::cos(angle), -std::sin(angle)}};
    const Matrix2 K = contactMatrix(PlanarBodyMass{}, rod.mass, floor);
    const Vector2 u = relativeVelocity(PlanarBody{}, rod, floor);
    return impactEnergyChange(K, u, rule(PlanarBody{}, rod, floor, law).impulse);
  };
  using PlanarLaw = PlanarImpact (*)(const PlanarBody&, const PlanarBody&, const PlanarContact&,
                                     const ImpactLaw&);
  const PlanarLaw newton = coulombImpact, passive = passiveImpact;
  const PlanarVelocity tumbling{{0.3, -1}, 2};  // 1.21 J
  const ImpactLaw lossless{.restitution = 1, .friction = 0.4};
  CHECK(std::abs(change(0.8, tumbling, lossless, newton) - 0.6323844078654233) < 1e-14);
  CHECK(change(0.8, tumbling, lossless, passive) < -0.01);

  // Among random impacts of rods it is no rare thing.
  Random random(1985);
  int made = 0;
  for (int i = 0; i < 5000; ++i) {
    const Real angle = random.between(0.2, 1.5);
    const PlanarVelocity velocity{{random.between(-3, 3), random.between(-2, 0)},
                                  random.between(-2, 2)};
    const ImpactLaw law{.restitution = random.between(0.5, 1), .friction = random.between(0, 1)};
    made += change(angle, velocity, law, newton) > 1e-9;
    REQUIRE(change(angle, velocity, law, passive) < 1e-14);
  }
  INFO(made << " of 5000 made energy");
  CHECK(made > 100);
}

TEST_CASE("laws refuse coefficients that take energy from nowhere") {
  const MovingBody body{{1, Matrix3::Identity()}, {{0, 0, -1}, {0, 0, 0}}};
  for (const Law law : {Law(coulombImpact), Law(passiveImpact)}) {
    CHECK_THROWS_WITH(law({}, body, Contact{}, {.restitution = 1.5}),
                      ContainsSubstring("restitution = 1.5"));
    CHECK_THROWS_WITH(law({}, body, Contact{}, {.friction = -0.5}),
                      ContainsSubstring("friction = -0.5"));
    CHECK_THROWS_WITH(law({}, body, Contact{}, {.tangentialRestitution = 2}),
                      ContainsSubstring("tangentialRestitution = 2"));
    CHECK(law({}, {}, Contact{}, {}).motion == ContactMotion::none);  // neither can be moved
  }
}

// Bodies, contacts, velocities of points, Euler's equation, and drag.

#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/impulse/angular_acceleration.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/drag_force.hpp"
#include "carom/impulse/planar_motion.hpp"
#include "carom/impulse/point_velocity.hpp"
#include "carom/impulse/positive_solve.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

MassProperties solid(Real mass, const Vector3& moments) {
  MassProperties body;
  body.mass = mass;
  body.inertia = moments.asDiagonal();
  return body;
}
}  // namespace

TEST_CASE("a body's inverse inertia is turned into the world with it") {
  Matrix3 R;  // a quarter turn about z: the body's x axis lies along the world's y axis
  R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const BodyMass mass = bodyMass(solid(2, {1, 2, 4}), R);
  CHECK(mass.inverseMass == 0.5);
  CHECK(mass.inverseInertia == Matrix3(Vector3(0.5, 1, 0.25).asDiagonal()));
  const OrientedBody body = orientedBody(solid(2, {1, 2, 4}), R, {});
  CHECK(body.inverseInertia == Matrix3(Vector3(1, 0.5, 0.25).asDiagonal()));
  CHECK(massInWorld(body).inverseInertia == mass.inverseInertia);
}

TEST_CASE("inertia and inverse inertia multiply to one, over 24 decades and in any direction") {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const Real mass = std::pow(10, random.between(-12, 12));
    const Matrix3 R = randomRotation(random);
    MassProperties body = solid(mass, {0, 0, 0});
    body.inertia = R * Matrix3(randomMoments(random, mass, 2).asDiagonal()) * R.transpose();
    const BodyMass inverse = bodyMass(body, Matrix3::Identity());
    const Matrix3 one = inverse.inverseInertia * body.inertia;
    INFO("seed 11, body " << i);
    REQUIRE((one - Matrix3::Identity()).cwiseAbs().maxCoeff() < 1e-12);
    REQUIRE(inverse.inverseInertia == inverse.inverseInertia.transpose());
  }
}

TEST_CASE("a body that cannot be is refused") {
  const Matrix3 E = Matrix3::Identity();
  CHECK_THROWS_WITH(bodyMass(solid(-2, {1, 1, 1}), E), ContainsSubstring("mass = -2 must be"));
  CHECK_THROWS_AS(bodyMass(solid(0, {1, 1, 1}), E), InvalidInput);
  CHECK_THROWS_AS(bodyMass(solid(kNan, {1, 1, 1}), E), InvalidInput);
  CHECK_THROWS_WITH(bodyMass(solid(1, {1, 1, kNan}), E), ContainsSubstring("inertia"));
  CHECK_THROWS_WITH(bodyMass(solid(1, {1, -1, 1}), E), ContainsSubstring("positive definite"));
  CHECK_THROWS_WITH(bodyMass(solid(1, {1, 1, 0}), E), ContainsSubstring("positive definite"));
  MassProperties crooked = solid(1, {1, 1, 1});
  crooked.inertia(0, 1) = 0.5;
  CHECK_THROWS_WITH(bodyMass(crooked, E), ContainsSubstring("symmetric"));
  CHECK_THROWS_AS(orientedBody(crooked, E, {}), InvalidInput);
  CHECK_THROWS_AS(orientedBody(solid(1, {1, 1, 1}), E, {{kNan, 0, 0}, {0, 0, 0}}), InvalidInput);
  CHECK_THROWS_AS(planarBodyMass(1, 0), InvalidInput);
  CHECK_THROWS_AS(planarBodyMass(1e-320, 1), InvalidInput);  // its inverse is no double
  CHECK(planarBodyMass(4, 8).inverseInertia == 0.125);
}

TEST_CASE("contacts and bodies with impossible numbers are refused") {
  CHECK_THROWS_WITH(requireUsable(Contact{{0, 0, 2}, {0, 0, 0}, {0, 0, 0}}),
                    ContainsSubstring("length one"));
  CHECK_THROWS_WITH(requireUsable(PlanarContact{{1, 1}, {0, 0}, {0, 0}}),
                    ContainsSubstring("(1, 1) must have length one"));
  CHECK_THROWS_AS(requireUsable(Contact{{0, 0, 1}, {kNan, 0, 0}, {0, 0, 0}}), InvalidInput);
  MovingBody body;
  body.mass.inverseMass = -1;
  CHECK_THROWS_WITH(requireUsable(body, "b"), ContainsSubstring("b.mass.inverseMass = -1"));
  PlanarBody planar;
  planar.velocity.angular = kNan;
  CHECK_THROWS_WITH(requireUsable(planar, "a"), ContainsSubstring("a.velocity.angular"));
  CHECK_THROWS_WITH(requireRestitution(1.6), ContainsSubstring("1.6 must be from 0 to 1"));
  CHECK_THROWS_AS(requireRestitution(kNan), InvalidInput);
}

TEST_CASE("three equations with a positive matrix are solved, and others are noticed") {
  Matrix3 m;
  m << 4, 2, -2, 2, 10, 4, -2, 4, 9;
  const PositiveSolve solver(m);
  REQUIRE(solver.positive());
  CHECK((solver.solve(m * Vector3(1, -2, 3)) - Vector3(1, -2, 3)).norm() < 1e-14);
  CHECK((solver.inverse() * m - Matrix3::Identity()).norm() < 1e-15);
  m(2, 2) = 1;
  CHECK_FALSE(PositiveSolve(m).positive());
}

TEST_CASE("a point of a turning body moves with its centre and about it") {
  // A wheel that rolls to the right turns clockwise: its lowest point stands still.
  const Velocity wheel{{3, 0, 0}, {0, 6, 0}};
  CHECK(pointVelocity(wheel, {0, 0, -0.5}) == Vector3(0, 0, 0));
  CHECK(pointVelocity(wheel, {0, 0, 0.5}) == Vector3(6, 0, 0));
  CHECK(pointVelocity(wheel, {0, 7, 0}) == Vector3(3, 0, 0));  // on the axis
  // A quarter turn of axis and arm: z turns x into y.
  CHECK(pointVelocity({{0, 0, 0}, {0, 0, 2}}, {1, 0, 0}) == Vector3(0, 2, 0));
}

TEST_CASE("in the plane a point moves as it does in space") {
  const PlanarVelocity planar{{1, -2}, 3};
  const Velocity spatial{{1, -2, 0}, {0, 0, 3}};
  const Vector3 v = pointVelocity(spatial, {0.5, 4, 0});
  CHECK(planarPointVelocity(planar, {0.5, 4}) == Vector2(v.x(), v.y()));
  CHECK(planarCross({1, 2}, {3, 5}) == -1);
}

TEST_CASE("two points of a rigid body do not come nearer") {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Velocity body{random.vector(), random.vector()};
    const Vector3 p = random.vector(), q = random.vector();
    const Vector3 u = pointVelocity(body, p) - pointVelocity(body, q);
    REQUIRE(std::abs(u.dot(p - q)) < 1e-14);
  }
}

TEST_CASE("a body that turns about a principal axis keeps turning about it") {
  const Matrix3 inertia = Vector3(1, 2, 3).asDiagonal();
  CHECK(angularAcceleration(inertia, {0, 5, 0}, {0, 0, 0}) == Vector3(0, 0, 0));
  CHECK(angularAcceleration(inertia, {0, 0, 0}, {2, 2, 6}) == Vector3(2, 1, 2));
}

TEST_CASE("Euler's equations along principal axes, with the gyroscopic term's sign") {
  // I1 w1' = (I2 - I3) w2 w3 and round; w = (1, 2, 3), I = (1, 2, 4).
  const Matrix3 inertia = Vector3(1, 2, 4).asDiagonal();
  const Vector3 a = angularAcceleration(inertia, {1, 2, 3}, {0, 0, 0});
  CHECK(a == Vector3(-12, 4.5, -0.5));
}

TEST_CASE("without torque neither energy nor angular momentum changes at first order") {
  Random random(16);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3 R = randomRotation(random);
    const Matrix3 inertia = R * Matrix3(randomMoments(random, 3, 1).asDiagonal()) * R.transpose();
    const Vector3 w = random.vector(4);
    const Vector3 a = angularAcceleration(inertia, w, {0, 0, 0});
    REQUIRE(std::abs(w.dot(inertia * a)) < 1e-11);                  // dK/dt
    REQUIRE((inertia * a + cross(w, inertia * w)).norm() < 1e-11);  // dL/dt in space
    // A torque along the acceleration it makes: the equation is linear in the torque.
    const Vector3 torque = random.vector(2);
    const Vector3 both = angularAcceleration(inertia, w, torque);
    REQUIRE((inertia * (both - a) - torque).norm() < 1e-12);
  }
  CHECK_THROWS_WITH(angularAcceleration(Matrix3::Zero(), {1, 0, 0}, {0, 0, 0}),
                    ContainsSubstring("positive definite"));
}

TEST_CASE("drag points against the motion through the air, and grows with its square") {
  const AirDrag air{.density = 1.2, .coefficient = 0.5, .area = 2};
  const Vector3 slow = dragForce({0, 0, 3}, air);
  CHECK(near(slow.z(), -0.6 * 9));
  CHECK(slow.x() == 0);
  CHECK(near(dragForce({0, 0, -3}, air).z(), 0.6 * 9));  // erratum 6.10: v |v|, not v^2
  CHECK(near(dragForce({0, 0, 6}, air).z(), 4 * slow.z()));
  // Its power is never positive in still air.
  CHECK(dragForce({1, -2, 3}, air).dot(Vector3(1, -2, 3)) < 0);
}

TEST_CASE("the wind pushes a body at rest, and lets one be that flies with it") {
  const AirDrag air{.wind = {4, 0, 0}, .density = 1, .coefficient = 1, .area = 1};
  CHECK(dragForce({0, 0, 0}, air) == Vector3(8, 0, 0));
  CHECK(dragForce({4, 0, 0}, air) == Vector3(0, 0, 0));
  CHECK_THROWS_WITH(dragForce({0, 0, 0}, AirDrag{.area = -1}), ContainsSubstring("area = -1"));
  CHECK_THROWS_AS(dragForce({kNan, 0, 0}, air), InvalidInput);
}

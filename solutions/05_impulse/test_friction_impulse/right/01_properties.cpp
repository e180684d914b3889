// Nothing is computed a second time: whatever the contact, Coulomb's law has four consequences.
#include <cmath>
#include <random>

#include "carom/impulse/friction_impulse.hpp"
#include "support/catch.hpp"

using carom::Real;
using carom::Vector3;

TEST_CASE("any friction is across the normal, against the slip, in the cone, and stops or slides") {
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> number(-1, 1);
  for (int i = 0; i < 200; ++i) {
    Vector3 normal;
    Vector3 velocity;
    for (int k = 0; k < 3; ++k) normal(k) = number(random);
    normal.normalize();
    for (int k = 0; k < 3; ++k) velocity(k) = 3 * number(random);
    const Real pressure = 2 + number(random);
    const Real mu = 1 + number(random);
    const Real mass = 1.5 + number(random);
    CAPTURE(normal.transpose(), velocity.transpose(), pressure, mu, mass);
    const Vector3 impulse = carom::frictionImpulse(velocity, normal, pressure, mu, mass);
    const Vector3 slip = velocity - velocity.dot(normal) * normal;
    const Vector3 after = slip + impulse / mass;
    constexpr Real kRounding = 1e-12;
    CHECK(std::abs(impulse.dot(normal)) <= kRounding);
    CHECK(impulse.norm() <= mu * pressure + kRounding);
    CHECK(after.dot(slip) >= -kRounding);
    const bool stops = after.norm() <= kRounding;
    const bool slides = std::abs(impulse.norm() - mu * pressure) <= kRounding;
    CHECK((stops || slides));
    CHECK(impulse.dot(slip) <= kRounding);
  }
}

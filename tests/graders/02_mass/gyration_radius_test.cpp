// Grader of 02.gyration_radius: a ball, axes between principal ones, and bodies made of a few
// points whose distances from the axis can be measured one by one.

#include "gyration_radius.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a dozen roundings";

MassProperties bodyWith(Real mass, const Vector3& moments) {
  MassProperties body;
  body.mass = mass;
  body.inertia.diagonal() = moments;
  return body;
}

// Points of equal mass about their common centre: the body, and its k by measuring every distance.
struct Cloud {
  std::vector<Vector3> points;
  Real mass = 0;

  MassProperties body() const {
    MassProperties whole;
    for (const Vector3& p : points) {
      const Matrix3 square = p * p.transpose();
      whole.inertia += mass * (p.squaredNorm() * Matrix3::Identity() - square);
      whole.mass += mass;
    }
    return whole;
  }
  Real rootMeanSquareDistance(const Vector3& axis) const {
    Real sum = 0;
    for (const Vector3& p : points) sum += cross(axis, p).squaredNorm() / axis.squaredNorm();
    return std::sqrt(sum / static_cast<Real>(points.size()));
  }
};

Cloud anyCloud(Random& random) {
  Cloud cloud;
  cloud.mass = random.between(0.2, 3);
  for (int n = 0; n < 4; ++n) {
    const Vector3 p = random.vector(2);
    cloud.points.push_back(p);
    cloud.points.push_back(-p);
  }
  return cloud;
}

}  // namespace

TEST_CASE("ball") {
  Random random(seed());
  for (int n = 0; n < 10; ++n) {
    const Real mass = random.between(0.5, 20);
    const Real radius = random.between(0.2, 2);
    const MassProperties ball = bodyWith(mass, Vector3::Constant(0.4 * mass * radius * radius));
    const Vector3 axis = random.direction();
    GRADE(gyrationRadius(ball, axis), radius * std::sqrt(0.4), withinRelative(1e-14, kRounding),
          given("a ball of radius", radius, "m"), given("and mass", mass, "kg"),
          given("axis", axis), unit("m"));
  }
}

TEST_CASE("skew") {
  const MassProperties body = bodyWith(1, {1, 2, 3});
  GRADE(gyrationRadius(body, Vector3(1, 1, 0) / std::sqrt(Real(2))), std::sqrt(1.5),
        within(1e-15, kRounding), given("moments", Vector3(1, 2, 3), "kg m^2"),
        given("mass", 1.0, "kg"), given("axis", "(1, 1, 0) / sqrt(2)"), unit("m"),
        about("half of each of the two moments 1 and 2"));
  GRADE(gyrationRadius(body, {0.6, 0, 0.8}), std::sqrt(0.36 * 1 + 0.64 * 3),
        within(1e-15, kRounding), given("moments", Vector3(1, 2, 3), "kg m^2"),
        given("mass", 1.0, "kg"), given("axis", Vector3(0.6, 0, 0.8)), unit("m"));
  GRADE(gyrationRadius(bodyWith(4, {4, 8, 10}), {0, 0.8, -0.6}), std::sqrt(0.64 * 2 + 0.36 * 2.5),
        within(1e-15, kRounding), given("moments", Vector3(4, 8, 10), "kg m^2"),
        given("mass", 4.0, "kg"), given("axis", Vector3(0, 0.8, -0.6)), unit("m"));
}

TEST_CASE("any_length") {
  const MassProperties body = bodyWith(2, {2, 4.5, 6});
  for (const Real length : {0.001, 2.0, 1000.0}) {
    GRADE(gyrationRadius(body, {0, length, 0}), 1.5, within(2e-15, kRounding),
          given("moments", Vector3(2, 4.5, 6), "kg m^2"), given("mass", 2.0, "kg"),
          given("axis", Vector3(0, length, 0)), unit("m"));
  }
}

TEST_CASE("parts") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Cloud cloud = anyCloud(random);
    const Vector3 axis = random.direction() * random.between(0.5, 3);
    GRADE(gyrationRadius(cloud.body(), axis), cloud.rootMeanSquareDistance(axis),
          withinRelative(1e-13, kRounding),
          given("eight equal masses, inertia", cloud.body().inertia, "kg m^2"),
          given("mass of all", cloud.body().mass, "kg"), given("axis", axis), unit("m"),
          about("k is the root of the mean squared distance of the masses from the axis"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(gyrationRadius(bodyWith(1, {1, 1, 1}), {0, 0, 0}), given("axis", Vector3(0, 0, 0)));
  GRADE_REFUSES(gyrationRadius(bodyWith(0, {1, 1, 1}), {0, 0, 1}), given("mass", 0.0, "kg"));
}

PROBES() {
  Random random(29);
  for (int n = 0; n < 20; ++n) {
    const MassProperties body = anyCloud(random).body();
    const Vector3 axis = random.direction() * random.between(0.5, 3);
    PROBE(gyrationRadius(body, axis));
  }
}

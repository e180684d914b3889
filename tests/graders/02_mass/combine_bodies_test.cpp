// Grader of 02.combine_bodies: dumbbells, boxes cut in two, and a cube with a hollow, all with
// closed forms of the whole.

#include "carom/mass/combine_bodies.hpp"

#include <array>

#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "some dozens of roundings of numbers of this size";

Matrix3 diagonal(Real xx, Real yy, Real zz) {
  return Vector3(xx, yy, zz).asDiagonal();
}

// A box with its faces along the axes, by the closed form.
MassProperties box(const Vector3& low, const Vector3& high, Real density) {
  const Vector3 size = high - low;
  MassProperties body;
  body.volume = size.prod();
  body.mass = density * body.volume;
  body.center = (low + high) / 2;
  const Vector3 q = size.cwiseProduct(size) * body.mass / 12;
  body.inertia = diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
  return body;
}

MassProperties ball(Real mass, Real radius, const Vector3& center, Real volume) {
  return {volume, mass, center, diagonal(1, 1, 1) * (0.4 * mass * radius * radius)};
}

}  // namespace

TEST_CASE("centre") {
  // The volumes are not those of the masses: a light large part and a heavy small one.
  const std::array parts = {ball(1, 0.5, {0, 0, 0}, 2), ball(3, 0.5, {4, 0, 0}, 0.5)};
  GRADE(combineBodies(parts).center, Vector3(3, 0, 0), within(1e-14, kRounding),
        given("parts", parts), unit("m"), about("3 kg pull three times as much as 1 kg"));
  GRADE(combineBodies(parts).mass, 4.0, within(1e-14, kRounding), given("parts", parts),
        unit("kg"));
  GRADE(combineBodies(parts).volume, 2.5, within(1e-14, kRounding), given("parts", parts),
        unit("m^3"));
}

TEST_CASE("dumbbell") {
  // Reduced mass 3/4 kg, distance 4 m: 12 kg m² across; 0.4 (1 + 3) 0.25 = 0.4 from the balls.
  const std::array parts = {ball(1, 0.5, {-1, 2, 0}, 1), ball(3, 0.5, {3, 2, 0}, 3)};
  GRADE(combineBodies(parts).inertia, diagonal(0.4, 12.4, 12.4), within(1e-13, kRounding),
        given("parts", parts), unit("kg m^2"),
        about("a dumbbell of 1 kg and 3 kg, 4 m apart along x"));
  Matrix3 skew;
  skew << 2.4, -2, 0, -2, 2.4, 0, 0, 0, 4.4;
  const std::array equal = {ball(1, 0.5, {-1, -1, 5}, 1), ball(1, 0.5, {1, 1, 5}, 1)};
  GRADE(combineBodies(equal).inertia, Matrix3(skew - 0.2 * Matrix3::Identity()),
        within(1e-13, kRounding), given("parts", equal), unit("kg m^2"),
        about("two balls of 1 kg on the diagonal of the plane"));
}

TEST_CASE("cut") {
  Random random(seed());
  for (int n = 0; n < 15; ++n) {
    const Vector3 low = random.vector(3);
    const Vector3 high = low + Vector3(1.5, 1.5, 1.5) + random.vector();
    const Real density = random.between(0.5, 3);
    const int axis = random.integer(0, 2);
    const Real cut = low[axis] + random.between(0.1, 0.9) * (high[axis] - low[axis]);
    Vector3 highOfFirst = high;
    Vector3 lowOfSecond = low;
    highOfFirst[axis] = lowOfSecond[axis] = cut;
    const std::array parts = {box(low, highOfFirst, density), box(lowOfSecond, high, density)};
    GRADE(combineBodies(parts), box(low, high, density), within(1e-11, kRounding),
          given("parts", parts), unit("m^3, kg, m, kg m^2"), about("a box cut in two pieces"));
  }
}

TEST_CASE("hole") {
  // The cube [-1,1]³ without the cube [-1/2,1/2]³.
  MassProperties hole = box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 1);
  hole.volume *= -1;
  hole.mass *= -1;
  hole.inertia *= -1;
  const std::array hollow = {box({-1, -1, -1}, {1, 1, 1}, 1), hole};
  const MassProperties expected = {7, 7, Vector3::Zero(), diagonal(31, 31, 31) / 6};
  GRADE(combineBodies(hollow), expected, within(1e-13, kRounding), given("parts", hollow),
        unit("m^3, kg, m, kg m^2"), about("a cube with a hollow"));
  hole.center.x() = 0.5;
  const std::array offCenter = {box({-1, -1, -1}, {1, 1, 1}, 1), hole};
  GRADE(combineBodies(offCenter).center, Vector3(-0.5 / 7, 0, 0), within(1e-14, kRounding),
        given("parts", offCenter), unit("m"),
        about("the hollow at the side moves the centre away"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(combineBodies({}), given("parts", "none"));
  const std::array nothing = {ball(1, 0.5, {0, 0, 0}, 1), ball(-1, 0.5, {0, 0, 0}, -1)};
  GRADE_REFUSES(combineBodies(nothing), given("parts", nothing));
}

PROBES() {
  Random random(26);
  for (int n = 0; n < 16; ++n) {
    std::vector<MassProperties> parts;
    for (int i = 0; i < 3; ++i) {
      const Vector3 low = random.vector(2);
      parts.push_back(
          box(low, low + Vector3(1.5, 1.5, 1.5) + random.vector(), random.between(1, 4)));
    }
    parts.push_back(ball(-0.1, 0.2, random.vector(), -0.1));
    PROBE(combineBodies(parts));
  }
}

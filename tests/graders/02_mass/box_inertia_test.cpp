// Grader of 02.box_inertia: three boxes by hand, and the rule that two halves make a whole, which
// fixes the factor.

#include "carom/mass/box_inertia.hpp"

#include <limits>

#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "half a dozen roundings";

Matrix3 diagonal(Real xx, Real yy, Real zz) {
  return Vector3(xx, yy, zz).asDiagonal();
}

}  // namespace

TEST_CASE("box") {
  GRADE(boxInertia(6, {1, 2, 3}), diagonal(6.5, 5, 2.5), within(4e-15, kRounding),
        given("mass", 6.0, "kg"), given("size", Vector3(1, 2, 3), "m"), unit("kg m^2"));
  GRADE(boxInertia(12, {2, 2, 2}), diagonal(8, 8, 8), within(4e-15, kRounding),
        given("mass", 12.0, "kg"), given("size", Vector3(2, 2, 2), "m"), unit("kg m^2"));
}

TEST_CASE("rod") {
  // A rod of 3 m and 4 kg, thin as a hair: m l²/12 across, nothing along.
  const Real thin = 1e-6;
  GRADE(boxInertia(4, {3, thin, thin}), diagonal(0, 3, 3),
        within(1e-11, "the thickness adds 7e-13"), given("mass", 4.0, "kg"),
        given("size", Vector3(3, thin, thin), "m"), unit("kg m^2"));
  GRADE(boxInertia(4, {thin, thin, 3}), diagonal(3, 3, 0),
        within(1e-11, "the thickness adds 7e-13"), given("mass", 4.0, "kg"),
        given("size", Vector3(thin, thin, 3), "m"), unit("kg m^2"));
}

TEST_CASE("halves") {
  // Cut across x: each half has its centre a quarter of the edge away, which adds m d² to y and z.
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Real mass = random.between(0.5, 5);
    const Vector3 size = Vector3(1.5, 1.5, 1.5) + random.vector();
    const Vector3 halfSize(size.x() / 2, size.y(), size.z());
    const Real shift = mass * size.x() * size.x() / 16;
    GRADE(
        Matrix3(boxInertia(mass, size) - 2 * boxInertia(mass / 2, halfSize)),
        diagonal(0, shift, shift), within(1e-13, kRounding), given("mass", mass, "kg"),
        given("size", size, "m"), unit("kg m^2"),
        about(
            "the whole minus its two halves, cut across x, is m (size.x/4)² for the axes y and z"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(boxInertia(0, {1, 1, 1}), given("mass", 0.0, "kg"));
  GRADE_REFUSES(boxInertia(1, {1, -1, 1}), given("size", Vector3(1, -1, 1), "m"));
  const Real infinity = std::numeric_limits<Real>::infinity();
  GRADE_REFUSES(boxInertia(1, {1, 1, infinity}), given("size", Vector3(1, 1, infinity), "m"));
}

PROBES() {
  Random random(23);
  for (int n = 0; n < 16; ++n) {
    const Real mass = random.between(0.5, 5);
    const Vector3 size = Vector3(1.5, 1.5, 1.5) + random.vector();
    PROBE(boxInertia(mass, size));
  }
}

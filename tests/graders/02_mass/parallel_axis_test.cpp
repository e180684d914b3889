// Grader of 02.parallel_axis: a box about its corner, and clouds of points whose tensor about any
// point is a sum.

#include "carom/mass/parallel_axis.hpp"

#include <limits>

#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a dozen roundings of numbers of this size";

Matrix3 diagonal(Real xx, Real yy, Real zz) {
  return Vector3(xx, yy, zz).asDiagonal();
}

// Points of unequal mass.
struct Cloud {
  std::vector<Vector3> points;
  std::vector<Real> masses;

  Real mass() const {
    Real sum = 0;
    for (const Real m : masses) sum += m;
    return sum;
  }
  Vector3 center() const {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) sum += masses[i] * points[i];
    return sum / mass();
  }
  // Mass by mass: squared distances from the axes on the diagonal, minus the products beside it.
  Matrix3 tensorAbout(const Vector3& point) const {
    Matrix3 I = Matrix3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3 r = points[i] - point;
      for (int row = 0; row < 3; ++row) {
        for (int col = 0; col < 3; ++col) {
          I(row, col) +=
              masses[i] * (row == col ? r.squaredNorm() - r[row] * r[row] : -r[row] * r[col]);
        }
      }
    }
    return I;
  }
};

Cloud anyCloud(Random& random) {
  Cloud cloud;
  for (int n = 0; n < 5; ++n) {
    cloud.points.push_back(random.vector());
    cloud.masses.push_back(random.between(0.2, 2));
  }
  return cloud;
}

}  // namespace

TEST_CASE("corner") {
  // ∫(y² + z²) over [0,1]x[0,2]x[0,3] is 26, ∫xy is 3, and so on.
  Matrix3 expected;
  expected << 26, -3, -4.5, -3, 20, -9, -4.5, -9, 10;
  GRADE(parallelAxis(diagonal(6.5, 5, 2.5), 6, {0.5, 1, 1.5}), expected, within(1e-14, kRounding),
        given("inertiaAboutCenter", diagonal(6.5, 5, 2.5), "kg m^2"), given("mass", 6.0, "kg"),
        given("offset", Vector3(0.5, 1, 1.5), "m"), unit("kg m^2"),
        about("a box of 1 x 2 x 3 m about its corner"));
}

TEST_CASE("along") {
  GRADE(parallelAxis(diagonal(1, 2, 3), 2, {0, 0, 5}), diagonal(51, 52, 3),
        within(1e-14, kRounding), given("inertiaAboutCenter", diagonal(1, 2, 3), "kg m^2"),
        given("mass", 2.0, "kg"), given("offset", Vector3(0, 0, 5), "m"), unit("kg m^2"),
        about("the moment about z stays"));
  GRADE(parallelAxis(diagonal(1, 2, 3), 2, {4, 0, 0}), diagonal(1, 34, 35),
        within(1e-14, kRounding), given("inertiaAboutCenter", diagonal(1, 2, 3), "kg m^2"),
        given("mass", 2.0, "kg"), given("offset", Vector3(4, 0, 0), "m"), unit("kg m^2"),
        about("the moment about x stays"));
}

TEST_CASE("points") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Cloud cloud = anyCloud(random);
    const Matrix3 aboutCenter = cloud.tensorAbout(cloud.center());
    const Vector3 offset = random.vector(3);
    GRADE(parallelAxis(aboutCenter, cloud.mass(), offset),
          cloud.tensorAbout(cloud.center() + offset), within(1e-12, kRounding),
          given("inertiaAboutCenter", aboutCenter, "kg m^2"), given("mass", cloud.mass(), "kg"),
          given("offset", offset, "m"), unit("kg m^2"));
  }
  // A hole is a body of negative mass.
  GRADE(parallelAxis(diagonal(-1, -1, -1), -1, {0, 2, 0}), diagonal(-5, -1, -5),
        within(1e-14, kRounding), given("inertiaAboutCenter", diagonal(-1, -1, -1), "kg m^2"),
        given("mass", -1.0, "kg"), given("offset", Vector3(0, 2, 0), "m"), unit("kg m^2"),
        about("a hole"));
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(parallelAxis(diagonal(1, 1, 1), nan, {1, 0, 0}), given("mass", nan, "kg"));
  GRADE_REFUSES(parallelAxis(diagonal(1, 1, 1), 1, {nan, 0, 0}),
                given("offset", Vector3(nan, 0, 0), "m"));
}

PROBES() {
  Random random(25);
  for (int n = 0; n < 16; ++n) {
    const Cloud cloud = anyCloud(random);
    const Vector3 offset = random.vector(3);
    PROBE(parallelAxis(cloud.tensorAbout(cloud.center()), cloud.mass(), offset));
  }
}

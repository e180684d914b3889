// Principal axes: a right-handed frame in which the tensor is diagonal, for every tensor there is.

#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/inertia_about.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/principal_axes.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

void checkIsPrincipalFrame(const Matrix3& inertia, const PrincipalAxes& principal) {
  const Matrix3& R = principal.axes;
  const Real scale = inertia.cwiseAbs().maxCoeff();
  CHECK((R.transpose() * R - Matrix3::Identity()).cwiseAbs().maxCoeff() < 2e-15);
  CHECK_THAT(cross(R.col(0), R.col(1)).dot(R.col(2)), WithinAbs(1, 2e-15));
  CHECK(principal.moments[0] <= principal.moments[1]);
  CHECK(principal.moments[1] <= principal.moments[2]);
  const Matrix3 again = R * principal.moments.asDiagonal() * R.transpose();
  CHECK((again - inertia).cwiseAbs().maxCoeff() <= 3e-15 * scale);
}

}  // namespace

TEST_CASE("a diagonal tensor in ascending order is left as it is") {
  const PrincipalAxes principal = principalAxes(Vector3(1, 2, 3).asDiagonal());
  CHECK(principal.moments == Vector3(1, 2, 3));
  CHECK(principal.axes == Matrix3::Identity());
  CHECK(principalAxes(Matrix3::Identity()).axes == Matrix3::Identity());
  CHECK(principalAxes(Matrix3::Zero()).axes == Matrix3::Identity());
}

TEST_CASE("every order of the moments is sorted, and the frame stays right-handed") {
  for (const Vector3& moments :
       {Vector3(1, 2, 3), Vector3(1, 3, 2), Vector3(2, 1, 3), Vector3(2, 3, 1), Vector3(3, 1, 2),
        Vector3(3, 2, 1), Vector3(1, 1, 2), Vector3(2, 1, 1), Vector3(1, 2, 1)}) {
    const Matrix3 inertia = moments.asDiagonal();
    checkIsPrincipalFrame(inertia, principalAxes(inertia));
  }
}

TEST_CASE("random tensors, from round to needle, come back from their axes") {
  Random random(31);
  for (int i = 0; i < 500; ++i) {
    Vector3 n(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    n /= n.norm();
    const Real angle = random.between(-3, 3);
    Matrix3 N;
    N << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
    const Matrix3 R = Matrix3::Identity() + std::sin(angle) * N + (1 - std::cos(angle)) * N * N;
    const Real gap = std::pow(10, random.between(-16, 0));
    const Vector3 moments(1, 1 + gap, 1 + gap + random.between(0, 1));
    const Real scale = std::pow(10, random.between(-100, 100));
    const Matrix3 inertia = rotateInertia(scale * Matrix3(moments.asDiagonal()), R);
    INFO("round " << i << " (seed 31)");
    checkIsPrincipalFrame(inertia, principalAxes(inertia));
    CHECK(relativeError(principalAxes(inertia).moments, Vector3(scale * moments)) < 2e-15);
  }
}

TEST_CASE("a spherical tensor with rounding noise is not turned") {
  Matrix3 inertia = Matrix3::Identity();
  inertia(0, 1) = inertia(1, 0) = 1e-16;
  inertia(1, 2) = inertia(2, 1) = -2e-16;
  CHECK(principalAxes(inertia).axes == Matrix3::Identity());
}

TEST_CASE("a turned box shows its own axes") {
  Matrix3 R;
  R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  R /= 3;
  const TriangleMesh box = transformed(boxMesh({-3, -2, -1}, {3, 2, 1}), R);
  const PrincipalAxes principal = principalAxes(massProperties(box, 1).inertia);
  for (int k = 0; k < 3; ++k) {
    CHECK_THAT(std::abs(principal.axes.col(k).dot(R.col(k))), WithinAbs(1, 1e-15));
  }
}

TEST_CASE("what is no inertia tensor is refused") {
  Matrix3 skew = Matrix3::Identity();
  skew(0, 1) = 0.1;
  CHECK_THROWS_AS(principalAxes(skew), InvalidInput);
  CHECK_THROWS_AS(principalAxes(Matrix3::Constant(std::nan(""))), InvalidInput);
  Matrix3 infinite = Matrix3::Identity();
  infinite(2, 2) = std::numeric_limits<Real>::infinity();
  CHECK_THROWS_AS(principalAxes(infinite), InvalidInput);
}

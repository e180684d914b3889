#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_matrix.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/eigen_quaternion.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/orthonormalize.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;

TEST_CASE("the quaternion of a matrix close to half a turn keeps its digits (R5)") {
  const auto c = caseNamed("R5");
  const Matrix3 R = matrix(c["R"]);
  const Quaternion q = matrixToQuaternion(R);
  CHECK(distance(q, quaternion(c["q"])) <= number(c["accept"]["component"]));
  CHECK(std::abs(R.trace() - number(c["trace"])) <= 4e-16);
  CHECK(std::abs(quaternionLogarithm(q).norm() - number(c["angle"])) <=
        number(c["accept"]["angle"]));
}

TEST_CASE("matrix and quaternion turn into one another, for all four largest components") {
  Random random(701);
  int used[4] = {0, 0, 0, 0};
  for (int i = 0; i < 20000; ++i) {
    const Quaternion q = random.rotation();
    const Quaternion back = matrixToQuaternion(quaternionToMatrix(q));
    REQUIRE(distanceOfRotations(back, q) <= 5e-16);
    REQUIRE(back.w >= 0);
    int largest = 0;
    Vector4(q.w, q.x, q.y, q.z).cwiseAbs().maxCoeff(&largest);
    ++used[largest];
  }
  for (const int count : used) CHECK(count > 3000);
}

TEST_CASE("half turns about the axes have quaternions without real part") {
  for (int i = 0; i < 3; ++i) {
    Matrix3 R = -Matrix3::Identity();
    R(i, i) = 1;
    const Quaternion q = matrixToQuaternion(R);
    CHECK(distance(q, {0, i == 0 ? 1.0 : 0, i == 1 ? 1.0 : 0, i == 2 ? 1.0 : 0}) == 0);
    CHECK(quaternionToMatrix(q) == R);
  }
  CHECK(distance(matrixToQuaternion(Matrix3::Identity()), {1, 0, 0, 0}) == 0);
}

TEST_CASE("the columns of the matrix of a quaternion are the turned axes, whatever its norm") {
  const Matrix3 found = quaternionToMatrix({1, 2, -2, 4});
  CHECK(distance(found.col(0), rotatePoint({1, 2, -2, 4}, Vector3::UnitX())) <= 2e-16);
  CHECK(orthogonalityError(found) <= 5e-16);
  CHECK(std::abs(cross(found.col(0), found.col(1)).dot(found.col(2)) - 1) <= 5e-16);
}

TEST_CASE("a quaternion is not read off a matrix that is no rotation") {
  Matrix3 R = Matrix3::Identity();
  R(0, 0) = -1;
  CHECK_THROWS_WITH(matrixToQuaternion(R), carom_test::ContainsSubstring("mirrors"));
  CHECK_THROWS_AS(matrixToQuaternion(1.01 * Matrix3::Identity()), InvalidInput);
  R(0, 0) = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(matrixToQuaternion(R), InvalidInput);
  // Drift of a millionth is forgiven.
  CHECK(distance(matrixToQuaternion((1 + 1e-6) * Matrix3::Identity()), {1, 0, 0, 0}) <= 1e-15);
}

TEST_CASE("a rotation is its own nearest rotation") {
  Random random(702);
  for (int i = 0; i < 2000; ++i) {
    const Matrix3 R = quaternionToMatrix(random.rotation());
    REQUIRE(distance(orthonormalize(R), R) <= 1e-15);
    REQUIRE(distance(orthonormalize(1e200 * R), R) <= 1e-15);
    REQUIRE(distance(orthonormalize(1e-300 * R), R) <= 1e-15);
  }
}

TEST_CASE("a matrix R S with symmetric positive S has R as its nearest rotation") {
  // That is the polar decomposition, and it is unique.
  Random random(703);
  for (int i = 0; i < 2000; ++i) {
    const Matrix3 R = quaternionToMatrix(random.rotation());
    const Matrix3 axes = quaternionToMatrix(random.rotation());
    const Vector3 stretch = 0.35 * random.inBox(1) + Vector3::Constant(1.05);
    const Matrix3 S = axes * stretch.asDiagonal() * axes.transpose();
    REQUIRE(distance(orthonormalize(R * S), R) <= 2e-15);
    REQUIRE(orthogonalityError(orthonormalize(R * S)) <= 2e-15);
  }
}

TEST_CASE("a matrix drifted by a million products becomes a rotation again") {
  const Matrix3 step = axisAngleToMatrix({3, 4, 12}, 1e-3);
  Matrix3 R = Matrix3::Identity();
  for (int i = 0; i < 1000000; ++i) R = R * step;
  CHECK(orthogonalityError(R) > 1e-14);
  const Matrix3 repaired = orthonormalize(R);
  CHECK(orthogonalityError(repaired) <= 1e-15);
  CHECK(distance(repaired, axisAngleToMatrix({3, 4, 12}, 1000)) <= 1e-9);
}

TEST_CASE("matrices that are near no rotation are refused") {
  CHECK_THROWS_AS(orthonormalize(Matrix3::Zero()), InvalidInput);
  CHECK_THROWS_AS(orthonormalize(-Matrix3::Identity()), InvalidInput);
  CHECK_THROWS_AS(orthonormalize(Matrix3::Ones()), InvalidInput);
  Matrix3 flat = Matrix3::Identity();
  flat(2, 2) = 1e-9;
  CHECK_THROWS_WITH(orthonormalize(flat), carom_test::ContainsSubstring("determinant"));
  flat(2, 2) = std::numeric_limits<Real>::infinity();
  CHECK_THROWS_AS(orthonormalize(flat), InvalidInput);
}

TEST_CASE("Eigen's quaternions are the same rotations, with the same product") {
  const Quaternion q{0.1, 0.2, -0.3, 0.4};
  CHECK(toEigen(q).w() == 0.1);
  CHECK(toEigen(q).z() == 0.4);
  CHECK(distance(fromEigen(toEigen(q)), q) == 0);
  Random random(704);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion a = random.rotation(), b = random.rotation();
    const Vector3 v = random.inBox(1);
    REQUIRE(distance(fromEigen(toEigen(a) * toEigen(b)), hamiltonProduct(a, b)) <= 4e-16);
    REQUIRE(distance(toEigen(a) * v, rotatePoint(a, v)) <= 2e-15);
    REQUIRE(distance(toEigen(a).toRotationMatrix(), quaternionToMatrix(a)) <= 2e-15);
  }
}

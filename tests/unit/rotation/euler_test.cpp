#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_matrix.hpp"
#include "carom/rotation/euler_rates.hpp"
#include "carom/rotation/euler_to_matrix.hpp"
#include "carom/rotation/matrix_to_euler.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;
using carom_test::Approx;

namespace {
constexpr Real kUlp = 0x1p-52;  // of 1

// The matrix of three angles in long double: another road, with 11 more bits.
Matrix3 rotationInLongDouble(const EulerAngles& angles) {
  using Long = long double;
  const Long sx = std::sin(Long(angles.roll)), cx = std::cos(Long(angles.roll));
  const Long sy = std::sin(Long(angles.pitch)), cy = std::cos(Long(angles.pitch));
  const Long sz = std::sin(Long(angles.yaw)), cz = std::cos(Long(angles.yaw));
  const auto real = [](Long value) { return static_cast<Real>(value); };
  Matrix3 R;
  R << real(cz * cy), real(cz * sy * sx - sz * cx), real(cz * sy * cx + sz * sx),  //
      real(sz * cy), real(sz * sy * sx + cz * cx), real(sz * sy * cx - cz * sx),   //
      real(-sy), real(cy * sx), real(cy * cx);
  return R;
}
}  // namespace

TEST_CASE("the matrix of three Euler angles has the nine entries of case R1") {
  const auto c = caseNamed("R1");
  const Matrix3 R = eulerToMatrix({number(c["roll"]), number(c["pitch"]), number(c["yaw"])});
  CHECK(distance(R, matrix(c["R"])) <= number(c["accept"]["entry"]));
  CHECK(orthogonalityError(R) <= number(c["accept"]["orthogonality"]));
  CHECK(std::abs(R.col(0).dot(cross(R.col(1), R.col(2))) - number(c["det"])) <= 1e-15);
}

TEST_CASE("Euler angles of zero are no rotation") {
  CHECK(eulerToMatrix({}) == Matrix3::Identity());
}

TEST_CASE("roll turns first, then pitch, then yaw") {
  const Matrix3 R = axisAngleToMatrix(Vector3::UnitZ(), 1.1) *
                    axisAngleToMatrix(Vector3::UnitY(), -0.7) *
                    axisAngleToMatrix(Vector3::UnitX(), 0.3);
  CHECK(distance(eulerToMatrix({0.3, -0.7, 1.1}), R) <= 4e-16);
  CHECK(distance(eulerToMatrix({0.3, 0, 0}), axisAngleToMatrix(Vector3::UnitX(), 0.3)) <= 2e-16);
  CHECK(distance(eulerToMatrix({0, 0.3, 0}), axisAngleToMatrix(Vector3::UnitY(), 0.3)) <= 2e-16);
  CHECK(distance(eulerToMatrix({0, 0, 0.3}), axisAngleToMatrix(Vector3::UnitZ(), 0.3)) <= 2e-16);
}

TEST_CASE("the matrix of Euler angles is within 4e-16 of one computed with more digits") {
  Random random(101);
  for (int i = 0; i < 20000; ++i) {
    const EulerAngles angles{random.between(-10, 10), random.between(-10, 10),
                             random.between(-10, 10)};
    const Matrix3 R = eulerToMatrix(angles);
    REQUIRE(distance(R, rotationInLongDouble(angles)) <= 4e-16);
    REQUIRE(orthogonalityError(R) <= 1e-15);
  }
}

TEST_CASE(
    "near gimbal lock pitch, the difference of the other two and the matrix stay exact (R2)") {
  const auto c = caseNamed("R2");
  const EulerAngles given{number(c["roll"]), number(c["pitch"]), number(c["yaw"])};
  const Matrix3 rounded = matrix(c["R"]);
  CHECK(distance(eulerToMatrix(given), rounded) <= 4e-16);
  for (const Matrix3& R : {rounded, eulerToMatrix(given)}) {
    const EulerAngles found = matrixToEuler(R);
    CHECK(std::abs(found.pitch - given.pitch) <= number(c["accept"]["pitch"]));
    CHECK(std::abs((found.roll - found.yaw) - (given.roll - given.yaw)) <=
          number(c["accept"]["roll - yaw"]));
    CHECK(std::abs(found.roll - given.roll) <= number(c["accept"]["roll"]));
    CHECK(std::abs(found.yaw - given.yaw) <= number(c["accept"]["yaw"]));
    CHECK(distance(eulerToMatrix(found), R) <= number(c["accept"]["rebuilt matrix"]));
  }
}

TEST_CASE("angles come back from their matrix within 8 ulp of 1 / cos(pitch)") {
  Random random(102);
  for (int i = 0; i < 200000; ++i) {
    const EulerAngles given{random.between(-kPi, kPi), random.between(-1.57, 1.57),
                            random.between(-kPi, kPi)};
    const EulerAngles found = matrixToEuler(eulerToMatrix(given));
    const Real limit = 8 * kUlp / cosine(given.pitch);
    INFO(given.roll << " " << given.pitch << " " << given.yaw);
    REQUIRE(std::abs(found.roll - given.roll) <= limit);
    REQUIRE(std::abs(found.pitch - given.pitch) <= limit);
    REQUIRE(std::abs(found.yaw - given.yaw) <= limit);
  }
}

TEST_CASE("the matrix built again from its angles is within 1e-15, for any rotation") {
  Random random(103);
  for (int i = 0; i < 100000; ++i) {
    const Matrix3 R = quaternionToMatrix(random.rotation());
    REQUIRE(distance(eulerToMatrix(matrixToEuler(R)), R) <= 1e-15);
  }
}

TEST_CASE("the matrix built again is within 1e-15 however close to gimbal lock") {
  Random random(104);
  for (int power = 1; power <= 20; ++power) {
    for (const Real sign : {-1.0, 1.0}) {
      for (int i = 0; i < 500; ++i) {
        const EulerAngles given{random.between(-kPi, kPi), sign * (kPi / 2 - std::pow(10, -power)),
                                random.between(-kPi, kPi)};
        // The small entries of a matrix that was not made from angles are rounding noise.
        Matrix3 R = eulerToMatrix(given);
        R(2, 1) += random.between(-1e-16, 1e-16);
        R(2, 2) += random.between(-1e-16, 1e-16);
        INFO(given.roll << " " << given.pitch << " " << given.yaw);
        REQUIRE(distance(eulerToMatrix(matrixToEuler(R)), R) <= 1e-15);
      }
    }
  }
}

TEST_CASE("in gimbal lock itself roll is zero and yaw takes the whole rest") {
  Matrix3 up;
  up << 0, 0.6, 0.8, 0, 0.8, -0.6, -1, 0, 0;
  const EulerAngles angles = matrixToEuler(up);
  CHECK(angles.roll == 0);
  CHECK(angles.pitch == kPi / 2);
  CHECK(distance(eulerToMatrix(angles), up) <= 4e-16);
  Matrix3 down;
  down << 0, -0.6, -0.8, 0, 0.8, -0.6, 1, 0, 0;
  CHECK(matrixToEuler(down).roll == 0);
  CHECK(matrixToEuler(down).pitch == -kPi / 2);
  CHECK(distance(eulerToMatrix(matrixToEuler(down)), down) <= 4e-16);
}

TEST_CASE("in gimbal lock only the difference of roll and yaw has a meaning") {
  const Matrix3 a = eulerToMatrix({0.5, kPi / 2, 0.2});
  const Matrix3 b = eulerToMatrix({1.5, kPi / 2, 1.2});
  CHECK(distance(a, b) <= 4e-16);
}

TEST_CASE("the rate matrix turns changing angles into the angular velocity of the matrix") {
  const EulerAngles angles{0.4, -0.8, 2.1};
  const Vector3 rates(0.3, -0.2, 0.7);
  const Real h = 1e-5;  // central difference: error h^2 / 6 and rounding 1e-16 / h
  const auto after = [&](Real t) {
    return eulerToMatrix(
        {angles.roll + t * rates.x(), angles.pitch + t * rates.y(), angles.yaw + t * rates.z()});
  };
  const Matrix3 spin = (after(h) - after(-h)) / (2 * h) * eulerToMatrix(angles).transpose();
  const Vector3 omega(spin(2, 1), spin(0, 2), spin(1, 0));
  CHECK(distance(eulerRateMatrix(angles) * rates, omega) <= 1e-9);
}

TEST_CASE(
    "the determinant of the rate matrix is the cosine of pitch: gimbal lock is its zero (R2)") {
  const auto c = caseNamed("R2");
  const Matrix3 E = eulerRateMatrix({number(c["roll"]), number(c["pitch"]), number(c["yaw"])});
  const Real determinant = cross(E.col(0), E.col(1)).dot(E.col(2));
  // Pitch itself is rounded to 1e-16, which is 1e-10 of the cosine of 1e-6.
  CHECK(std::abs(determinant / number(c["det of rate matrix"]) - 1) <= 3e-10);

  // The columns are unit vectors, those of roll and yaw at right angles to that of pitch, so the
  // singular values are 1 and sqrt(1 -+ s) with s the product of the axes of roll and yaw.
  const Real s = std::abs(E.col(0).dot(E.col(2)));
  CHECK(E.col(0).dot(E.col(1)) == Approx(0).margin(1e-16));
  const Real across = cross(E.col(0), E.col(2)).norm();  // sqrt(1 - s^2)
  const Real smallest = across / std::sqrt(1 + s);
  CHECK(std::abs(smallest / number(c["smallest singular value"]) - 1) <= 3e-10);
  CHECK(std::abs(std::sqrt(1 + s) / smallest / number(c["condition"]) - 1) <= 3e-10);
}

TEST_CASE("Euler angles that are not finite are refused by name") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real infinite = std::numeric_limits<Real>::infinity();
  CHECK_THROWS_AS(eulerToMatrix({nan, 0, 0}), InvalidInput);
  CHECK_THROWS_WITH(eulerToMatrix({0, infinite, 0}), "pitch = inf must be finite");
  CHECK_THROWS_AS(eulerRateMatrix({0, 0, nan}), InvalidInput);
}

TEST_CASE("angles are not read off a matrix that is no rotation") {
  Matrix3 mirror = Matrix3::Identity();
  mirror(2, 2) = -1;
  CHECK_THROWS_WITH(matrixToEuler(mirror), carom_test::ContainsSubstring("mirrors"));
  CHECK_THROWS_AS(matrixToEuler(2 * Matrix3::Identity()), InvalidInput);
  CHECK_THROWS_AS(matrixToEuler(Matrix3::Zero()), InvalidInput);
  Matrix3 broken = Matrix3::Identity();
  broken(0, 1) = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(matrixToEuler(broken), InvalidInput);
}

TEST_CASE("huge angles are turned as exactly as small ones") {
  const EulerAngles angles{1e15, -3e9, 1e6};
  CHECK(distance(eulerToMatrix(angles), rotationInLongDouble(angles)) <= 4e-16);
}

// What the source's slips give, beside what is right. These numbers are known, so a grader can name
// the slip, and a reader can see that it matters.

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/euler_to_matrix.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/matrix_to_euler.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;
using carom_test::Approx;

namespace {

Real determinant(const Matrix3& M) {
  return cross(M.col(0), M.col(1)).dot(M.col(2));
}

// Equation 2 as printed.
Matrix3 equation2(const EulerAngles& a) {
  Matrix3 R = eulerToMatrix(a);
  R(0, 0) = cosine(a.yaw) * sine(a.pitch);
  return R;
}

// q += h/2 omega q, as equation 14 is usually programmed.
Quaternion naiveStep(const Quaternion& q, const Vector3& omega, Real h) {
  const Quaternion rate = hamiltonProduct({0, omega.x(), omega.y(), omega.z()}, q);
  return {q.w + h / 2 * rate.w, q.x + h / 2 * rate.x, q.y + h / 2 * rate.y, q.z + h / 2 * rate.z};
}

}  // namespace

TEST_CASE("equation 2 as printed is no rotation: its determinant is 0.778 (R1)") {
  const auto c = caseNamed("R1");
  const EulerAngles angles{number(c["roll"]), number(c["pitch"]), number(c["yaw"])};
  const Matrix3 R = equation2(angles);
  CHECK(std::abs(R(0, 0) - number(c["wrong"]["entry 11"])) <= 1e-16);
  CHECK(std::abs(determinant(R) - number(c["wrong"]["det"])) <= 5e-16);
  CHECK(std::abs(determinant(eulerToMatrix(angles)) - 1) <= 5e-16);
  CHECK(equation2({}).row(0).isZero(0));
}

TEST_CASE("pitch by arcsine loses half its digits near gimbal lock (R2)") {
  const auto c = caseNamed("R2");
  const Matrix3 R = matrix(c["R"]);
  const Real pitch = number(c["pitch"]);
  CHECK(std::abs(std::asin(-R(2, 0)) - pitch) ==
        Approx(number(c["wrong"]["pitch error"])).epsilon(0.01));
  CHECK(std::abs(matrixToEuler(R).pitch - pitch) <= 1e-15);
}

TEST_CASE("180 degrees taken for radians are no half turn (R3)") {
  const auto c = caseNamed("R3");
  CHECK(std::abs(axisAngleToQuaternion(Vector3::UnitY(), 180).w - number(c["wrong"]["w"])) <=
        1e-16);
  CHECK(std::abs(axisAngleToQuaternion(Vector3::UnitY(), kPi).w) <= 1e-16);
}

TEST_CASE("the angle by arccosine is lost near the identity (R4)") {
  const auto c = caseNamed("R4")["wrong"];
  const Vector3 axis = Vector3(2, -1, 2) / 3;
  const Real coarse = 2 * std::acos(quaternionExponential(1e-4 * axis).w);
  CHECK(std::abs(coarse / 1e-4 - 1) == Approx(number(c["relative error at 1e-4"])).epsilon(0.01));
  CHECK(2 * std::acos(quaternionExponential(1e-8 * axis).w) == number(c["angle at 1e-8"]));
  CHECK(quaternionLogarithm(quaternionExponential(1e-8 * axis)).norm() == Approx(1e-8));
}

TEST_CASE("w from the trace is zero close to half a turn (R5)") {
  const auto c = caseNamed("R5");
  const Matrix3 R = matrix(c["R"]);
  CHECK(std::sqrt(std::max(0.0, 1 + R.trace())) / 2 == Approx(0).margin(3e-8));
  CHECK(std::abs(std::sqrt(std::max(0.0, 1 + R.trace())) / 2 - number(c["q"][0])) > 4e-10);
  CHECK(std::abs(matrixToQuaternion(R).w - number(c["q"][0])) <= 2e-16);
}

TEST_CASE("equation 9 with one factor normalised stretches the point five times (R7)") {
  const auto c = caseNamed("R7");
  const Quaternion q = quaternion(c["q"]);
  const Vector3 v = vector(c["v"]);
  const Quaternion turned =
      hamiltonProduct(hamiltonProduct(renormalize(q), {0, v.x(), v.y(), v.z()}), conjugate(q));
  const Vector3 asPrinted(turned.x, turned.y, turned.z);
  CHECK(distance(asPrinted, vector(c["wrong"]["turned"])) <= 1e-15);
  CHECK(asPrinted.norm() == Approx(5));
  CHECK(rotatePoint(q, v).norm() == Approx(1));
}

TEST_CASE("the naive step leaves the unit sphere, and is of first order only (R8)") {
  const auto c = caseNamed("R8");
  const Vector3 omega = vector(c["omega"]);
  Quaternion q;
  for (int i = 0; i < 1000; ++i) q = naiveStep(q, omega, 0.01);
  CHECK(static_cast<Real>(norm(q)) == Approx(number(c["wrong"]["norm at h=0.01"])).epsilon(1e-6));

  const auto error = [&](int steps) {
    Quaternion p;
    for (int i = 0; i < steps; ++i) p = renormalize(naiveStep(p, omega, 10.0 / steps));
    return angleBetween(p, quaternion(c["q"]));
  };
  const auto wrong = c["wrong"];
  CHECK(error(1000) == Approx(number(wrong["angle error at h=0.01, normalised"])).epsilon(1e-3));
  CHECK(error(10000) == Approx(number(wrong["angle error at h=0.001, normalised"])).epsilon(1e-3));
  CHECK(angleBetween(integrateOrientation({}, omega, 10), quaternion(c["q"])) <= 3e-14);
}

TEST_CASE("rotation vectors do not add (R9)") {
  const auto c = caseNamed("R9");
  const Vector3 x(kPi / 2, 0, 0), y(0, kPi / 2, 0);
  const Vector3 added = rotatePoint(quaternionExponential(x + y), Vector3::UnitZ());
  CHECK(distance(added, vector(c["wrong"]["e_z"])) <= 1e-8);
  const Quaternion inTurn = hamiltonProduct(quaternionExponential(y), quaternionExponential(x));
  CHECK(distance(rotatePoint(inTurn, Vector3::UnitZ()), vector(c["x then y"])) <= 4e-16);
}

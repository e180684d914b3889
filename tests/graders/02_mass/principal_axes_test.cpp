// Grader of 02.principal_axes: tensors that were made from known moments and frames, so that the
// answer is known before the question. Signs of axes are free; what is compared does not depend on
// them.

#include "carom/mass/principal_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few dozen roundings of numbers of this size";

// A right-handed frame of thirds.
Matrix3 frameOfThirds() {
  Matrix3 R;
  R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  return R / 3;
}

Matrix3 anyFrame(Random& random) {
  const Vector3 x = random.direction();
  Vector3 y = random.direction();
  y -= x * x.dot(y);
  while (y.norm() < 0.1) {
    y = random.direction();
    y -= x * x.dot(y);
  }
  y /= y.norm();
  Matrix3 R;
  R.col(0) = x;
  R.col(1) = y;
  R.col(2) = cross(x, y);
  return R;
}

Matrix3 tensor(const Matrix3& frame, const Vector3& moments) {
  const Matrix3 D = moments.asDiagonal();
  const Matrix3 I = frame * D * frame.transpose();
  return (I + I.transpose()) / 2;
}

// axes diag(moments) axesᵀ: the tensor that an answer describes.
Matrix3 rebuilt(const PrincipalAxes& p) {
  const Matrix3 D = p.moments.asDiagonal();
  return p.axes * D * p.axes.transpose();
}

// First axis times second, along the third: 1 for a right-handed frame, -1 for its mirror image.
Real handedness(const PrincipalAxes& p) {
  return cross(p.axes.col(0), p.axes.col(1)).dot(p.axes.col(2));
}

// How far I a is from (moment) a, for the worst of the three axes.
Real worstPair(const Matrix3& inertia, const PrincipalAxes& p) {
  Real worst = 0;
  for (int k = 0; k < 3; ++k) {
    worst = std::max(worst, (inertia * p.axes.col(k) - p.moments[k] * p.axes.col(k)).norm());
    worst = std::max(worst, std::abs(p.axes.col(k).norm() - 1));
  }
  return worst;
}

// An entry of the axes without its sign.
Vector3 withoutSign(const Vector3& axis) {
  return axis.cwiseAbs();
}

Vector3 anyMoments(Random& random) {
  return Vector3(2, 3, 4) + 0.9 * random.vector();
}

}  // namespace

TEST_CASE("moments") {
  for (const Vector3& m :
       {Vector3(1, 2, 3), Vector3(3, 1, 2), Vector3(2, 3, 1), Vector3(3, 2, 1)}) {
    const Matrix3 straight = m.asDiagonal();
    GRADE(principalAxes(straight).moments, Vector3(1, 2, 3), within(4e-15, kRounding),
          given("inertia", straight, "kg m^2"), unit("kg m^2"));
    GRADE(principalAxes(tensor(frameOfThirds(), m)).moments, Vector3(1, 2, 3),
          within(1e-14, kRounding), given("inertia", tensor(frameOfThirds(), m), "kg m^2"),
          unit("kg m^2"));
  }
}

TEST_CASE("pairs") {
  const Matrix3 I = tensor(frameOfThirds(), {5, 2, 4});
  GRADE(withoutSign(principalAxes(I).axes.col(0)), Vector3(1, 2, 2) / 3, within(1e-14, kRounding),
        given("inertia", I, "kg m^2"), about("the first axis, all signs made positive"));
  GRADE(withoutSign(principalAxes(I).axes.col(2)), Vector3(2, 2, 1) / 3, within(1e-14, kRounding),
        given("inertia", I, "kg m^2"), about("the last axis, all signs made positive"));
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Matrix3 inertia = tensor(anyFrame(random), anyMoments(random));
    GRADE(worstPair(inertia, principalAxes(inertia)), 0.0, within(3e-14, kRounding),
          given("inertia", inertia, "kg m^2"), unit("kg m^2"),
          about("how far I times an axis is from its moment times that axis, for the worst of the "
                "three"));
  }
}

TEST_CASE("right_handed") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Vector3 moments = anyMoments(random);
    const Matrix3 inertia = tensor(anyFrame(random), {moments.z(), moments.x(), moments.y()});
    GRADE(handedness(principalAxes(inertia)), 1.0, within(1e-14, kRounding),
          given("inertia", inertia, "kg m^2"),
          about("first axis x second axis, along the third: 1 if right-handed, -1 if mirrored"));
    // Handedness alone would let the unit matrix pass.
    GRADE(rebuilt(principalAxes(inertia)), inertia, within(3e-14, kRounding),
          given("inertia", inertia, "kg m^2"), unit("kg m^2"),
          about("axes diag(moments) axes^T, which is the tensor again"));
  }
  const Matrix3 swapped = Vector3(3, 2, 1).asDiagonal();
  GRADE(handedness(principalAxes(swapped)), 1.0, within(1e-15, kRounding),
        given("inertia", swapped, "kg m^2"),
        about("first axis x second axis, along the third: 1 if right-handed, -1 if mirrored"));
}

TEST_CASE("nearly_equal") {
  const Real close = 1 + 0x1p-40;
  const Matrix3 I = tensor(frameOfThirds(), {1, close, 2});
  GRADE(principalAxes(I).moments, Vector3(1, close, 2), within(2e-15, kRounding),
        given("inertia", I, "kg m^2"), unit("kg m^2"), about("two moments that differ by 9e-13"));
  GRADE(rebuilt(principalAxes(I)), I, within(4e-15, kRounding), given("inertia", I, "kg m^2"),
        unit("kg m^2"), about("axes diag(moments) axes^T, which is the tensor again"));
  const Matrix3 ball = Vector3(2, 2, 2).asDiagonal();
  GRADE(rebuilt(principalAxes(ball)), ball, within(4e-15, kRounding),
        given("inertia", ball, "kg m^2"), unit("kg m^2"),
        about("axes diag(moments) axes^T, which is the tensor again"));
  GRADE(handedness(principalAxes(ball)), 1.0, within(1e-15, kRounding),
        given("inertia", ball, "kg m^2"), about("any right-handed frame is right for a ball"));
}

TEST_CASE("refuses") {
  Matrix3 skew = Matrix3::Identity();
  skew(0, 1) = 0.5;
  GRADE_REFUSES(principalAxes(skew), given("inertia", skew, "kg m^2"), about("not symmetric"));
  Matrix3 bad = Matrix3::Identity();
  bad(2, 2) = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(principalAxes(bad), given("inertia", bad, "kg m^2"));
}

PROBES() {
  // What does not depend on the signs of axes, so that answers are recognised whichever way they
  // point.
  Random random(27);
  for (int n = 0; n < 10; ++n) {
    const Matrix3 inertia = tensor(anyFrame(random), anyMoments(random));
    PROBE(principalAxes(inertia).moments);
    PROBE(rebuilt(principalAxes(inertia)));
    PROBE(handedness(principalAxes(inertia)));
  }
}

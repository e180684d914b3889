// Grader of 01.order_of_turns: what the quaternions of the library say.

#include <algorithm>
#include <cmath>

#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Real h = std::sqrt(0.5);
const Quaternion aboutX{h, h, 0, 0};
const Quaternion aboutY{h, 0, h, 0};
const Vector3 start(1, 2, 3);
const Vector3 xThenY = rotatePoint(hamiltonProduct(aboutY, aboutX), start);
const Vector3 yThenX = rotatePoint(hamiltonProduct(aboutX, aboutY), start);
constexpr const char* kWhy = "5 % of the number";

void asks(const char* name, Real expected, const char* question) {
  GRADE(predicted(name, "m"), expected, withinRelative(0.05, kWhy), given("line", name), unit("m"),
        about(question));
}

// The number that somebody meant: 5 % is allowed, so digits alone do not tell two answers apart.
Real meant(const char* name) {
  const Real number = predicted(name, "m");
  if (std::abs(number) > 4) return std::abs(number - 5.1) < 0.3 ? 5.1 : std::round(number);
  return std::round(number);
}

}  // namespace

TEST_CASE("first_then") {
  asks("xy_x", xThenY.x(), "x after the turn about x and the turn about y");
  asks("xy_y", xThenY.y(), "y after the turn about x and the turn about y");
  asks("xy_z", xThenY.z(), "z after the turn about x and the turn about y");
}

TEST_CASE("other_order") {
  asks("yx_x", yThenX.x(), "x after the turn about y and the turn about x");
  asks("yx_y", yThenX.y(), "y after the turn about y and the turn about x");
  asks("yx_z", yThenX.z(), "z after the turn about y and the turn about x");
}

TEST_CASE("apart") {
  asks("apart", (xThenY - yThenX).norm(), "the distance of the two places");
}

PROBES() {
  for (const char* name : {"xy_x", "xy_y", "xy_z", "yx_x", "yx_y", "yx_z", "apart"}) {
    PROBE(meant(name));
  }
}

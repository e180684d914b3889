#include "carom/core/checks.hpp"

#include <limits>

#include "support/catch.hpp"

using namespace carom;

namespace {
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
}  // namespace

TEST_CASE("a failed check says the name, the value and the rule") {
  CHECK_THROWS_WITH(requirePositive(-2, "mass"), "mass = -2 must be positive and finite");
  CHECK_THROWS_WITH(requirePositive(0, "mass"), "mass = 0 must be positive and finite");
  CHECK_THROWS_WITH(requireNonNegative(-0.1, "friction"),
                    "friction = -0.1 must be zero or positive, and finite");
  CHECK_THROWS_WITH(requireFinite(-kInfinity, "angle"), "angle = -inf must be finite");
  CHECK_THROWS_WITH(requireFinite(Vector3(1, 0.25, kInfinity), "position"),
                    "position = (1, 0.25, inf) must be finite");
  CHECK_THROWS_WITH(reject("index", "7", "must be below 3"), "index = 7 must be below 3");
}

TEST_CASE("not-a-number passes no check") {
  CHECK_THROWS_AS(requireFinite(kNan, "x"), InvalidInput);
  CHECK_THROWS_AS(requirePositive(kNan, "x"), InvalidInput);
  CHECK_THROWS_AS(requireNonNegative(kNan, "x"), InvalidInput);
  CHECK_THROWS_AS(requireFinite(Vector3(0, kNan, 0), "x"), InvalidInput);
  CHECK_THROWS_AS(requirePositive(kInfinity, "x"), InvalidInput);
  CHECK_THROWS_AS(requireNonNegative(kInfinity, "x"), InvalidInput);
  Matrix3 matrix = Matrix3::Identity();
  matrix(1, 2) = kNan;
  CHECK_THROWS_AS(requireFinite(matrix, "x"), InvalidInput);
}

TEST_CASE("good values pass") {
  CHECK_NOTHROW(requireFinite(1e308, "x"));
  CHECK_NOTHROW(requirePositive(5e-324, "x"));
  CHECK_NOTHROW(requireNonNegative(0, "x"));
  CHECK_NOTHROW(requireNonNegative(-0.0, "x"));
  CHECK_NOTHROW(requireFinite(Vector3(1, 2, 3), "x"));
  CHECK_NOTHROW(requireFinite(Matrix3(Matrix3::Identity()), "x"));
}

TEST_CASE("numbers are written as short as they can be read back") {
  CHECK(toText(0.1) == "0.1");
  CHECK(toText(1.0 / 3) == "0.3333333333333333");
  CHECK(toText(-std::numeric_limits<Real>::min()) == "-2.2250738585072014e-308");
  CHECK(toText(Vector4(1, 2, 3, -4)) == "(1, 2, 3, -4)");
  CHECK(toText(Matrix3(Matrix3::Identity())) == "((1, 0, 0), (0, 1, 0), (0, 0, 1))");
}

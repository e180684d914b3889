#include "carom/precision/determinant.hpp"

#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/precision/exact_determinant.hpp"
#include "exact_integers.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace precision_test;

namespace {

Vector3 wholeVector(std::mt19937_64& engine, int bits) {
  const Real x = whole(engine, bits), y = whole(engine, bits), z = whole(engine, bits);
  return {x, y, z};
}

Integer determinantOf(const Vector3& a, const Vector3& b, const Vector3& c) {
  const auto n = [](Real value) { return Integer(value); };
  return n(a.x()) * (n(b.y()) * n(c.z()) - n(b.z()) * n(c.y())) +
         n(a.y()) * (n(b.z()) * n(c.x()) - n(b.x()) * n(c.z())) +
         n(a.z()) * (n(b.x()) * n(c.y()) - n(b.y()) * n(c.x()));
}

int signOf(Integer value) {
  return (value > 0) - (value < 0);
}

// Four points in one plane, but for `lift` added to one coordinate: a sliver with whole
// coordinates.
struct Sliver {
  Vector3 o, a, b, c;
};

Sliver sliver(std::mt19937_64& engine, Real lift) {
  const Vector3 o = wholeVector(engine, 30), u = wholeVector(engine, 20),
                v = wholeVector(engine, 20);
  const Real s = whole(engine, 12), t = whole(engine, 12);
  Sliver result{o, o + u, o + v, o + s * u + t * v};  // exact: whole numbers below 2^53
  result.c.z() += lift;
  return result;
}

}  // namespace

TEST_CASE("the determinant of three vectors is the signed volume that they span") {
  CHECK(determinant(Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()).value() == 1);
  CHECK(determinant(Vector3::UnitY(), Vector3::UnitX(), Vector3::UnitZ()).value() == -1);
  CHECK(determinant({1, 2, 3}, {4, 5, 6}, {7, 8, 10}).value() == -3);
  CHECK(exactDeterminant({1, 2, 3}, {4, 5, 6}, {7, 8, 10}) == -3);
  CHECK(exactDeterminant({1, 2, 3}, {4, 5, 6}, {7, 8, 9}) == 0);
}

TEST_CASE("determinants of whole numbers agree with integers of 128 bits") {
  std::mt19937_64 engine(51);
  for (int i = 0; i < 20000; ++i) {
    const Vector3 a = wholeVector(engine, 40), b = wholeVector(engine, 40),
                  c = wholeVector(engine, 40);
    const Integer reference = determinantOf(a, b, c);
    REQUIRE(exactDeterminant(a, b, c) == static_cast<Real>(reference));
    const long double size = a.norm() * b.norm() * c.norm();
    REQUIRE(magnitude(exactly(determinant(a, b, c)) - reference) <= 0x1p-101L * size);
  }
}

TEST_CASE("six times the volume of a tetrahedron agrees with integers of 128 bits") {
  std::mt19937_64 engine(52);
  for (int i = 0; i < 10000; ++i) {
    const Vector3 o = wholeVector(engine, 38), a = wholeVector(engine, 38),
                  b = wholeVector(engine, 38), c = wholeVector(engine, 38);
    const Integer reference = determinantOf(a - o, b - o, c - o);
    REQUIRE(exactTetrahedronDeterminant(o, a, b, c) == static_cast<Real>(reference));
    const long double size = (a - o).norm() * (b - o).norm() * (c - o).norm();
    REQUIRE(magnitude(exactly(tetrahedronDeterminant(o, a, b, c)) - reference) <= 0x1p-99L * size);
    REQUIRE(orientation(o, a, b, c) == signOf(reference));
  }
}

TEST_CASE("slivers keep their volume and their sign, where a double keeps neither") {
  std::mt19937_64 engine(53);
  for (int i = 0; i < 5000; ++i) {
    const Real lift = i % 3 - 1;  // below, in, or above the plane of the others
    const auto [o, a, b, c] = sliver(engine, lift);
    const Integer reference = determinantOf(a - o, b - o, c - o);
    REQUIRE(exactly(tetrahedronDeterminant(o, a, b, c)) == reference);
    REQUIRE(exactTetrahedronDeterminant(o, a, b, c) == static_cast<Real>(reference));
    REQUIRE(orientation(o, a, b, c) == signOf(reference));
  }
}

TEST_CASE(
    "a point some ulps off a plane has the right side, where a double often has the wrong one") {
  // The plane z = x + y, and points around (1/2, 1/2, 1) in steps of an ulp (after Kettner,
  // Mehlhorn, Pion, Schirra and Yap, Computational Geometry 40, 2008).
  const Vector3 a(12, 12, 24), b(24, 12, 36), c(12, 24, 36);
  int plainWrong = 0;
  for (int i = -32; i <= 32; ++i) {
    for (int j = -32; j <= 32; ++j) {
      const Vector3 o(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53, 1);
      // det(a - o, b - o, c - o) = 144 (z - x - y) for points on and o near this plane.
      const int above = (i + j < 0) - (i + j > 0);
      REQUIRE(orientation(o, a, b, c) == -above);
      REQUIRE(exactTetrahedronDeterminant(o, a, b, c) == 144 * ((o.x() - 0.5) + (o.y() - 0.5)));
      const Real plain = (a - o).dot(cross(b - o, c - o));
      if ((plain > 0) - (plain < 0) != -above) ++plainWrong;
    }
  }
  CHECK(plainWrong > 400);  // of 4225
}

TEST_CASE("the sign changes with every exchange of two corners") {
  std::mt19937_64 engine(54);
  for (int i = 0; i < 2000; ++i) {
    const auto [o, a, b, c] = sliver(engine, i % 3 - 1);
    const Vector3 p = o / 7, q = a / 7, r = b / 7, s = c / 7;
    const int sign = orientation(p, q, r, s);
    REQUIRE(orientation(p, r, q, s) == -sign);
    REQUIRE(orientation(p, q, s, r) == -sign);
    REQUIRE(orientation(q, p, r, s) == -sign);
    REQUIRE(orientation(s, r, q, p) == sign);
  }
}

TEST_CASE("counter-clockwise seen from outside is positive") {
  CHECK(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == 1);
  CHECK(orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == -1);
  CHECK(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}) == 0);
}

TEST_CASE("one ulp out of a plane is seen, at any scale and far from the origin") {
  for (const int e : {-400, -100, 0, 100, 400}) {
    const auto at = [e](Real x, Real y, Real z) {
      return Vector3(std::ldexp(x, e), std::ldexp(y, e), std::ldexp(z, e));
    };
    const Vector3 o = at(1e6, 1e6, 1e6), a = at(1e6 + 1, 1e6, 1e6), b = at(1e6, 1e6 + 1, 1e6);
    Vector3 c = at(1e6 + 0.3, 1e6 + 0.3, 1e6);
    REQUIRE(orientation(o, a, b, c) == 0);
    c.z() = std::nextafter(c.z(), std::numeric_limits<Real>::infinity());
    REQUIRE(orientation(o, a, b, c) == 1);
    c.z() = std::nextafter(std::nextafter(c.z(), 0), 0);
    REQUIRE(orientation(o, a, b, c) == -1);
  }
}

TEST_CASE("numbers that cannot be compared exactly are refused") {
  const Vector3 o(0, 0, 0), a(1, 0, 0), b(0, 1, 0);
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(orientation(o, a, b, {0, 0, nan}), InvalidInput);
  CHECK_THROWS_AS(exactDeterminant({std::numeric_limits<Real>::infinity(), 0, 0}, a, b),
                  InvalidInput);
  CHECK_THROWS_WITH(exactDeterminant(a, b, {0, 0, 1e-300}),
                    carom_test::ContainsSubstring("1e-300 must be 0, or at least 2^-600"));
  CHECK(exactDeterminant({1e-150, 0, 0}, {0, 1e-160, 0}, {0, 0, 1e-170}) == 0);  // underflows
  CHECK(exactDeterminant({1e-80, 0, 0}, {0, 1e80, 0}, {0, 0, 2}) == carom_test::Approx(2));
}

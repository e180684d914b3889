// Planar predicates, judged by integers of 128 bits.

#include <array>
#include <cmath>
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/precision/exact_determinant.hpp"
#include "carom/precision/exact_orient2d.hpp"
#include "carom/precision/in_circle.hpp"
#include "carom/precision/orient2d.hpp"
#include "carom/precision/orient2d_filtered.hpp"
#include "exact_integers.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace precision_test;

namespace {

int signOf(Integer value) {
  return (value > 0) - (value < 0);
}

Vector2 wholePoint(std::mt19937_64& engine, int bits) {
  const Real x = whole(engine, bits);
  return {x, whole(engine, bits)};
}

int integerOrientation(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Integer ax = Integer(a.x()) - Integer(c.x()), ay = Integer(a.y()) - Integer(c.y());
  const Integer bx = Integer(b.x()) - Integer(c.x()), by = Integer(b.y()) - Integer(c.y());
  return signOf(ax * by - ay * bx);
}

int integerInCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const auto x = [&d](const Vector2& p) { return Integer(p.x()) - Integer(d.x()); };
  const auto y = [&d](const Vector2& p) { return Integer(p.y()) - Integer(d.y()); };
  const auto square = [&](const Vector2& p) { return x(p) * x(p) + y(p) * y(p); };
  const auto cross = [&](const Vector2& p, const Vector2& q) { return x(p) * y(q) - x(q) * y(p); };
  return signOf(square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b));
}

// A point of the plane with coordinates that use all their bits.
Vector2 anyPoint(Random& random, Real size) {
  const Real x = random.between(-size, size);
  return {x, random.between(-size, size)};
}

}  // namespace

TEST_CASE("left of a line is positive, right of it negative, on it zero") {
  CHECK(orient2dFiltered({0, 0}, {1, 0}, {0, 1}).sign == 1);
  CHECK(orient2dFiltered({0, 0}, {0, 1}, {1, 0}).sign == -1);
  CHECK(orient2dFiltered({0, 0}, {1, 1}, {3, 3}).sign == 0);
  CHECK(orient2dFiltered({2, 5}, {2, 5}, {7, 1}).sign == 0);
  CHECK(orient2dFiltered({0, 0}, {1, 0}, {0, 1}).filtered);
  CHECK_FALSE(orient2dFiltered({0, 0}, {1, 1}, {3, 3}).filtered);
}

TEST_CASE("whole points on and beside a line are judged as integers judge them") {
  std::mt19937_64 engine(81);
  int zeros = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vector2 a = wholePoint(engine, 40), step = wholePoint(engine, 20);
    const Real m = whole(engine, 18), n = whole(engine, 18);
    const Vector2 b = a + m * step;
    Vector2 c = a + n * step;
    if (engine() % 2) c.x() += static_cast<Real>(engine() % 3) - 1;
    const int expected = integerOrientation(a, b, c);
    zeros += expected == 0;
    REQUIRE(orient2dFiltered(a, b, c).sign == expected);
    REQUIRE(exactOrient2d(a, b, c) == expected);
    REQUIRE(orient2dFiltered(b, c, a).sign == expected);
    REQUIRE(orient2dFiltered(b, a, c).sign == -expected);
  }
  CHECK(zeros > 10000);
}

TEST_CASE("near a line the plain formula is wrong and the filtered one is not") {
  // The grid of Kettner and others: points around (0.5, 0.5), and a line through 12 and 24.
  int wrong = 0;
  const Vector2 q(12, 12), r(24, 24);
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const Vector2 p(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
      // Coming from below the diagonal, the way from p to q to r turns to the right.
      const int expected = (p.x() < p.y()) - (p.x() > p.y());
      const int got = orient2dFiltered(p, q, r).sign;
      REQUIRE(got == expected);
      const Real plain = orient2d<Real>(p, q, r);
      wrong += (plain > 0) - (plain < 0) != got;
    }
  }
  CHECK(wrong > 1000);
}

TEST_CASE("coordinates from the smallest to the largest are judged") {
  for (const int power : {-1000, -500, 0, 500, 1000}) {
    const Real s = std::ldexp(1.0, power);
    CHECK(orient2dFiltered({0, 0}, {3 * s, s}, {9 * s, 3 * s}).sign == 0);
    CHECK(orient2dFiltered({0, 0}, {3 * s, s}, {9 * s, std::nextafter(3 * s, 4 * s)}).sign == 1);
    CHECK(orient2dFiltered({0, 0}, {3 * s, s}, {9 * s, std::nextafter(3 * s, s)}).sign == -1);
    CHECK(inCircle({s, 0}, {0, s}, {-s, 0}, {0, -s}).sign == 0);
    CHECK(inCircle({s, 0}, {0, s}, {-s, 0}, {0, -std::nextafter(s, 0.0)}).sign == 1);
    CHECK(inCircle({s, 0}, {0, s}, {-s, 0}, {0, -std::nextafter(s, 2 * s)}).sign == -1);
  }
  CHECK(orient2dFiltered({0, 0}, {1, 1e-200}, {2, 3e-200}).sign == 1);
  CHECK(orient2dFiltered({0, 1}, {1, 1}, {2, 1 + 0x1p-52}).sign == 1);
}

TEST_CASE("coordinates of very different sizes: the filter never contradicts the exact sign") {
  Random random(84);
  const auto any = [&random] {
    const Real x = std::ldexp(random.between(-1, 1), random.integer(-280, 280));
    return random.integer(0, 3) == 0 ? 0 : x;
  };
  for (int i = 0; i < 50000; ++i) {
    std::array<Vector3, 4> p;
    for (Vector3& corner : p) {
      for (Real& x : corner) x = any();
    }
    const auto& [o, a, b, c] = p;
    const Real volume = exactTetrahedronDeterminant(o, a, b, c);
    REQUIRE(orientation(o, a, b, c) == (volume > 0) - (volume < 0));
    const Vector2 u = o.head<2>(), v = a.head<2>(), w = b.head<2>();
    REQUIRE(orient2dFiltered(u, v, w).sign == exactOrient2d(u, v, w));
  }
}

TEST_CASE("the filter settles more than 999 of 1000 random points") {
  Random random(82);
  int left = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const Vector2 a = anyPoint(random, 1), b = anyPoint(random, 1), c = anyPoint(random, 1),
                  d = anyPoint(random, 1);
    left += !orient2dFiltered(a, b, c).filtered;
    left += !inCircle(a, b, c, d).filtered;
  }
  CHECK(left < kCount / 1000);
}

TEST_CASE("a circle: inside, outside and on it, as integers judge") {
  CHECK(inCircle({1, 0}, {0, 1}, {-1, 0}, {0, 0}).sign == 1);
  CHECK(inCircle({1, 0}, {-1, 0}, {0, 1}, {0, 0}).sign == -1);  // clockwise
  CHECK(inCircle({1, 0}, {0, 1}, {-1, 0}, {0, -1}).sign == 0);
  CHECK(inCircle({1, 0}, {0, 1}, {-1, 0}, {5, 5}).sign == -1);
  std::mt19937_64 engine(83);
  int zeros = 0;
  // x^2 + y^2 = 5^2 13^2 17^2 has many whole points; moved far away, all bits are used.
  const std::vector<Vector2> circle = {{1105, 0},   {943, 576},   {817, 744},   {264, 1073},
                                       {-744, 817}, {-576, -943}, {576, 943},   {-1073, 264},
                                       {47, 1104},  {1104, -47},  {-105, -1100}};
  for (int i = 0; i < 30000; ++i) {
    const auto pick = [&] { return circle[engine() % circle.size()]; };
    const Vector2 center = wholePoint(engine, static_cast<int>(engine() % 50) + 1);
    const Vector2 a = center + pick(), b = center + pick(), c = center + pick();
    Vector2 d = center + pick();
    if (engine() % 2) d.y() += static_cast<Real>(engine() % 3) - 1;
    const int expected = integerInCircle(a, b, c, d);
    zeros += expected == 0;
    REQUIRE(inCircle(a, b, c, d).sign == expected);
  }
  CHECK(zeros > 10000);
}

TEST_CASE("predicates refuse what is not a point") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_WITH(orient2dFiltered({0, 0}, {1, nan}, {2, 2}), "coordinate = nan must be finite");
  CHECK_THROWS_AS(inCircle({0, 0}, {1, nan}, {2, 2}, {3, 4}), InvalidInput);
  CHECK_THROWS_AS(exactOrient2d({1, 1}, {1e-300, 0}, {2, 2}), InvalidInput);
}

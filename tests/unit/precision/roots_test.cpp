// Roots of quadratics and cubics, judged by exact signs of polynomials with whole coefficients.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/precision/cubic_roots.hpp"
#include "carom/precision/difference_of_products.hpp"
#include "carom/precision/exact_sum.hpp"
#include "carom/precision/stable_quadratic.hpp"
#include "carom/precision/ulp_distance.hpp"
#include "exact_integers.hpp"
#include "support/catch.hpp"

using namespace carom;
using precision_test::Integer;

namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

int signOf(Integer value) {
  return (value > 0) - (value < 0);
}

int exactSign(const std::array<Real, 4>& c, Real x) {
  ExactSum sum;
  sum.add(c[0]);
  sum.addProduct(c[1], x, 1);
  sum.addProduct(c[2], x, x);
  sum.addProduct(c[3], x, x, x);
  return sum.sign();
}

// k (x - r)(x - s)(x - t): whole numbers, exact.
std::array<Real, 4> withRoots(Real k, Real r, Real s, Real t) {
  return {-k * r * s * t, k * (r * s + s * t + t * r), -k * (r + s + t), k};
}

void checkBrackets(const std::array<Real, 4>& c, const CubicRoots& roots) {
  Real last = -kInfinity;
  for (int i = 0; i < roots.count; ++i) {
    const RootBracket& root = roots.roots[static_cast<std::size_t>(i)];
    REQUIRE(root.low >= last);
    last = root.high;
    if (root.low == root.high) {
      REQUIRE(exactSign(c, root.low) == 0);
    } else {
      REQUIRE(ulpDistance(root.low, root.high) == 1);
      if (root.crossing) REQUIRE(exactSign(c, root.low) * exactSign(c, root.high) == -1);
    }
  }
}

}  // namespace

TEST_CASE("quadratics of every kind") {
  QuadraticRoots r = stableQuadratic(1, -3, 2);
  CHECK((r.count == RootCount::two && r.first == 1 && r.second == 2));
  r = stableQuadratic(-1, 3, -2);
  CHECK((r.count == RootCount::two && r.first == 1 && r.second == 2));
  r = stableQuadratic(1, 2, 1);
  CHECK((r.count == RootCount::one && r.first == -1 && r.second == -1));
  CHECK(stableQuadratic(1, 2, 2).count == RootCount::none);
  r = stableQuadratic(0, 2, -3);
  CHECK((r.count == RootCount::one && r.first == 1.5 && r.second == 1.5));
  CHECK(stableQuadratic(0, 0, 3).count == RootCount::none);
  CHECK(stableQuadratic(0, 0, 0).count == RootCount::all);
  r = stableQuadratic(2, 0, -8);
  CHECK((r.count == RootCount::two && r.first == -2 && r.second == 2));
  r = stableQuadratic(2, 6, 0);
  CHECK((r.count == RootCount::two && r.first == -3 && r.second == 0));
  r = stableQuadratic(2, 0, 0);
  CHECK((r.count == RootCount::one && r.first == 0));
}

TEST_CASE("coefficients of any size are solved") {
  for (const Real size : {1e-300, 1e-150, 1e150, 1e300}) {
    const QuadraticRoots r = stableQuadratic(size, -3 * size, 2 * size);
    REQUIRE(r.count == RootCount::two);
    CHECK_THAT(r.first, carom_test::WithinRel(1, 4e-16));
    CHECK_THAT(r.second, carom_test::WithinRel(2, 4e-16));
  }
  // Roots of 1e-150 and 2e-150, of 1e150 and 2e150, of 1e-200 and 1e200.
  QuadraticRoots r = stableQuadratic(1, -3e-150, 2e-300);
  CHECK_THAT(r.first, carom_test::WithinRel(1e-150, 1e-15));
  CHECK_THAT(r.second, carom_test::WithinRel(2e-150, 1e-15));
  r = stableQuadratic(1, -3e150, 2e300);
  CHECK_THAT(r.first, carom_test::WithinRel(1e150, 1e-15));
  CHECK_THAT(r.second, carom_test::WithinRel(2e150, 1e-15));
  r = stableQuadratic(1, -1e200, 1);
  CHECK_THAT(r.first, carom_test::WithinRel(1e-200, 1e-15));
  CHECK_THAT(r.second, carom_test::WithinRel(1e200, 1e-15));
  CHECK_THROWS_WITH(stableQuadratic(1, kInfinity, 1), "b = inf must be finite");
}

TEST_CASE("how many roots a quadratic has is decided exactly") {
  std::mt19937_64 engine(72);
  int counts[3] = {};
  for (int i = 0; i < 20000; ++i) {
    // Near the border: b^2 is 4 a c, or one more or less than a multiple of it.
    const Real a = precision_test::whole(engine, 26), c = precision_test::whole(engine, 26);
    const Real b =
        std::floor(2 * std::sqrt(std::abs(a) * std::abs(c))) + static_cast<Real>(engine() % 3) - 1;
    if (a == 0) continue;
    const int sign = signOf(Integer(b) * Integer(b) - 4 * Integer(a) * Integer(c));
    const RootCount expected = sign < 0    ? RootCount::none
                               : sign == 0 ? RootCount::one
                                           : RootCount::two;
    REQUIRE(stableQuadratic(a, b, c).count == expected);
    ++counts[sign + 1];
  }
  CHECK((counts[0] > 1000 && counts[2] > 1000));
  for (int i = 0; i < 2000; ++i) {
    const Real p = precision_test::whole(engine, 25), q = precision_test::whole(engine, 25);
    if (p != 0) REQUIRE(stableQuadratic(p * p, 2 * p * q, q * q).count == RootCount::one);
  }
}

TEST_CASE("roots of quadratics are within three ulp of an exact change of sign") {
  Random random(73);
  for (int i = 0; i < 50000; ++i) {
    const auto coefficient = [&] {
      return std::ldexp(random.between(-1, 1), random.integer(-40, 40));
    };
    const Real a = coefficient(), b = coefficient(), c = coefficient();
    const QuadraticRoots r = stableQuadratic(a, b, c);
    if (r.count != RootCount::two) continue;
    REQUIRE(r.first <= r.second);
    for (const Real root : {r.first, r.second}) {
      Real below = root, above = root;
      for (int k = 0; k < 3; ++k) {
        below = std::nextafter(below, -kInfinity), above = std::nextafter(above, kInfinity);
      }
      REQUIRE(exactSign({c, b, a, 0}, below) * exactSign({c, b, a, 0}, above) <= 0);
    }
  }
}

TEST_CASE("cubics of every kind") {
  const auto whole = [](const CubicRoots& roots, const std::vector<Real>& expected) {
    if (roots.count != static_cast<int>(expected.size())) return false;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (roots.roots[i].low != expected[i] || roots.roots[i].high != expected[i]) return false;
    }
    return true;
  };
  CHECK(whole(cubicRoots(withRoots(1, 1, 2, 3), -10, 10), {1, 2, 3}));
  CHECK(whole(cubicRoots(withRoots(-7, 1, 2, 3), 1, 2), {1, 2}));
  CHECK(whole(cubicRoots(withRoots(1, 1, 2, 3), 1.5, 1.75), {}));
  CHECK(whole(cubicRoots(withRoots(1, 2, 2, 5), 0, 10), {2, 5}));     // touches at 2
  CHECK(whole(cubicRoots(withRoots(1, -3, -3, -3), -10, 10), {-3}));  // a triple root
  CHECK(whole(cubicRoots({1, 0, 0, 1}, -10, 10), {-1}));              // 1 + x^3
  CHECK(whole(cubicRoots({0, 0, 0, 5}, -1, 1), {0}));
  CHECK(whole(cubicRoots({2, -3, 1, 0}, -10, 10), {1, 2}));    // a quadratic
  CHECK(whole(cubicRoots({1, -2, 1, 0}, -10, 10), {1}));       // a square
  CHECK(whole(cubicRoots({1, 0, 1, 0}, -10, 10), {}));         // never
  CHECK(whole(cubicRoots({-3, 2, 0, 0}, -10, 10), {1.5}));     // a line
  CHECK(whole(cubicRoots({4, 0, 0, 0}, -10, 10), {}));         // a constant
  CHECK(whole(cubicRoots(withRoots(1, 4, 5, 6), 5, 5), {5}));  // an interval of one point
  const CubicRoots all = cubicRoots({0, 0, 0, 0}, 0, 1);
  CHECK((all.everywhere && all.count == 0));
}

TEST_CASE("no root of a cubic with whole roots is missed, also double ones") {
  Random random(74);
  for (int i = 0; i < 20000; ++i) {
    std::array<Real, 3> r{};
    const int size = random.integer(1, 12);
    for (Real& x : r) x = random.integer(-(1 << size), 1 << size);
    if (random.integer(0, 3) == 0) r[1] = r[0];
    const auto c = withRoots(random.integer(1, 9), r[0], r[1], r[2]);
    std::sort(r.begin(), r.end());
    const Real from = random.integer(-5000, 0), to = random.integer(0, 5000);
    const CubicRoots roots = cubicRoots(c, from, to);
    int next = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (r[k] < from || r[k] > to || (k > 0 && r[k] == r[k - 1])) continue;
      REQUIRE(next < roots.count);
      const RootBracket& root = roots.roots[static_cast<std::size_t>(next++)];
      REQUIRE((root.low == r[k] && root.high == r[k]));
    }
    REQUIRE(roots.count == next);
  }
}

TEST_CASE("cubics with any coefficients: brackets hold a change of sign and none is missed") {
  Random random(75);
  for (int i = 0; i < 20000; ++i) {
    std::array<Real, 4> c{};
    for (Real& x : c) x = std::ldexp(random.between(-1, 1), random.integer(-8, 8));
    if (random.integer(0, 4) == 0) c[3] = 0;
    const CubicRoots roots = cubicRoots(c, -2, 2);
    checkBrackets(c, roots);
    // Signs on a grid change exactly as often, modulo two, as there are brackets between.
    int k = 0, sign = exactSign(c, -2);
    for (int n = -63; n <= 64; ++n) {
      const Real x = n / 32.0;
      int crossings = 0;
      while (k < roots.count && roots.roots[static_cast<std::size_t>(k)].high < x) ++k, ++crossings;
      const int next = exactSign(c, x);
      if (next * sign < 0) REQUIRE(crossings % 2 == 1);
      if (next != 0) sign = next;
    }
  }
}

TEST_CASE("nearly double roots: two, one or none, as exact numbers say") {
  // (x - p)^2 (x - 3) + d with a dyadic p: a small d makes two roots near p, or none.
  Random random(76);
  for (int i = 0; i < 3000; ++i) {
    const Real p = random.integer(1, 1 << 12) / 4096.0;
    auto c = withRoots(1, p, p, 3);
    const Real d = std::ldexp(1.0, -random.integer(20, 50)) * (random.integer(0, 1) ? 1 : -1);
    c[0] += d;
    const CubicRoots roots = cubicRoots(c, 0, 2);
    checkBrackets(c, roots);
    // At p the cubic is d, and below 3 it falls away to either side of p.
    REQUIRE(exactSign(c, p) == (d > 0) - (d < 0));
    const bool crosses = d > 0;
    int expected = 0;
    if (crosses) {
      expected = (exactSign(c, 0) < 0) + (exactSign(c, 2) < 0);
    }
    REQUIRE(roots.count == expected);
  }
}

TEST_CASE("a cubic refuses what it cannot decide") {
  CHECK_THROWS_WITH(cubicRoots({1, 2, std::nan(""), 4}, 0, 1), "c2 = nan must be finite");
  CHECK_THROWS_WITH(cubicRoots({1, 2, 3, 4}, 1, 0), "to = 0 must not be below from = 1");
  CHECK_THROWS_AS(cubicRoots({1, 2, 3, 4}, 0, 1e40), InvalidInput);
  CHECK(cubicRoots({-1e-300, 1e-300, 0, 0}, 0, 10).roots[0].low == 1);
  CHECK(cubicRoots({-1e300, 1e300, 0, 1e300}, 0, 1).count == 1);
}

// Roots and signs of polynomials that are multiplied out from roots that are known.

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/toi/exact_polynomial.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

struct Fraction {
  int above, below;
};

// Doubles by hand: the largest that is not above n / d is found by trying.
Real roundedDown(const Fraction& f) {
  Real guess = Real(f.above) / f.below;
  const auto isAbove = [&](Real x) {
    return (WholeNumber::inUnits(x, -1074) * f.below - WholeNumber::inUnits(f.above, -1074))
               .sign() > 0;
  };
  while (isAbove(guess)) guess = std::nextafter(guess, -1);
  return guess;
}

// The product of (d t - n) and of a factor.
ExactPolynomial product(const std::vector<Fraction>& roots, int factor) {
  std::vector<WholeNumber> c = {factor};
  for (const Fraction& r : roots) {
    std::vector<WholeNumber> next(c.size() + 1);
    for (std::size_t i = 0; i < c.size(); ++i) {
      next[i] -= c[i] * r.above;
      next[i + 1] += c[i] * r.below;
    }
    c = next;
  }
  return ExactPolynomial(c);
}

std::vector<Real> roundedRoots(const ExactPolynomial& p) {
  std::vector<Real> times;
  for (ExactRoot& root : rootsInUnitInterval(p)) times.push_back(root.roundedDown());
  return times;
}

}  // namespace

TEST_CASE("the roots of a product are the roots of its factors, each once, rounded down") {
  Random random(21);
  for (int i = 0; i < 3000; ++i) {
    std::vector<Fraction> roots;
    for (int n = random.integer(0, 4); n > 0; --n) {
      const int below = random.integer(0, 1) ? 1 << random.integer(0, 10) : random.integer(1, 999);
      roots.push_back({random.integer(-below / 4, below + below / 4), below});
      if (random.integer(0, 4) == 0) roots.push_back(roots.back());  // a double root
    }
    std::vector<Real> expected;
    for (const Fraction& r : roots) {
      if (r.above >= 0 && r.above <= r.below) expected.push_back(roundedDown(r));
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    CAPTURE(i);
    REQUIRE(roundedRoots(product(roots, random.integer(0, 1) ? 7 : -3)) == expected);
  }
}

TEST_CASE("roots that are no fractions come out to the last digit") {
  // 2 t^2 = 1; 3 t^2 = 1; t^3 = 1/2
  CHECK(roundedRoots(ExactPolynomial({-1, 0, 2})) == std::vector<Real>{0.70710678118654746});
  CHECK(roundedRoots(ExactPolynomial({-1, 0, 3})) == std::vector<Real>{0.57735026918962573});
  CHECK(roundedRoots(ExactPolynomial({-1, 0, 0, 2})) == std::vector<Real>{0.79370052598409968});
  // The same twice, and with a root at each end.
  CHECK(roundedRoots(ExactPolynomial({1, 0, -4, 0, 4})) == std::vector<Real>{0.70710678118654746});
  CHECK(roundedRoots(ExactPolynomial({0, -1, 1})) == std::vector<Real>{0, 1});
  CHECK(roundedRoots(ExactPolynomial({1, 0, 1})).empty());
}

TEST_CASE("the sign of a polynomial at the root of another one is exact") {
  // At the square root of a half.
  std::vector<ExactRoot> roots = rootsInUnitInterval(ExactPolynomial({-1, 0, 2}));
  REQUIRE(roots.size() == 1);
  ExactRoot& root = roots.front();
  CHECK(root.signOf(ExactPolynomial()) == 0);
  CHECK(root.signOf(ExactPolynomial({5})) == 1);
  CHECK(root.signOf(ExactPolynomial({-1, 1})) == -1);
  CHECK(root.signOf(ExactPolynomial({0, -1, 0, 2})) == 0);  // t (2 t^2 - 1)
  // 2 t^2 - 1 moved by 2^-100, both ways.
  for (const int way : {-1, 1}) {
    WholeNumber one = 1;
    one <<= 100;
    CHECK(root.signOf(ExactPolynomial({WholeNumber(way) - one, 0, one + one})) == way);
  }
  // A thousand random pairs with one root in common, and with a root beside it.
  Random random(22);
  for (int i = 0; i < 1000; ++i) {
    const int below = random.integer(2, 500);
    const Fraction shared{random.integer(1, below - 1), below};
    const Fraction other{random.integer(-300, 700), 401}, third{random.integer(-300, 700), 409};
    for (ExactRoot& r : rootsInUnitInterval(product({shared, other}, 1))) {
      const bool isShared = r.signOf(product({shared}, 1)) == 0;
      const bool isOther = r.signOf(product({other}, 1)) == 0;
      REQUIRE((isShared || isOther));
      REQUIRE(r.signOf(product({shared, third}, 1)) ==
              r.signOf(product({shared}, 1)) * r.signOf(product({third}, 1)));
    }
  }
}

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/precision/compensated_sum.hpp"
#include "carom/precision/dot_product.hpp"
#include "carom/precision/exact_sum.hpp"
#include "carom/precision/lane_sum.hpp"
#include "carom/precision/neumaier_sum.hpp"
#include "carom/precision/sums.hpp"
#include "carom/precision/ulp_distance.hpp"
#include "exact_integers.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace precision_test;

namespace {

Real compensated(const std::vector<Real>& terms) {
  NeumaierSum sum;
  for (const Real term : terms) sum.add(term);
  return sum.value();
}

Real exact(const std::vector<Real>& terms) {
  ExactSum sum;
  for (const Real term : terms) sum.add(term);
  return sum.value();
}

}  // namespace

TEST_CASE("a compensated sum keeps what a plain sum loses") {
  CHECK(1 + 1e100 + 1 - 1e100 == 0);  // the plain sum
  CHECK(compensated({1, 1e100, 1, -1e100}) == 2);
  CHECK(compensated(std::vector<Real>(10, 0.1)) == 1);
  CHECK(compensated({}) == 0);
}

TEST_CASE("a tenth added ten million times is a million, to the last bit") {
  NeumaierSum sum;
  Real plain = 0;
  for (int i = 0; i < 10000000; ++i) {
    sum.add(0.1);
    plain += 0.1;
  }
  // 0.1 as a double is too large by 5.55e-18, which ten million times is half an ulp of a million.
  CHECK(std::abs(sum.value() - 1e6) <= 1.2e-10);
  CHECK(std::abs(plain - 1e6) > 1e-5);
}

TEST_CASE("sums made in parts and put together lose nothing") {
  NeumaierSum first, second;
  first.add(1e16);
  first.add(1);
  second.add(1);
  second.add(-1e16);
  first.add(second);
  CHECK(first.value() == 2);
}

TEST_CASE("a compensated sum of whole numbers agrees with integers of 128 bits") {
  std::mt19937_64 engine(31);
  for (int round = 0; round < 2000; ++round) {
    NeumaierSum sum;
    Integer reference = 0;
    for (int i = 0; i < 50; ++i) {
      const Real size = whole(engine, 53);
      const Real term = std::ldexp(size, static_cast<int>(engine() % 40));
      sum.add(term);
      reference += Integer(term);
    }
    // One rounding at the end; the errors collected are far below it.
    REQUIRE(magnitude(Integer(sum.value()) - reference) <= 0x1p-52L * magnitude(reference));
  }
}

TEST_CASE("an exact sum is right whatever cancels, and rounds once") {
  CHECK(exact({1e300, 1, -1e300, 1e-300, -1}) == 1e-300);
  CHECK(exact({0x1p53, 1, 0x1p-300}) == 0x1p53 + 2);  // just above a tie
  CHECK(exact({0x1p53, 1, -0x1p-300}) == 0x1p53);     // just below
  CHECK(exact({0x1p53, 1}) == 0x1p53);                // a tie goes to the even one
  CHECK(exact({0x1p53 + 2, 1}) == 0x1p53 + 4);
  CHECK(exact({-0x1p53, -1, -0x1p-300}) == -0x1p53 - 2);
  CHECK(exact({}) == 0);
  CHECK(exact({1, -1}) == 0);
}

TEST_CASE("the sign of an exact sum is that of its smallest remainder") {
  ExactSum sum;
  CHECK(sum.sign() == 0);
  for (const Real term : {1e308, 1.0, -5e-324, -1e308, -1.0}) sum.add(term);
  CHECK(sum.sign() == -1);
  CHECK(sum.value() == -5e-324);
  sum.add(5e-324);
  CHECK(sum.sign() == 0);
  sum.add(5e-324);
  CHECK(sum.sign() == 1);
}

TEST_CASE("an exact sum of numbers that cancel in pairs is zero, in any order") {
  std::mt19937_64 engine(32);
  for (int round = 0; round < 200; ++round) {
    std::vector<Real> terms;
    for (int i = 0; i < 30; ++i) {
      const Real size = whole(engine, 53);
      const Real term = std::ldexp(size, static_cast<int>(engine() % 1800) - 900);
      terms.push_back(term);
      terms.push_back(-term);
    }
    std::shuffle(terms.begin(), terms.end(), engine);
    REQUIRE(exact(terms) == 0);
    terms.push_back(1e-290);
    std::shuffle(terms.begin(), terms.end(), engine);
    REQUIRE(exact(terms) == 1e-290);
  }
}

TEST_CASE("an exact sum of whole numbers agrees with integers of 128 bits") {
  std::mt19937_64 engine(33);
  for (int round = 0; round < 2000; ++round) {
    ExactSum sum;
    Integer reference = 0;
    for (int i = 0; i < 20; ++i) {
      const Real a = whole(engine, 40), b = whole(engine, 40), c = whole(engine, 40);
      sum.addProduct(a, b, c);
      reference += Integer(a) * Integer(b) * Integer(c);
    }
    REQUIRE(sum.value() == static_cast<Real>(reference));  // gcc and clang round to nearest
    REQUIRE(sum.sign() == (reference > 0) - (reference < 0));
  }
}

TEST_CASE("a compensated dot product survives cancellation") {
  const std::array<Real, 3> a{1e13, 3, -1e13}, b{1e12, 7, 1e12};
  CHECK(compensatedDot(a, b) == 21);
  CHECK(compensatedDot(Vector3(1 + 0x1p-52, -1, 0x1p-60), Vector3(1 - 0x1p-52, 1, 0)) == -0x1p-104);
  CHECK(compensatedDot(std::span<const Real>(), std::span<const Real>()) == 0);
}

TEST_CASE("a compensated dot product of whole numbers agrees with integers of 128 bits") {
  std::mt19937_64 engine(34);
  for (int round = 0; round < 2000; ++round) {
    std::array<Real, 30> a{}, b{};
    Integer reference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = whole(engine, 53);
      b[i] = whole(engine, 53);
      reference += Integer(a[i]) * Integer(b[i]);
    }
    REQUIRE(magnitude(Integer(compensatedDot(a, b)) - reference) <=
            0x1p-52L * magnitude(reference));
  }
}

TEST_CASE("a dot product of lists of different length is refused") {
  const std::array<Real, 3> a{1, 2, 3};
  const std::array<Real, 2> b{1, 2};
  CHECK_THROWS_WITH(compensatedDot(a, b), "length of b = 2 must be the length of a, 3");
}

TEST_CASE("sums in lanes of any number of terms are the exact sum, rounded once") {
  Random random(35);
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 63u, 64u, 1000u, 10000000u}) {
    std::vector<Real> terms(count);
    for (Real& term : terms) {
      term = std::ldexp(random.between(-1, 1), random.integer(-30, 30));
    }
    const Real reference = exact(terms);
    CHECK(ulpDistance(compensatedSumInLanes(terms), reference) <= 1);
    CHECK(ulpDistance(compensatedSum(terms), reference) <= 1);
    if (count > 1000) CHECK(ulpDistance(plainSum<Real>(terms), reference) > 100);
  }
}

TEST_CASE("the errors of pairwise and of Kahan's sum stay small where the plain sum's grows") {
  const std::vector<float> tenths(10000000, 0.1f);
  const auto error = [](float sum) { return std::abs(Real(sum) / (1e7 * Real(0.1f)) - 1); };
  const std::span<const float> terms = tenths;
  CHECK(error(plainSum(terms)) > 0.05);
  CHECK(error(pairwiseSum(terms)) < 2e-6);
  CHECK(error(kahanSum(terms)) < 1.2e-7);
  // Neumaier's error has a part that grows with the square of n: not for so many floats.
  CHECK(error(neumaierSum(terms)) > 1e-3);
  const float few = neumaierSum(terms.first(10000));
  CHECK(std::abs(Real(few) / (1e4 * Real(0.1f)) - 1) < 6.1e-8);
}

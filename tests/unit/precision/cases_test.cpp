// The cases of tests/cases/precision.json, each to the error that an excellent library reaches.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/precision/cell_position.hpp"
#include "carom/precision/compensated_sum.hpp"
#include "carom/precision/difference_of_products.hpp"
#include "carom/precision/dot_product.hpp"
#include "carom/precision/exact_sum.hpp"
#include "carom/precision/float_bits.hpp"
#include "carom/precision/float_ulp_distance.hpp"
#include "carom/precision/lane_sum.hpp"
#include "carom/precision/relative_to_origin.hpp"
#include "carom/precision/stable_quadratic.hpp"
#include "carom/precision/steps_until.hpp"
#include "carom/precision/sums.hpp"
#include "carom/precision/time_of_step.hpp"
#include "carom/precision/ulp.hpp"
#include "carom/precision/ulp_distance.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using namespace carom;
using carom_test::json;
using carom_test::number;
using carom_test::readCase;

namespace {

json precisionCase(const std::string& name) {
  return readCase("precision", name);
}

template <class Number>
std::span<const Number> view(const std::vector<Number>& terms) {
  return terms;
}

Real exactSum(const std::vector<Real>& terms) {
  ExactSum sum;
  for (const Real term : terms) sum.add(term);
  return sum.value();
}

// The generator of the case book.
class Lcg {
 public:
  explicit Lcg(std::uint64_t seed) : state_(seed) {}
  std::int64_t next() {
    state_ = 6364136223846793005u * state_ + 1442695040888963407u;
    return static_cast<std::int64_t>(state_ >> 33);
  }

 private:
  std::uint64_t state_;
};

struct Clock {
  int steps = 0;
  Real time = 0;
};

template <class Number>
Clock addedUp(Number dt, Number end) {
  Clock clock;
  Number t = 0;
  while (t < end) t += dt, ++clock.steps;
  clock.time = t;
  return clock;
}

}  // namespace

TEST_CASE("F1: 0.1 + 0.2 is 0.3 in floats and not in doubles") {
  const json expected = precisionCase("F1");
  CHECK(0.1 + 0.2 == number(expected["double_sum"]));
  CHECK(0.3 == number(expected["double_three_tenths"]));
  CHECK(ulpDistance(0.1 + 0.2, 0.3) == 1);
  volatile float tenth = 0.1f, fifth = 0.2f;
  const float sum = tenth + fifth;
  CHECK(Real(sum) == number(expected["float_sum"]));
  CHECK(Real(0.3f) == number(expected["float_three_tenths"]));
  CHECK(floatUlpDistance(sum, 0.3f) == 0);
}

TEST_CASE("F2: a clock that counts is right where one that adds is not") {
  const json expected = precisionCase("F2");
  for (const json& row : expected["rows"]) {
    const Real dt = number(row["dt"]), end = number(row["end"]);
    CAPTURE(dt, row["type"]);
    const Clock wrong = row["type"] == "float"
                            ? addedUp(static_cast<float>(dt), static_cast<float>(end))
                            : addedUp(dt, end);
    CHECK(wrong.steps == row["steps"].get<int>());
    CHECK(wrong.time == number(row["clock"]));
    const std::int64_t steps = stepsUntil(end, dt);
    CHECK(steps == row["right_steps"].get<std::int64_t>());
    CHECK(ulpDistance(timeOfStep(steps, dt, 0), end) <= 1);
  }
  const auto stands = static_cast<float>(number(expected["float_clock_stands_at"]));
  volatile float next = stands + 1 / 60.0f;
  CHECK(next == stands);
  next = stands / 2 + 1 / 60.0f;
  CHECK(next > stands / 2);
}

TEST_CASE("F3: compensated sums are right to the last digit") {
  const json expected = precisionCase("F3");
  const std::vector<Real> tenths(1000000, 0.1);
  CHECK(plainSum(view(tenths)) == number(expected["a_plain"]));
  CHECK(plainSum(view(std::vector<float>(1000000, 0.1f))) == number(expected["a_plain_float"]));
  CHECK(exactSum(tenths) == number(expected["a_exact"]));

  Lcg lcg(21);
  std::vector<Real> mixed;
  for (int i = 0; i < 100000; ++i) {
    const Real m = static_cast<Real>(lcg.next() - (1 << 30)) / (1 << 30);
    mixed.push_back(std::ldexp(m, static_cast<int>(lcg.next() % 60) - 30));
  }
  for (std::size_t i = 0; i < 100000; i += 2) mixed.push_back(-mixed[i]);
  CHECK(plainSum(view(mixed)) == number(expected["b_plain"]));
  CHECK(exactSum(mixed) == number(expected["b_exact"]));

  std::vector<Real> harmonic;
  for (int k = 1; k <= 1000000; ++k) harmonic.push_back(1.0 / k);
  CHECK(plainSum(view(harmonic)) == number(expected["c_plain"]));
  CHECK(exactSum(harmonic) == number(expected["c_exact"]));

  for (const auto& terms : {tenths, mixed, harmonic}) {
    CHECK(ulpDistance(compensatedSum(terms), exactSum(terms)) <= 1);
    CHECK(ulpDistance(compensatedSumInLanes(terms), exactSum(terms)) <= 1);
    CHECK(ulpDistance(neumaierSum(view(terms)), exactSum(terms)) <= 1);
  }
  CHECK(ulpDistance(kahanSum(view(tenths)), 1e5) <= 1);
  CHECK(ulpDistance(kahanSum(view(harmonic)), exactSum(harmonic)) <= 1);
}

TEST_CASE("F4: a quadratic keeps its small root, and a discriminant its digits") {
  const json expected = precisionCase("F4");
  const QuadraticRoots roots = stableQuadratic(1, -1e8, 1);
  REQUIRE(roots.count == RootCount::two);
  CHECK(ulpDistance(roots.first, number(expected["small_root"])) <= 1);
  CHECK((1e8 - std::sqrt(1e16 - 4)) / 2 == number(expected["textbook_root"]));

  const Real a = number(expected["a"]), b = number(expected["b"]), c = number(expected["c"]);
  volatile Real bb = b * b, ac = a * c;
  CHECK(bb - ac == 0);
  CHECK(differenceOfProducts(b, b, a, c) == number(expected["difference"]));
  // The same as the discriminant of a x^2 + 2 b x + c: its roots are 3e-8 apart.
  const QuadraticRoots near = stableQuadratic(a, 2 * b, c);
  REQUIRE(near.count == RootCount::two);
  // -(b - 11/8) / a and -(b + 11/8) / a.
  CHECK(ulpDistance(near.first, -(b + 1.375) / a) <= 1);
  CHECK(ulpDistance(near.second, -(b - 1.375) / a) <= 1);
}

TEST_CASE("F5: floats lose their step far away, cells do not") {
  const json expected = precisionCase("F5");
  for (const json& row : expected["spacing"]) {
    const Real far = std::ldexp(1.0, row["power"].get<int>());
    CHECK(Real(ulp(static_cast<float>(far))) == number(row["float"]));
    CHECK(ulp(far) == number(row["double"]));
  }
  for (const json& row : expected["float_moves"]) {
    const auto speed = static_cast<float>(number(row["speed"]));
    const float start = 131072, dt = 1 / 60.0f;
    volatile float x = start;
    for (int i = 0; i < 600; ++i) x = x + speed * dt;
    CHECK(Real(x - start) == number(row["moved"]));
  }
  // At 1e7 m, in cells: to 1e-9 m, and in floats to the digits of a cell.
  for (const Real speed : {0.6, 0.4}) {
    const CellPosition start = cellPosition({1e7, -1e7, 123.25});
    CellPosition p = start;
    FloatCellPosition q{start.cell, start.offset.cast<float>()};
    const FloatCellPosition startInFloats = q;
    for (int i = 0; i < 600; ++i) {
      p = moved(p, Vector3(speed / 60, 0, 0));
      q = moved(q, Eigen::Vector3f(static_cast<float>(speed / 60), 0, 0));
    }
    CHECK_THAT(relativeToOrigin(p, start).x(), carom_test::WithinAbs(10 * speed, 1e-9));
    CHECK_THAT(relativeToOrigin(inDoubles(q), inDoubles(startInFloats)).x(),
               carom_test::WithinAbs(10 * speed, 0.02));
  }
}

TEST_CASE("F6: vectors of any length are brought to length one") {
  for (const int power : {-660, 660, -1060}) {
    const Vector3 v(std::ldexp(3.0, power), std::ldexp(4.0, power), 0);
    const Vector3 scaled = scaledToOne(v);
    const Vector3 unit = scaled / length(scaled);
    CHECK(ulpDistance(unit.x(), 0.6) <= 1);
    CHECK(ulpDistance(unit.y(), 0.8) <= 1);
    CHECK(unit.z() == 0);
  }
}

TEST_CASE("F7: small angles between unit vectors") {
  const json expected = precisionCase("F7");
  for (const json& text : expected["angles"]) {
    const Real angle = number(text);
    const Vector3 a(1, 0, 0), b(cosine(angle), sine(angle), 0);
    const Real got = arctangent2(length(compensatedCross(a, b)), compensatedDot(a, b));
    CHECK_THAT(got, carom_test::WithinRel(angle, 1e-15));
  }
}

TEST_CASE("F8: a compensated sum is the same in every order") {
  std::array<Real, 3> terms = {-1e16, 1, 1e16};
  bool plainLost = false;
  do {
    CHECK(compensatedSum(terms) == 1);
    CHECK(compensatedSumInLanes(terms) == 1);
    plainLost = plainLost || plainSum<Real>(terms) == 0;
  } while (std::next_permutation(terms.begin(), terms.end()));
  CHECK(plainLost);
}

TEST_CASE("F9: large angles, and an angle that is counted") {
  const json expected = precisionCase("F9");
  CHECK_THAT(sine(7e6), carom_test::WithinAbs(number(expected["sine_7e6"]), 1e-15));
  CHECK_THAT(cosine(7e9), carom_test::WithinAbs(number(expected["cosine_7e9"]), 1e-15));
  const Real angle = number(expected["angle"]), step = 7 * (1 / 60.0);
  const std::vector<Real> steps(1000000, step);
  CHECK_THAT(compensatedSum(steps), carom_test::WithinRel(angle, 1e-15));
  CHECK_THAT(timeOfStep(1000000, step, 0), carom_test::WithinRel(angle, 1e-15));
  CHECK(std::abs(plainSum(view(steps)) - angle) > 1e-6);
  CHECK(std::abs(plainSum(view(steps)) - angle) < 1e-16 * 1e6 * angle);
}

TEST_CASE("F10: how many digits there are") {
  const json expected = precisionCase("F10");
  CHECK_THAT(24 * std::log10(2.0), carom_test::WithinRel(number(expected["log10_2_24"]), 1e-15));
  CHECK_THAT(53 * std::log10(2.0), carom_test::WithinRel(number(expected["log10_2_53"]), 1e-15));
  CHECK(bitsOf(1.0f).fractionBits + 1 == 24);
  CHECK(bitsOf(1.0).fractionBits + 1 == 53);
  // Up to the first whole number that is missing, every one is there.
  const auto first = expected["first_not_in_float"].get<std::int32_t>();
  CHECK(static_cast<std::int32_t>(static_cast<float>(first)) != first);
  CHECK(static_cast<std::int32_t>(static_cast<float>(first - 1)) == first - 1);
  CHECK(ulp(static_cast<float>(first - 2)) == 1);
  const auto last = expected["first_not_in_double"].get<std::int64_t>();
  CHECK(static_cast<std::int64_t>(static_cast<Real>(last)) != last);
  CHECK(static_cast<std::int64_t>(static_cast<Real>(last - 1)) == last - 1);
  CHECK(ulp(static_cast<Real>(last - 2)) == 1);
  // What a number is written with so that it reads back, and what is safe the other way.
  CHECK(std::numeric_limits<float>::max_digits10 == 9);
  CHECK(std::numeric_limits<float>::digits10 == 6);
}

TEST_CASE("F11: the cross product of nearly parallel vectors") {
  const json expected = precisionCase("F11")["cross"];
  const Vector3 u(1, 1 + 0x1p-30, 1), w(1 + 0x1p-30, 1 + 0x1p-29, 1 - 0x1p-40);
  const Vector3 cross = compensatedCross(u, w);
  for (int i = 0; i < 3; ++i) {
    CHECK(ulpDistance(cross(i), number(expected[static_cast<std::size_t>(i)])) <= 1);
  }
  volatile Real left = u.x() * w.y(), right = u.y() * w.x();
  CHECK(left - right == 0);
}

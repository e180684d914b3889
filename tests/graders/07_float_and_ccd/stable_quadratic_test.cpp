// Grader of 07.stable_quadratic: the roots are chosen first, in short binary numbers, so that the
// coefficients a, -a (r + s) and a r s need no rounding; or the roots differ so much in size that
// three terms of a series give them to all digits.

#include "carom/precision/stable_quadratic.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/random.hpp"
#include "grading/fields_precision.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kDigits = "a few units in the last place";
constexpr Real kFew = 1e-15;

struct Equation {
  Real a, b, c;
  QuadraticRoots roots;
};

Equation withRoots(Real a, Real r, Real s) {
  return {a,
          -a * (r + s),
          a * r * s,
          {r == s ? RootCount::one : RootCount::two, std::min(r, s), std::max(r, s)}};
}

// With t = a c / b^2 small, the small root is -c/b (1 + t + 2 t^2 + ...), and both add up to -b/a.
Equation farApart(Random& random) {
  const auto any = [&] { return random.between(1, 9) * (random.integer(0, 1) ? 1 : -1); };
  const Real a = any(), b = any() * random.between(1e4, 1e6), c = any();
  const Real t = a * c / (b * b);
  const Real small = -c / b * (1 + t + 2 * t * t), large = -b / a * (1 - t - t * t);
  return {a, b, c, {RootCount::two, std::min(small, large), std::max(small, large)}};
}

// Roots 1 + m / 2^22 that are a few steps of 2^-22 apart: b and 4 a c have no more than 53 digits,
// but b^2 has.
Equation nearlyEqual(Random& random) {
  const Real r = 1 + random.integer(1, (1 << 22) - 10) * 0x1p-22;
  return withRoots(2 * random.integer(8, 15) + 1, r, r + 0x1p-22 * random.integer(1, 4));
}

// The roots are graded one by one, since one may be much smaller than the other.
void ask(const Equation& e, const char* what) {
  GRADE(stableQuadratic(e.a, e.b, e.c), e.roots, withinRelative(kFew, kDigits), given("a", e.a),
        given("b", e.b), given("c", e.c), about(what));
  GRADE(stableQuadratic(e.a, e.b, e.c).first, e.roots.first, withinRelative(kFew, kDigits),
        given("a", e.a), given("b", e.b), given("c", e.c),
        about("the smaller root of the same equation"));
  GRADE(stableQuadratic(e.a, e.b, e.c).second, e.roots.second, withinRelative(kFew, kDigits),
        given("a", e.a), given("b", e.b), given("c", e.c),
        about("the larger root of the same equation"));
}

Real eighths(Random& random, int size) {
  return random.integer(1, size) / 8.0 * (random.integer(0, 1) ? 1 : -1);
}

}  // namespace

TEST_CASE("plain") {
  ask(withRoots(1, 1, 2), "x^2 - 3 x + 2 = 0");
  ask(withRoots(-2, -3, 0.5), "-2 x^2 - 5 x + 3 = 0");
  GRADE(stableQuadratic(1, 2, 5), QuadraticRoots{}, within(0, "exactly"), given("a", 1.0),
        given("b", 2.0), given("c", 5.0), about("a parabola that stays above zero"));
  Random random(seed());
  for (int n = 0; n < 8; ++n) {
    ask(withRoots(eighths(random, 40), eighths(random, 300), eighths(random, 300)),
        "any quadratic with roots that are multiples of 1/8");
  }
}

TEST_CASE("small") {
  Random random(seed() + 1);
  for (int n = 0; n < 8; ++n) {
    ask(farApart(random), "one root is thousands of millions of times as large as the other");
  }
}

TEST_CASE("near") {
  Random random(seed() + 2);
  for (int n = 0; n < 8; ++n) {
    ask(nearlyEqual(random), "two roots, equal in their first six digits");
  }
  const Real r = 1 + random.integer(1, 1000) * 0x1p-10;
  const Equation twice = withRoots(3, r, r);
  GRADE(stableQuadratic(twice.a, twice.b, twice.c), twice.roots, withinRelative(kFew, kDigits),
        given("a", twice.a), given("b", twice.b), given("c", twice.c),
        about("two roots that are equal"));
}

TEST_CASE("degenerate") {
  GRADE(stableQuadratic(0, 4, -6), (QuadraticRoots{RootCount::one, 1.5, 1.5}), within(0, "exactly"),
        given("a", 0.0), given("b", 4.0), given("c", -6.0), about("a line"));
  ask({2, 0, -8, {RootCount::two, -2, 2}}, "no term with x");
  GRADE(stableQuadratic(2, -6, 0), (QuadraticRoots{RootCount::two, 0, 3}), within(0, "exactly"),
        given("a", 2.0), given("b", -6.0), given("c", 0.0), about("no constant term"));
  GRADE(stableQuadratic(0, 0, 0), (QuadraticRoots{RootCount::all, 0, 0}), within(0, "exactly"),
        given("a", 0.0), given("b", 0.0), given("c", 0.0), about("nothing at all"));
  GRADE(stableQuadratic(0, 0, 7), QuadraticRoots{}, within(0, "exactly"), given("a", 0.0),
        given("b", 0.0), given("c", 7.0), about("7 = 0"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(stableQuadratic(1, std::nan(""), 1), given("b", std::nan("")));
}

PROBES() {
  Random random(703);
  const auto probe = [](const Equation& e) { PROBE(stableQuadratic(e.a, e.b, e.c)); };
  for (int n = 0; n < 8; ++n) {
    probe(withRoots(eighths(random, 40), eighths(random, 300), eighths(random, 300)));
    // The gap between two roots that are nearly equal, in parts of which it has a whole number.
    const Equation near = nearlyEqual(random);
    const auto gap = [&near] {
      const QuadraticRoots roots = stableQuadratic(near.a, near.b, near.c);
      return std::round((roots.second - roots.first) * 0x1p32);
    };
    PROBE(gap());
    // The small root alone: beside the large one its error would not be seen.
    const Equation e = farApart(random);
    PROBE(std::abs(stableQuadratic(e.a, e.b, e.c).first));
    PROBE(std::abs(stableQuadratic(e.a, e.b, e.c).second));
  }
  probe({0, 4, -6, {}});
  probe({2, 0, -8, {}});
}

// Grader of 07.orient2d_filtered: points are put on a line, or one step beside it, in numbers
// short enough that this is known.

#include "carom/precision/orient2d_filtered.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "carom/core/random.hpp"
#include "carom/precision/exact_determinant.hpp"
#include "grading/fields_precision.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kSign = "a sign has no rounding";

struct Triple {
  Vector2 a, b, c;
  int side = 0;
};

// A vector w with det(u, w) = 1, for u = (p, q) without a common divisor (Euclid).
Vector2 partner(std::int64_t p, std::int64_t q) {
  std::int64_t x = 1, y = 0, nextX = 0, nextY = 1;
  while (q != 0) {
    const std::int64_t times = p / q;
    p = std::exchange(q, p - times * q);
    x = std::exchange(nextX, x - times * nextX);
    y = std::exchange(nextY, y - times * nextY);
  }
  return {static_cast<Real>(-y), static_cast<Real>(x)};  // x p + y q = 1
}

// Whole coordinates up to 2^40: the triangle's doubled area is -1, 0 or 1, and the products of
// which it is the difference are 2^70.
Triple beside(Random& random, int side) {
  std::int64_t p = 0, q = 0;
  while (std::gcd(p, q) != 1) {
    p = std::int64_t{random.integer(1 << 16, 1 << 17)} * (1 << 17) + random.integer(0, 1 << 17);
    q = std::int64_t{random.integer(1 << 16, 1 << 17)} * (1 << 17) + random.integer(0, 1 << 17);
  }
  const Vector2 u(static_cast<Real>(p), static_cast<Real>(q)), w = partner(p, q);
  const Vector2 a(random.integer(-(1 << 30), 1 << 30), random.integer(-(1 << 30), 1 << 30));
  return {a, a + u, a + random.integer(2, 9) * u + side * w, side};
}

// A point far along the line through two others, rounded: within a step of the line, and the
// differences of the coordinates are rounded too. The side is known from the tetrahedron over it.
Triple rounded(Random& random, Real size) {
  const auto point = [&] { return Vector2(size * random.vector().head<2>()); };
  const Vector2 a = point(), b = point();
  const Vector2 c = a + random.between(20, 30) * (b - a);
  const auto floor = [](const Vector2& p) { return Vector3(p.x(), p.y(), 0); };
  return {a, b, c, orientation(floor(a), floor(b), floor(c), Vector3(a.x(), a.y(), size))};
}

// Clearly to one side, at a scale: far more than rounding.
Triple clear(Random& random, Real size) {
  const Real angle = random.between(0, 6.28), turn = random.between(0.1, 3);
  const int side = random.integer(0, 1) ? 1 : -1;
  const Vector2 a(random.between(-size, size), random.between(-size, size));
  const auto at = [&](Real t) { return Vector2(a + size * Vector2(std::cos(t), std::sin(t))); };
  return {a, at(angle), at(angle + side * turn), side};
}

void askSign(const Triple& t, const char* what) {
  GRADE(orient2dFiltered(t.a, t.b, t.c).sign, t.side, within(0, kSign), given("a", t.a, "m"),
        given("b", t.b, "m"), given("c", t.c, "m"), about(what));
}

}  // namespace

TEST_CASE("sides") {
  askSign({{0, 0}, {1, 0}, {0, 1}, 1}, "to the left");
  askSign({{0, 0}, {1, 0}, {0, -1}, -1}, "to the right");
  Random random(seed());
  for (int n = 0; n < 10; ++n) askSign(clear(random, 1), "points some way off the line");
}

TEST_CASE("line") {
  askSign({{0.5, 0.5}, {12, 12}, {24, 24}, 0}, "three points of a line");
  askSign({{0.5, 0.5 + 0x1p-53}, {12, 12}, {24, 24}, 1}, "the first a step above the line");
  Random random(seed() + 1);
  for (int n = 0; n < 16; ++n) {
    askSign(beside(random, n % 3 - 1),
            "whole coordinates: on the line, or as near beside it as can be");
  }
  for (int n = 0; n < 50; ++n) {
    askSign(rounded(random, 1), "a point far along the line, rounded");
  }
}

TEST_CASE("sizes") {
  Random random(seed() + 2);
  for (const Real size : {0x1p-60, 0x1p-40, 0x1p-20, 0x1p20, 0x1p40}) {
    askSign(clear(random, size), "points some way off the line, small or large");
    for (int n = 0; n < 30; ++n) {
      askSign(rounded(random, size), "a point far along the line, rounded, small or large");
    }
  }
}

TEST_CASE("cheap") {
  Random random(seed() + 3);
  const auto needed = [&random](int count) {
    int exact = 0;
    for (int n = 0; n < count; ++n) {
      const Triple t = clear(random, std::ldexp(1.0, random.integer(-30, 30)));
      exact += !orient2dFiltered(t.a, t.b, t.c).filtered;
    }
    return exact;
  };
  const auto settled = [&needed](int count) { return count - needed(count); };
  GRADE(settled(200), 200, within(0, "a sign far beyond its error needs no exact numbers"),
        about("how many of 200 clear cases were settled by the rounded value"));
  const Triple onLine = beside(random, 0);
  const auto filtered = [&onLine] {
    return orient2dFiltered(onLine.a, onLine.b, onLine.c).filtered ? 2 : 3;
  };
  GRADE(filtered(), 3, within(0, "no rounded value can know that a point is on the line"),
        given("a", onLine.a, "m"), given("b", onLine.b, "m"), given("c", onLine.c, "m"),
        about("a point on the line: 2 if the filter claims to know, 3 if it asks"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(orient2dFiltered({0, 0}, {1, std::nan("")}, {1, 1}),
                given("b", Vector2(1, std::nan(""))));
}

PROBES() {
  Random random(706);
  for (int n = 0; n < 24; ++n) {
    const Triple on = beside(random, 0), off = beside(random, n % 2 ? 1 : -1);
    const Triple dust = rounded(random, 0x1p-60), rock = rounded(random, 1e9),
                 easy = clear(random, 1);
    PROBE(orient2dFiltered(on.a, on.b, on.c));
    PROBE(orient2dFiltered(off.a, off.b, off.c).sign);
    PROBE(orient2dFiltered(dust.a, dust.b, dust.c).sign);
    PROBE(orient2dFiltered(rock.a, rock.b, rock.c).sign);
    PROBE(orient2dFiltered(easy.a, easy.b, easy.c));
  }
}

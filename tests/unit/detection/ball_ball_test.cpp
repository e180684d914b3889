// Balls and circles, equations 20 to 22.

#include <cmath>
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/detection/ball_ball.hpp"
#include "carom/detection/gap_sign.hpp"
#include "detection_reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kUlp = 2.220446049250313e-16;

Verdict verdictOfSign(Real D) {
  if (D > 0) return Verdict::separated;
  return D < 0 ? Verdict::overlapping : Verdict::touching;
}

}  // namespace

TEST_CASE("D1: the three cases of figure 4, exactly") {
  const json all = detectionCase("D1");
  for (const json& row : all.at("rows")) {
    const Vector3 a = readVector(row["centerA"]), b = readVector(row["centerB"]);
    const Real r = readNumber(row["radii"][0]), s = readNumber(row["radii"][1]);
    const Real D = readNumber(row["D"]);
    CHECK(ballBall(a, r, b, s).separation == D);
    CHECK(ballBall(a, r, b, s).verdict == verdictOfSign(D));
    CHECK(ballBall(b, s, a, r).separation == D);
  }
}

TEST_CASE("D2: balls whose squares over- or underflow still touch") {
  for (const char* row : {"a", "b"}) {
    const json expected = detectionCase("D2")[row];
    const Real scale = std::ldexp(1.0, expected["pow2"].get<int>());
    const Vector3 b = scale * readVector(expected["centerB"]);
    const Real r = scale * readNumber(expected["radii"][0]);
    const Real s = scale * readNumber(expected["radii"][1]);
    const BallGap gap = ballBall({0, 0, 0}, r, b, s);
    CHECK(gap.separation == 0);
    CHECK(gap.verdict == Verdict::touching);
    CHECK(preciseGap({0, 0, 0}, r, b, s) == 0);
    // What equation 22 says as it is written: infinity, or an overlap that is not there.
    const Real written = std::sqrt(b.squaredNorm()) - r - s;
    CHECK_FALSE(written == 0);
  }
}

TEST_CASE("D2: a gap of 2^-26 m at 100,000 km from the origin is kept") {
  const json expected = detectionCase("D2")["c"];
  const Vector3 a = readVector(expected["centerA"]);
  const Vector3 b = a + Vector3(readNumber(expected["offset"]), 0, 0);
  CHECK(ballBall(a, 0.5, b, 0.5).separation == readNumber(expected["D"]));
  CHECK(ballBall(a, 0.5, b, 0.5).verdict == Verdict::separated);
}

TEST_CASE("D2: a gap of half an ulp has the right verdict, and its size when asked precisely") {
  const json expected = detectionCase("D2")["d"];
  const Real r = std::sqrt(3.0) / 2;
  const Real D = readNumber(expected["D"]);
  const BallGap gap = ballBall({0, 0, 0}, r, {1, 1, 1}, r);
  CHECK(gap.verdict == Verdict::separated);
  CHECK(std::abs(gap.separation - D) <= 1e-15 * (r + r));
  CHECK_THAT(preciseGap({0, 0, 0}, r, {1, 1, 1}, r), WithinRel(D, 4 * kUlp));
}

TEST_CASE("the exact sign of a gap agrees with whole numbers, which double computes exactly") {
  CaseNumbers random(31);
  int touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto small = [&] { return static_cast<Real>(random.next() % 13) - 6; };
    const Vector3 a(small(), small(), small()), b(small(), small(), small());
    const Real r = static_cast<Real>(random.next() % 5), s = static_cast<Real>(random.next() % 5);
    const Real exact = (b - a).squaredNorm() - (r + s) * (r + s);
    touching += exact == 0;
    const int sign = exact > 0 ? 1 : (exact < 0 ? -1 : 0);
    REQUIRE(gapSign(a, r, b, s) == sign);
    // Powers of two take the squares out of the range of doubles.
    REQUIRE(gapSign(0x1p600 * a, 0x1p600 * r, 0x1p600 * b, 0x1p600 * s) == sign);
    REQUIRE(gapSign(0x1p-600 * a, 0x1p-600 * r, 0x1p-600 * b, 0x1p-600 * s) == sign);
  }
  CHECK(touching > 50);
}

TEST_CASE("one ulp of a radius is the difference between touching and not") {
  const Real up = std::nextafter(3.0, 4.0), down = std::nextafter(3.0, 2.0);
  CHECK(gapSign({0, 0, 0}, 2, {3, 4, 0}, 3) == 0);
  CHECK(gapSign({0, 0, 0}, 2, {3, 4, 0}, up) == -1);
  CHECK(gapSign({0, 0, 0}, 2, {3, 4, 0}, down) == 1);
  CHECK_THAT(preciseGap({0, 0, 0}, 2, {3, 4, 0}, up), WithinRel(3 - up, 4 * kUlp));
}

TEST_CASE("balls with bad numbers are refused") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(ballBall({0, 0, nan}, 1, {0, 0, 0}, 1), InvalidInput);
  CHECK_THROWS_AS(ballBall({0, 0, 0}, -1, {0, 0, 0}, 1), InvalidInput);
  CHECK_THROWS_WITH(ballBall({0, 0, 0}, 1, {0, 0, 0}, nan), ContainsSubstring("radius of B"));
}

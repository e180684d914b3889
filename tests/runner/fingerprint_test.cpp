// When are two versions' answers to the probes the same?

#include <limits>

#include "runner/check.hpp"
#include "support/catch.hpp"

using carom::runner::sameAnswers;

namespace {

using Answers = std::vector<std::vector<double>>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("answers that differ by rounding alone are the same") {
  CHECK(sameAnswers({{1, 2}, {3}}, {{1, 2}, {3}}));
  CHECK(sameAnswers({{1 + 1e-12, 2}}, {{1, 2}}));
  CHECK(sameAnswers({{1e9 + 0.5, 2}}, {{1e9, 2}}));
  CHECK(sameAnswers({{0, 1}}, {{1e-12, 1}}));
}

TEST_CASE("answers that differ by more are not") {
  CHECK_FALSE(sameAnswers({{1 + 1e-8, 2}}, {{1, 2}}));
  CHECK_FALSE(sameAnswers({{1, 2}, {3}}, {{1, 2}, {4}}));
  CHECK_FALSE(sameAnswers({{1, 2}}, {{2, 1}}));
  // The scale is that of the probe, so a small probe is not lost beside a large one.
  CHECK_FALSE(sameAnswers({{1e12}, {1}}, {{1e12}, {2}}));
}

TEST_CASE("answers of different shape are never the same, and no answers are no sameness") {
  CHECK_FALSE(sameAnswers({{1, 2}}, {{1, 2}, {3}}));
  CHECK_FALSE(sameAnswers({{1, 2}}, {{1}}));
  CHECK_FALSE(sameAnswers({}, {}));
}

TEST_CASE("a value that is no number is the same only where the other is none") {
  CHECK(sameAnswers({{kNan, 1}}, {{kNan, 1}}));
  CHECK_FALSE(sameAnswers({{kNan, 1}}, {{0, 1}}));
  CHECK_FALSE(sameAnswers({{1, 1}}, {{kNan, 1}}));
  CHECK_FALSE(sameAnswers({{kInfinity}}, {{1}}));
}

TEST_CASE("zero is zero exactly where everything else in the probe is zero") {
  CHECK(sameAnswers({{0, 0}}, {{0, -0.0}}));
  CHECK_FALSE(sameAnswers({{1e-300}}, {{0}}));
}

// Grader of 04.tilted_contact: what a box of known width must show, and the slopes of both columns
// against the tilt.

#include "tilted_contact.hpp"

#include <cmath>

#include "grading/grade.hpp"
#include "tilted_contact_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

using Reals = std::vector<Real>;

// The row with a number, or one that nothing agrees with if there is none.
TiltedContact row(const std::vector<TiltedContact>& table, std::size_t number) {
  return number < table.size() ? table[number] : TiltedContact{-1, -1, -1};
}

// How many powers of ten a column grows by when the tilt grows by one.
Real slope(const std::vector<TiltedContact>& table, Real TiltedContact::*column) {
  const TiltedContact first = row(table, 0),
                      last = row(table, table.empty() ? 0 : table.size() - 1);
  return std::log(last.*column / first.*column) / std::log(last.tilt / first.tilt);
}

Reals tiltsFrom(Real start, int count, Real ratio) {
  Reals all;
  for (int k = 0; k < count; ++k) {
    all.push_back(start);
    start *= ratio;
  }
  return all;
}

}  // namespace

TEST_CASE("table") {
  const Reals tilts = {1e-8, 3e-7, 1e-7};
  GRADE(tiltedContact(1, 1e-6, tilts).size(), std::size_t{3}, within(0, "a count"),
        given("tilts", tilts, "rad"), about("one row for each tilt"));
  for (std::size_t k = 0; k < tilts.size(); ++k) {
    GRADE(row(tiltedContact(1, 1e-6, tilts), k).tilt, tilts[k], within(0, "a copy"),
          given("tilts", tilts, "rad"), given("row", k), unit("rad"));
  }
}

TEST_CASE("jump") {
  Random random(seed());
  for (int n = 0; n < 6; ++n) {
    const Real halfWidth = random.between(0.3, 4);
    const Reals tilts = tiltsFrom(1e-3 * random.between(0.1, 0.2), 4, 0.01);
    const std::size_t k = static_cast<std::size_t>(n % 4);
    GRADE(row(tiltedContact(halfWidth, 0.01, tilts), k).jump, 2 * halfWidth * std::cos(tilts[k]),
          within(1e-14, kRounding), given("half width", halfWidth, "m"), given("depth", 0.01, "m"),
          given("tilt", tilts[k], "rad"), unit("m"),
          about("from the right edge to the left edge, along x"));
  }
}

TEST_CASE("depths") {
  Random random(seed() + 1);
  for (int n = 0; n < 6; ++n) {
    const Real halfWidth = random.between(0.3, 4);
    const Reals tilts = tiltsFrom(1e-3 * random.between(0.1, 0.2), 4, 0.01);
    const std::size_t k = static_cast<std::size_t>(n % 4);
    GRADE(row(tiltedContact(halfWidth, 0.01, tilts), k).depthChange,
          2 * halfWidth * std::sin(tilts[k]), within(1e-16, "a rounding of the depth"),
          given("half width", halfWidth, "m"), given("depth", 0.01, "m"),
          given("tilt", tilts[k], "rad"), unit("m"),
          about("a point at one edge, from the tilt to the right to the tilt to the left"));
  }
}

TEST_CASE("slopes") {
  const Reals tilts = tiltsFrom(1e-9, 4, 10);
  GRADE(slope(tiltedContact(1, 1e-4, tilts), &TiltedContact::depthChange), 1,
        within(1e-3, "a straight line with both axes logarithmic"), given("tilts", tilts, "rad"),
        about("slope of the change of depth: ten times less tilt, ten times less change"));
  const TiltedContact least = row(tiltedContact(1, 1e-4, tilts), 0);
  GRADE(least.jump, 2, within(1e-6, "the cosine of so small an angle is 1"),
        given("tilt", least.tilt, "rad"), unit("m"),
        about("the jump does not care how small the tilt is"));
}

TEST_CASE("refuses") {
  const Reals steep = {1e-3};
  GRADE_REFUSES(tiltedContact(1, 1e-6, steep), given("tilts", steep, "rad"),
                about("one side would leave the floor"));
}

PROBES() {
  Random random(409);
  for (int n = 0; n < 16; ++n) {
    const Reals tilts = tiltsFrom(1e-3 * random.between(0.5, 0.9), 2, 0.5);
    const std::vector<TiltedContact> table = tiltedContact(random.between(0.3, 2), 0.01, tilts);
    // In units in which both columns are of order one.
    PROBE(Vector3(1e3 * row(table, 1).tilt, row(table, 1).jump, 1e3 * row(table, 1).depthChange));
  }
}

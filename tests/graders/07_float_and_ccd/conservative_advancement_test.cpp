// Grader of 07.conservative_advancement: gaps whose first contact can be written down, some of them
// so short that a step which is too long goes past them.

#include "carom/toi/conservative_advancement.hpp"

#include <algorithm>
#include <cmath>

#include "grading/fields_toi.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Gap = std::function<Real(Real)>;

// Closes at a steady speed, and goes on into an overlap.
Gap closing(Real start, Real speed) {
  return [=](Real t) { return start - speed * t; };
}
// A thing flies through a wall: the gap opens again on the other side. `deep` is the largest depth.
Gap through(Real start, Real speed, Real deep) {
  return [=](Real t) { return std::abs(start + deep - speed * t) - deep; };
}
// A pendulum whose lowest gap is height - swing.
Gap swinging(Real height, Real swing, Real rate) {
  return [=](Real t) { return height - swing * std::sin(rate * t); };
}
// Slow at first: closes as a stone falls, then stays fast; and passes through.
Gap fallingThrough(Real start, Real deep) {
  return [=](Real t) { return std::abs(start + deep - 5 * t * t) - deep; };
}

// How much later than the first contact.
Real late(const TimeOfImpact& hit, Real first) {
  return std::max(0.0, hit.time - first);
}

struct Search {
  Gap gap;
  Real fastest, duration, tolerance;
  const char* what;
};

TimeOfImpact run(const Search& s, int maxSteps = 5000) {
  return conservativeAdvancement(s.gap, s.fastest, s.duration, s.tolerance, maxSteps);
}

void askStatus(const Search& s, ImpactStatus expected, int maxSteps = 5000) {
  const Gap& gap = s.gap;
  const Real fastest = s.fastest, duration = s.duration, tolerance = s.tolerance;
  GRADE(conservativeAdvancement(gap, fastest, duration, tolerance, maxSteps).status, expected,
        within(0, "the status is one of four"), given("fastest", s.fastest, "m/s"),
        given("duration", s.duration, "s"), given("tolerance", s.tolerance, "m"),
        given("maxSteps", maxSteps), about(s.what));
}
// The first contact, and the speed with which the gap closes then.
void askHit(const Search& s, Real first, Real speed) {
  askStatus(s, ImpactStatus::kHit);
  const Gap& gap = s.gap;
  const Real fastest = s.fastest, duration = s.duration, tolerance = s.tolerance;
  GRADE(conservativeAdvancement(gap, fastest, duration, tolerance, 5000).time, first,
        within(1.1 * s.tolerance / speed + 1e-13, "what is left of the gap, divided by its speed"),
        given("fastest", s.fastest, "m/s"), given("duration", s.duration, "s"),
        given("tolerance", s.tolerance, "m"), unit("s"), about(s.what));
  GRADE(late(conservativeAdvancement(gap, fastest, duration, tolerance, 5000), first), 0,
        within(1e-12 * first, "it may be early, but never late"),
        given("fastest", s.fastest, "m/s"), given("duration", s.duration, "s"),
        given("tolerance", s.tolerance, "m"), unit("s"), about(s.what));
}

}  // namespace

TEST_CASE("safe") {
  askHit({closing(10, 4), 4, 5, 1e-6, "10 m that close at 4 m/s: gap(t) = 10 - 4 t"}, 2.5, 4);
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Real start = random.between(5, 20), speed = random.between(20, 90);
    askHit({through(start, speed, 0.006), random.between(1.05, 1.7) * speed, 5, 1e-6,
            "a bullet through a wall of 12 mm: the gap opens again behind it"},
           start / speed, speed);
  }
  for (int n = 0; n < 3; ++n) {
    const Real height = random.between(0.6, 0.9), rate = random.between(1, 3);
    const Real angle = std::asin(height);
    askHit({swinging(height, 1, rate), rate, 3, 1e-8, "a pendulum: gap(t) = h - sin(w t)"},
           angle / rate, rate * std::cos(angle));
  }
  askHit({fallingThrough(20, 0.05), 100, 10, 1e-6,
          "a stone falls 20 m through a table of 10 cm: slow at first"},
         2, 20);
}

TEST_CASE("tolerance") {
  Random random(seed() + 1);
  for (int n = 0; n < 3; ++n) {
    const Real start = random.between(1, 5), speed = random.between(10, 60);
    const Search s = {closing(start, speed), random.between(1.5, 3) * speed, 5, 1e-4,
                      "a gap that closes at a steady speed"};
    askHit(s, start / speed, speed);
    GRADE(run(s).gap, 0, within(s.tolerance, "the tolerance"), given("fastest", s.fastest, "m/s"),
          given("tolerance", s.tolerance, "m"), unit("m"), about("the gap that is left"));
  }
  const Search slow = {closing(1, 0.01), 0.02, 200, 1e-3, "1 m that closes at 1 cm a second"};
  askHit(slow, 100, 0.01);
}

TEST_CASE("ends") {
  Search s = {closing(8, 4), 4, 2, 1e-9, "8 m that close at 4 m/s, and just 2 s"};
  askHit(s, 2, 4);
  s = {closing(8, 4), 5, 1.9, 1e-9, "the same, and 1.9 s"};
  askStatus(s, ImpactStatus::kNoHit);
  GRADE(run(s).time, 1.9, within(1e-15, "the end"), given("fastest", 5.0, "m/s"),
        given("duration", 1.9, "s"), unit("s"), about("how far it has looked, if there is no hit"));
  s = {closing(8, 4), 4, 1.9, 1e-9, "the same, with the very speed as bound"};
  askStatus(s, ImpactStatus::kNoHit);
  s = {swinging(1.25, 1, 2), 2, 3, 1e-9, "a pendulum that stays 25 cm away"};
  askStatus(s, ImpactStatus::kNoHit);
  s = {closing(-0.5, 4), 4, 2, 1e-9, "half a metre deep at the start"};
  askStatus(s, ImpactStatus::kOverlapping);
  s = {closing(0, -4), 4, 2, 1e-9, "they touch at the start, and part"};
  askStatus(s, ImpactStatus::kHit);
}

TEST_CASE("limit") {
  const Search s = {closing(1, 1), 2, 5, 1e-9, "1 m that closes at half of `fastest`"};
  askStatus(s, ImpactStatus::kLimit, 12);
  GRADE(run(s, 12).time, 1 - 0x1p-12, within(1e-14, "halves are exact"),
        given("fastest", 2.0, "m/s"), given("tolerance", 1e-9, "m"), given("maxSteps", 12),
        unit("s"), about("how far twelve steps come"));
  GRADE(run(s).steps, 30, within(0, "2^-30 is the first half below 1e-9"),
        given("fastest", 2.0, "m/s"), given("tolerance", 1e-9, "m"), given("maxSteps", 5000),
        about("steps, if each of them goes half of what is left"));
  GRADE(run({closing(10, 4), 4, 5, 1e-6, ""}).steps, 1, within(0, "the bound is the speed"),
        given("fastest", 4.0, "m/s"), given("tolerance", 1e-6, "m"),
        about("10 m that close at 4 m/s: steps"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(conservativeAdvancement(closing(1, 1), 0, 1, 1e-9, 10), given("fastest", 0.0));
  GRADE_REFUSES(conservativeAdvancement(closing(1, 1), 1, 1, 0, 10), given("tolerance", 0.0));
}

PROBES() {
  Random random(711);
  for (int n = 0; n < 4; ++n) {
    const Real start = random.between(5, 20), speed = random.between(20, 90);
    PROBE(run({through(start, speed, 0.006), 1.3 * speed, 5, 1e-4, ""}, 300));
    PROBE(run({closing(start, speed), 2 * speed, 1, 1e-3, ""}, 300));
    PROBE(run({fallingThrough(start, 0.05), 100, 10, 1e-4, ""}, 300));
    PROBE(run({closing(start, speed), 2 * speed, 1, 1e-9, ""}, 7));
    PROBE(run({closing(8 + n, 4), 4, 2 + n / 4.0, 1e-6, ""}, 300));
    PROBE(run({closing(start, 1), 1.5, 2, 1e-6, ""}, 300));
  }
  PROBE(run({closing(-0.5, 4), 4, 2, 1e-6, ""}));
}

// Grader of 05.combine_restitution: pairs whose answers can be read off, and any pairs, asked in
// both orders, by what defines each mean.

#include "carom/impulse/combine_restitution.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers below 1";

using Rule = RestitutionRule;

void ask(Real a, Real b, Rule rule, Real expected, const char* what) {
  GRADE(combineRestitution(a, b, rule), expected, within(1e-15, kRounding), given("a", a),
        given("b", b), given("rule", inWords(rule)), about(what));
}

}  // namespace

TEST_CASE("average") {
  ask(0.8, 0.8, Rule::average, 0.8, "two equal balls");
  ask(0.25, 0.75, Rule::average, 0.5, "two unequal bodies");
  ask(1, 0.5, Rule::average, 0.75, "two unequal bodies, the bouncier one first");
}

TEST_CASE("product") {
  ask(0.8, 0.8, Rule::product, 0.64, "two equal balls");
  ask(0.5, 0.75, Rule::product, 0.375, "two unequal bodies");
  ask(0, 1, Rule::product, 0, "putty stays putty");
}

TEST_CASE("ends") {
  ask(0.25, 0.75, Rule::minimum, 0.25, "the smaller one");
  ask(0.75, 0.25, Rule::minimum, 0.25, "the smaller one, which is the second");
  ask(0.25, 0.75, Rule::maximum, 0.75, "the larger one");
  ask(0.75, 0.25, Rule::maximum, 0.75, "the larger one, which is the first");
}

TEST_CASE("geometric") {
  ask(0.25, 1, Rule::geometricMean, 0.5, "a quarter and one");
  ask(0.9, 0.4, Rule::geometricMean, 0.6, "0.9 and 0.4");
  ask(0.8, 0.8, Rule::geometricMean, 0.8, "two equal balls");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 10; ++n) {
    // The smaller one is r^2 times the larger one, so their geometric mean is r times it.
    const Real large = random.between(0.3, 1), r = random.between(0.1, 0.9);
    const Real small = r * r * large;
    for (const bool turned : {false, true}) {
      const Real a = turned ? large : small, b = turned ? small : large;
      ask(a, b, Rule::geometricMean, r * large, "any two coefficients");
      ask(a, b, Rule::average, small + (large - small) / 2, "any two coefficients");
      ask(a, b, Rule::product, r * large * r * large, "any two coefficients");
      ask(a, b, Rule::minimum, small, "any two coefficients");
      ask(a, b, Rule::maximum, large, "any two coefficients");
    }
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(combineRestitution(1.2, 0.5, Rule::average), given("a", 1.2), given("b", 0.5));
  GRADE_REFUSES(combineRestitution(0.5, -0.1, Rule::maximum), given("a", 0.5), given("b", -0.1));
}

PROBES() {
  Random random(507);
  for (int n = 0; n < 6; ++n) {
    const Real a = random.between(0, 1), b = random.between(0, 1);
    for (const Rule rule :
         {Rule::average, Rule::product, Rule::minimum, Rule::maximum, Rule::geometricMean}) {
      PROBE(combineRestitution(a, b, rule));
    }
  }
}

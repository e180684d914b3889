// How much of a sum is left when many numbers have been added?
//
// Three lists are added in six ways, each beside the exact sum: a million tenths, a million terms
// of 1/k, and numbers of all sizes that nearly cancel. Then the order of three numbers, and a clock
// that adds its steps up.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/precision/compensated_sum.hpp"
#include "carom/precision/exact_sum.hpp"
#include "carom/precision/steps_until.hpp"
#include "carom/precision/sums.hpp"
#include "carom/precision/time_of_step.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using Numbers = std::vector<Real>;

Numbers harmonic(int count) {
  Numbers terms;
  for (int k = 1; k <= count; ++k) terms.push_back(1.0 / k);
  return terms;
}

// Of sizes from 1e-9 to 1e9; all but one in a thousand are taken off again.
Numbers cancelling(int count) {
  carom::Random random(7);
  Numbers terms;
  for (int i = 0; i < count; ++i) {
    const Real digits = random.between(-1, 1);
    terms.push_back(std::ldexp(digits, random.integer(-30, 30)));
  }
  for (int i = 0; i < count; ++i) {
    if (i % 1000 != 0) terms.push_back(-terms[static_cast<std::size_t>(i)]);
  }
  return terms;
}

template <class Number>
std::vector<Number> as(const Numbers& terms) {
  return std::vector<Number>(terms.begin(), terms.end());
}

// Relative error of a sum, in float or double, of terms that were rounded to that type.
template <class Number, class Method>
Real errorOf(const Numbers& given, Method add) {
  const std::vector<Number> terms = as<Number>(given);
  carom::ExactSum exact;
  for (const Number term : terms) exact.add(Real(term));
  const Real sum = Real(add(std::span<const Number>(terms)));
  return std::abs(sum / exact.value() - 1);
}

void compareMethods() {
  const Numbers tenths(1000000, 0.1), fractions = harmonic(1000000);
  const Numbers mixed = cancelling(100000);
  carom::io::Table table;
  table.column("relative error").column("tenths", carom::io::scientific(1));
  table.column("1/k", carom::io::scientific(1)).column("cancelling", carom::io::scientific(1));
  const auto row = [&]<class Number>(const std::string& name, Number, auto add) {
    table.row({name, errorOf<Number>(tenths, add), errorOf<Number>(fractions, add),
               errorOf<Number>(mixed, add)});
  };
  row("float, plain", float(), carom::plainSum<float>);
  row("float, pairwise", float(), carom::pairwiseSum<float>);
  row("float, Kahan", float(), carom::kahanSum<float>);
  row("double, plain", Real(), carom::plainSum<Real>);
  row("double, pairwise", Real(), carom::pairwiseSum<Real>);
  row("double, Kahan", Real(), carom::kahanSum<Real>);
  row("double, Neumaier", Real(), carom::compensatedSum);
  std::cout << table << '\n';
}

void compareOrders() {
  carom::io::Table table;
  table.column("a").column("b").column("c").column("(a + b) + c").column("compensated");
  Numbers terms = {-1e16, 1, 1e16};
  do {
    table.row({terms[0], terms[1], terms[2], (terms[0] + terms[1]) + terms[2],
               carom::compensatedSum(terms)});
  } while (std::next_permutation(terms.begin(), terms.end()));
  std::cout << table << '\n';
}

//! [clock]
template <class Number>
void runClock(const std::string& type, Real dt, Real end, carom::io::Table& table) {
  int steps = 0;
  Number t = 0;
  while (t < Number(end)) {
    t = t + Number(dt);
    steps = steps + 1;
  }
  const std::int64_t right = carom::stepsUntil(end, dt);
  table.row({type, dt, steps, Real(t), right, carom::timeOfStep(right, dt, 0)});
}
//! [clock]

void compareClocks() {
  carom::io::Table table;
  table.column("clock").column("dt [s]", carom::io::fixed(4)).column("steps");
  table.column("it shows [s]", carom::io::fixed(12)).column("right");
  table.column("n dt [s]", carom::io::fixed(12));
  runClock<float>("float", 0.1, 10, table);
  runClock<double>("double", 0.1, 10, table);
  runClock<float>("float", 1 / 60.0, 3600, table);
  runClock<double>("double", 1 / 60.0, 3600, table);
  std::cout << table;
}

int main(int argc, char** argv) {
  compareMethods();
  compareOrders();
  compareClocks();

  carom::io::Plot plot("Tenths, added in floats");
  plot.xAxis("number of terms", carom::io::Scale::Logarithmic);
  plot.yAxis("relative error", carom::io::Scale::Logarithmic).yRange(1e-9, 1);
  plot.describe(
      "The plain sum's error rises with the number of terms to several per cent. The "
      "pairwise sum rises slowly; Kahan's stays at the last digit.");
  const auto draw = [&plot](const std::string& name, auto add) {
    Numbers x, y;
    for (Real count = 10; count < 2e7; count *= 2) {
      const Numbers terms(static_cast<std::size_t>(count), 0.1);
      x.push_back(count);
      y.push_back(std::max(errorOf<float>(terms, add), 2e-9));  // an axis of powers has no zero
    }
    plot.curve(name, x, y, {.marks = true});
  };
  draw("plain", carom::plainSum<float>);
  draw("pairwise", carom::pairwiseSum<float>);
  draw("Kahan", carom::kahanSum<float>);
  plot.writeSvg(std::filesystem::path(argc > 1 ? argv[1] : ".") / "sums.svg");
}

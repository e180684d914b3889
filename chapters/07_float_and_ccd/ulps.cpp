// Of which bits is a number made, and how far is it to the next?
//
// Some floats, taken apart. Then 0.1 + 0.2 in floats and in doubles, tenths and thirds in decimal
// numbers too, and how fine a position is at growing distances from the origin. Whatever is done
// for several types is written once, as a template.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "carom/precision/float_bits.hpp"
#include "carom/precision/float_ulp_distance.hpp"
#include "carom/precision/ulp.hpp"
#include "carom/precision/ulp_distance.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;

void printBits() {
  carom::io::Table table;
  table.column("float").column("sign, power, fraction").column("kind");
  const auto row = [&table](const std::string& name, float x) {
    table.row({name, carom::bitText(carom::bitsOf(x)), carom::kindName(carom::bitsOf(x).kind)});
  };
  row("1", 1);
  row("-2.5", -2.5f);
  row("0.1", 0.1f);
  row("16777216", 16777216);
  row("16777217", static_cast<float>(16777217));
  row("the largest", std::numeric_limits<float>::max());
  row("2^-126", 0x1p-126f);
  row("2^-127", 0x1p-127f);
  row("the smallest", 0x1p-149f);
  row("-0", -0.0f);
  row("1 / 0", std::numeric_limits<float>::infinity());
  std::cout << table << '\n';
}

std::uint64_t stepsBetween(float a, float b) {
  return carom::floatUlpDistance(a, b);
}

std::uint64_t stepsBetween(double a, double b) {
  return carom::ulpDistance(a, b);
}

//! [three_tenths]
template <class Number>
void addTenths(const std::string& type, carom::io::Table& table) {
  const Number sum = Number(0.1) + Number(0.2), exact = Number(0.3);
  table.row({type, Real(sum), Real(exact), stepsBetween(sum, exact)});
}
//! [three_tenths]

void printThreeTenths() {
  carom::io::Table table;
  table.column("type").column("0.1 + 0.2", carom::io::fixed(19));
  table.column("0.3", carom::io::fixed(19)).column("steps apart");
  addTenths<float>("float", table);
  addTenths<double>("double", table);
  std::cout << table << '\n';
}

//! [decimal]
// ratio(p, q) is p / q, as the type has it.
template <class Ratio>
void fractions(const char* type, Ratio ratio, carom::io::Table& table) {
  const auto third = ratio(1, 3);
  auto tenths = ratio(0, 1);
  for (int i = 0; i < 10; ++i) tenths += ratio(1, 10);
  const bool sumRight = ratio(1, 10) + ratio(2, 10) == ratio(3, 10);
  const bool tenthsOne = tenths == ratio(1, 1);
  const bool thirdsOne = third + third + third == ratio(1, 1);
  const auto say = [](bool yes) { return yes ? "yes" : "no"; };
  table.row({type, say(sumRight), say(tenthsOne), say(thirdsOne)});
}
//! [decimal]

void printFractions() {
  carom::io::Table table;
  table.column("type").column("0.1 + 0.2 = 0.3").column("ten tenths = 1");
  table.column("three thirds = 1");
  fractions(
      "float", [](int p, int q) { return static_cast<float>(p) / static_cast<float>(q); }, table);
  fractions(
      "double", [](int p, int q) { return static_cast<double>(p) / q; }, table);
  // Sixteen decimal digits: a whole number of 1e-16.
  fractions(
      "decimal", [](int p, int q) { return p * std::int64_t{10000000000000000} / q; }, table);
  std::cout << table << '\n';
}

void printSpacing() {
  const std::vector<std::pair<std::string, Real>> places = {
      {"1 m", 1},         {"1 km", 1e3},   {"16 km", 16e3}, {"2^17 m", 0x1p17}, {"1 000 km", 1e6},
      {"2^20 m", 0x1p20}, {"Moon", 3.8e8}, {"Sun", 1.5e11}, {"next star", 4e16}};
  carom::io::Table table;
  table.column("distance").column("float steps by [m]", carom::io::scientific(1));
  table.column("double steps by [m]", carom::io::scientific(1));
  for (const auto& [name, far] : places) {
    table.row({name, Real(carom::ulp(static_cast<float>(far))), carom::ulp(far)});
  }
  std::cout << table;
}

template <class Number>
void drawSteps(const std::string& type, carom::io::Plot& plot) {
  std::vector<Real> x, y;
  for (Real power = 0; power <= 30; power += 0.125) {
    x.push_back(std::exp2(power));
    y.push_back(Real(carom::ulp(static_cast<Number>(x.back()))));
  }
  plot.curve(type, x, y);
}

int main(int argc, char** argv) {
  printBits();
  printThreeTenths();
  printFractions();
  printSpacing();

  carom::io::Plot plot("How fine is a position?");
  plot.xAxis("distance from the origin [m]", carom::io::Scale::Logarithmic);
  plot.yAxis("step to the next number [m]", carom::io::Scale::Logarithmic);
  plot.describe(
      "Two staircases that rise together, a step at each power of two. That of the "
      "doubles is nine powers of ten below that of the floats.");
  drawSteps<float>("float", plot);
  drawSteps<double>("double", plot);
  plot.curve("a millimetre", {1, 0x1p30}, {1e-3, 1e-3}, {.dashed = true, .width = 1});
  plot.writeSvg(std::filesystem::path(argc > 1 ? argv[1] : ".") / "ulps.svg");
}

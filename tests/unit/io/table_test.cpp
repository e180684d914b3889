#include "carom_io/table.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "carom/core/errors.hpp"
#include "carom_io/number_text.hpp"
#include "support/catch.hpp"

using namespace carom;
using carom_test::ContainsSubstring;

TEST_CASE("a table sets numbers to the right and words to the left") {
  io::Table table;
  table.column("method").column("h [s]", io::scientific(1)).column("n");
  table.row({"Euler", 0.1, 3}).row({"RK4", 0.01, 12345});
  std::ostringstream out;
  out << table;
  CHECK(out.str() ==
        "method    h [s]      n\n"
        "------  -------  -----\n"
        "Euler   1.0e-01      3\n"
        "RK4     1.0e-02  12345\n");
}

TEST_CASE("a column is as wide as its letters, not as their bytes") {
  io::Table table;
  table.column("Δ").column("x", io::fixed(0));
  table.row({"é", 1.0});
  CHECK(table.text() == "Δ  x\n-  -\né  1\n");
}

TEST_CASE("a number that rounds to zero has no sign") {
  CHECK(io::roundedText(-1e-9, std::chars_format::fixed, 2) == "0.00");
  CHECK(io::roundedText(-0.0, std::chars_format::scientific, 1) == "0.0e+00");
  CHECK(io::roundedText(-0.004, std::chars_format::fixed, 2) == "0.00");
  CHECK(io::roundedText(-0.006, std::chars_format::fixed, 2) == "-0.01");
  CHECK(io::roundedText(-1e-9, std::chars_format::scientific, 0) == "-1e-09");
}

TEST_CASE("exact text reads back as the same number") {
  for (const Real value : {0.1, 1.0 / 3.0, 5e-324, std::numeric_limits<Real>::max(), -2.5e-7}) {
    CHECK(std::strtod(io::exactText(value).c_str(), nullptr) == value);
  }
  CHECK(io::exactText(std::nan("")) == "nan");
  CHECK(io::exactText(-INFINITY) == "-inf");
}

TEST_CASE("the largest double is written in full") {
  const std::string text =
      io::roundedText(std::numeric_limits<Real>::max(), std::chars_format::fixed, 60);
  CHECK(text.size() == 309 + 1 + 60);
}

TEST_CASE("a table refuses rows and columns that do not fit") {
  io::Table table;
  table.column("a").column("b");
  CHECK_THROWS_AS(table.row({1.0}), InvalidInput);
  table.row({1.0, 2.0});
  CHECK_THROWS_AS(table.column("c"), InvalidInput);
  CHECK_THROWS_WITH(table.row({1, 2, 3}), ContainsSubstring("3 cells"));
  CHECK_THROWS_AS(io::fixed(-1), InvalidInput);
  CHECK_THROWS_AS(io::significant(0), InvalidInput);
}

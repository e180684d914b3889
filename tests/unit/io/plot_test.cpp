#include "carom_io/plot.hpp"

#include <cmath>
#include <cstdlib>

#include "carom/core/errors.hpp"
#include "scratch.hpp"
#include "support/catch.hpp"

using namespace carom;
using carom_test::ContainsSubstring;
using carom_test::Scratch;

namespace {

// Sets an environment variable for the life of the object.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    const char* old = std::getenv(name);
    had_ = old != nullptr;
    if (had_) old_ = old;
    setenv(name, value, 1);
  }
  ~Environment() {
    if (had_) {
      setenv(name_, old_.c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }

 private:
  const char* name_;
  std::string old_;
  bool had_;
};

io::Plot example() {
  io::Plot plot("Error & <step>");
  plot.xAxis("h [s]", io::Scale::Logarithmic).yAxis("error [m]", io::Scale::Logarithmic);
  plot.curve("Euler", {1e-3, 1e-2, 1e-1}, {1e-3, 1e-2, 1e-1}, {.marks = true});
  plot.slope("slope 1", 1, 0.1, 0.2);
  return plot;
}

}  // namespace

TEST_CASE("a plot is the same bytes on every run") {
  const std::string svg = example().describe("The error falls.").svg();
  CHECK(svg == example().describe("The error falls.").svg());
  CHECK_THAT(svg, ContainsSubstring("<svg"));
  CHECK_THAT(svg, ContainsSubstring("</svg>"));
  CHECK_THAT(svg, ContainsSubstring("<title>Error &amp; &lt;step&gt;</title>"));
  CHECK_THAT(svg, ContainsSubstring("<desc>The error falls.</desc>"));
  CHECK_THAT(svg, ContainsSubstring("Euler"));
}

TEST_CASE("writing a plot puts the picture into the file") {
  const Scratch scratch;
  example().writeSvg(scratch.file("a.svg"));
  CHECK(Scratch::read(scratch.file("a.svg")) == example().svg());
  CHECK_THROWS_AS(example().writeSvg(scratch.file("no/such/folder.svg")), io::DrawingError);
}

TEST_CASE("a polygon, an arrow and a label are drawn where they are put") {
  io::Plot plot("Shapes");
  plot.equalAspect()
      .polygon("A", {{0, 0}, {2, 0}, {2, 1}})
      .arrow({0, 0}, {1, 1})
      .label({1, 0}, "n");
  CHECK_THAT(plot.script(), ContainsSubstring("0 0\n2 0\n2 1\n0 0\n"));
  CHECK_THAT(plot.script(), ContainsSubstring("from 0,0 to 1,1"));
  CHECK_THAT(plot.svg(), ContainsSubstring("<polygon"));
}

TEST_CASE("nothing in a text becomes a command of gnuplot or of the system") {
  const Scratch scratch;
  const std::string touched = scratch.file("touched").string();
  io::Plot plot("it's `touch " + touched + "`\nset output '" + touched + "'");
  plot.xAxis("'; system('touch " + touched + "'); '")
      .curve("a' , system(\"touch " + touched + "\")", {0, 1}, {0, 1});
  CHECK_THAT(plot.svg(), ContainsSubstring("it's `touch"));
  CHECK_FALSE(std::filesystem::exists(touched));
}

TEST_CASE("digits behind a sign stay digits in a drawn text") {
  const std::vector<Real> x{1, 10};
  const std::string svg = io::Plot("order -1/2 of 100").curve("slope -1/2, 1e-16", x, x).svg();
  CHECK_THAT(svg, ContainsSubstring("order -1/2 of 100"));
  CHECK_THAT(svg, ContainsSubstring("slope -1/2, 1e-16"));
}

TEST_CASE("a plot names the point that cannot be drawn") {
  io::Plot plot("t");
  CHECK_THROWS_WITH(plot.curve("c", {0, 1}, {0, NAN}), ContainsSubstring("curve 'c', point 1"));
  CHECK_THROWS_AS(plot.curve("c", {0, 1}, {0}), InvalidInput);
  CHECK_THROWS_AS(plot.curve("c", {}, {}), InvalidInput);
  CHECK_THROWS_AS(plot.xRange(1, 1), InvalidInput);
  CHECK_THROWS_AS(plot.polygon("p", {{0, 0}, {1, 0}}), InvalidInput);
  CHECK_THROWS_AS(plot.svg(), InvalidInput);  // nothing to draw
  plot.yAxis("e", io::Scale::Logarithmic).curve("zero", {1, 2}, {1, 0});
  CHECK_THROWS_WITH(plot.svg(), ContainsSubstring("curve 'zero', point 1: 0 cannot stand"));
}

TEST_CASE("without gnuplot the message names the package") {
  const Environment noPrograms("PATH", "/nonexistent");
  CHECK_THROWS_WITH(example().svg(), ContainsSubstring("gnuplot-nox"));
}

#include <cmath>
#include <nlohmann/json.hpp>

#include "run_carom.hpp"
#include "support/catch.hpp"

using carom_test::ContainsSubstring;
using carom_test::Outcome;
using carom_test::Scratch;
using carom_test::WithinAbs;
using carom_test::WithinRel;

namespace {

Outcome run(const Scratch& scratch, const std::string& arguments) {
  return carom_test::runCarom(scratch, arguments);
}

// The box 1 x 2 x 3 with a corner at (10, 20, 30).
const std::string kBox =
    "OFF\n8 6 0\n10 20 30\n11 20 30\n11 22 30\n10 22 30\n10 20 33\n11 20 33\n11 22 33\n10 22 33\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

// Two boxes in one file; the second from `low` to `high` along every axis, its faces turned if asked.
std::string twoBoxes(const std::string& low, const std::string& high, bool reversed) {
  const auto corners = [](const std::string& a, const std::string& b) {
    const auto line = [](const std::string& x, const std::string& y, const std::string& z) {
      return x + " " + y + " " + z + "\n";
    };
    return line(a, a, a) + line(b, a, a) + line(b, b, a) + line(a, b, a) + line(a, a, b) +
           line(b, a, b) + line(b, b, b) + line(a, b, b);
  };
  const std::string outwards = "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  const std::string second =
      reversed
          ? "4 9 10 11 8\n4 15 14 13 12\n4 12 13 9 8\n4 13 14 10 9\n4 14 15 11 10\n4 15 12 8 11\n"
          : "4 8 11 10 9\n4 12 13 14 15\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n";
  return "OFF\n16 12 0\n" + corners("0", "4") + corners(low, high) + outwards + second;
}

}  // namespace

TEST_CASE("carom mass weighs a box as the closed form does") {
  const Scratch scratch;
  const std::string file = scratch.write("box.off", kBox).string();
  const Outcome outcome = run(scratch, "mass " + file + " --density 2.5 --json");
  REQUIRE(outcome.exitCode == 0);
  CHECK(outcome.err.empty());
  const nlohmann::json result = nlohmann::json::parse(outcome.out);
  const double mass = 15;  // 2.5 * 1 * 2 * 3
  CHECK(result["volume"] == 6.0);
  CHECK(result["mass"] == mass);
  CHECK(result["triangles"] == 12);
  CHECK(result["problems"].empty());
  const std::vector<double> center{10.5, 21, 31.5};
  // m/12 of the squares of the other two edges.
  const std::vector<double> moments{mass * 13 / 12, mass * 10 / 12, mass * 5 / 12};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK_THAT(result["center"][i].get<double>(), WithinRel(center[i], 1e-15));
    for (std::size_t j = 0; j < 3; ++j) {
      // 16 ulp of the largest moment.
      CHECK_THAT(result["inertia"][i][j].get<double>(),
                 WithinAbs(i == j ? moments[i] : 0.0, 6e-14));
    }
    CHECK_THAT(result["principal_moments"][i].get<double>(), WithinRel(moments[2 - i], 1e-14));
  }
  // The smallest moment is about the longest edge, z.
  CHECK_THAT(std::abs(result["principal_axes"][0][2].get<double>()), WithinAbs(1, 1e-15));
}

TEST_CASE("carom mass prints a text that names units") {
  const Scratch scratch;
  const Outcome outcome = run(scratch, "mass " + scratch.write("box.off", kBox).string());
  CHECK(outcome.exitCode == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("volume 6 m^3, mass 6 kg"));
  CHECK_THAT(outcome.out, ContainsSubstring("centre [m]"));
}

TEST_CASE("Monte Carlo is near the exact answer, within five of its own standard deviations") {
  const Scratch scratch;
  // A tetrahedron fills a sixth of its bounding box.
  const std::string tetrahedron =
      "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::string file = scratch.write("tet.off", tetrahedron).string();
  const Outcome outcome = run(scratch, "mass " + file + " --method montecarlo --json");
  REQUIRE(outcome.exitCode == 0);
  const nlohmann::json result = nlohmann::json::parse(outcome.out);
  const double error = result["relative_error"].get<double>();
  CHECK(error < 0.01);
  CHECK_THAT(result["volume"].get<double>(), WithinRel(1.0 / 6, 5 * error));
  CHECK(result["volume"] != 1.0 / 6);
}

TEST_CASE("the surface method gives the centre of the skin and says so") {
  const Scratch scratch;
  // The tetrahedron with corners at the origin and 1 on the axes: its skin's centre differs from
  // 1/4. Each of three faces has area 1/2, the slanted one sqrt(3)/2; x of their centres: 1/3, 1/3,
  // 0, 1/3.
  const std::string tetrahedron =
      "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::string file = scratch.write("tet.off", tetrahedron).string();
  const Outcome outcome = run(scratch, "mass " + file + " --method surface --json");
  REQUIRE(outcome.exitCode == 0);
  const nlohmann::json result = nlohmann::json::parse(outcome.out);
  const double slanted = std::sqrt(3.0) / 2;
  const double x = (2 * 0.5 + slanted) / 3 / (1.5 + slanted);
  CHECK_THAT(result["center"][0].get<double>(), WithinRel(x, 1e-14));
  CHECK_THAT(result["remark"].get<std::string>(), ContainsSubstring("thin sheet"));
  // Steiner: the solid's moment about an axis through its own centre is 1/80 here.
  const double offset = x - 0.25;
  CHECK_THAT(result["inertia"][0][0].get<double>(),
             WithinRel(1.0 / 80 + 2 * offset * offset / 6, 1e-13));
}

TEST_CASE("a mesh with a hole is refused with its edge, and JSON stays JSON") {
  const Scratch scratch;
  const std::string open = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n";
  const std::string file = scratch.write("open.off", open).string();
  const Outcome text = run(scratch, "mass " + file);
  CHECK(text.exitCode == 1);
  CHECK(text.out.empty());
  CHECK_THAT(text.err, ContainsSubstring("edge 1-2"));
  const Outcome json = run(scratch, "mass " + file + " --json");
  CHECK(json.exitCode == 1);
  const nlohmann::json result = nlohmann::json::parse(json.out);
  CHECK(result["problems"].size() == 3);
  CHECK(result["volume"].is_null());
  CHECK(result["triangles"] == 3);
}

TEST_CASE("a surface that cuts itself is refused with two triangles, unless that is not asked") {
  const Scratch scratch;
  const std::string file = scratch.write("cut.off", twoBoxes("3", "6", false)).string();
  const Outcome outcome = run(scratch, "mass " + file + " --json");
  CHECK(outcome.exitCode == 1);
  const nlohmann::json result = nlohmann::json::parse(outcome.out);
  CHECK(result["volume"].is_null());
  REQUIRE_FALSE(result["problems"].empty());
  CHECK_THAT(result["problems"][0].get<std::string>(), ContainsSubstring("triangles "));
  CHECK_THAT(outcome.err, ContainsSubstring("cut or touch each other"));

  const Outcome trusted = run(scratch, "mass " + file + " --json --no-self-intersections");
  CHECK(trusted.exitCode == 0);
  CHECK(nlohmann::json::parse(trusted.out)["volume"] == 64.0 + 27.0);  // the common cube twice
}

TEST_CASE("a cavity is taken away if it looks inwards, and refused if it does not") {
  const Scratch scratch;
  const std::string good = scratch.write("hollow.off", twoBoxes("1", "3", true)).string();
  const Outcome hollow = run(scratch, "mass " + good + " --json");
  REQUIRE(hollow.exitCode == 0);
  CHECK(nlohmann::json::parse(hollow.out)["volume"] == 64.0 - 8.0);
  const std::string bad = scratch.write("double.off", twoBoxes("1", "3", false)).string();
  const Outcome wrong = run(scratch, "mass " + bad);
  CHECK(wrong.exitCode == 1);
  CHECK_THAT(wrong.err, ContainsSubstring("triangle 12"));
  CHECK_THAT(wrong.err, ContainsSubstring("cavity"));
}

TEST_CASE("a file that cannot be read has exit code 1 and is named") {
  const Scratch scratch;
  const Outcome missing = run(scratch, "mass " + scratch.file("none.stl").string() + " --json");
  CHECK(missing.exitCode == 1);
  CHECK_THAT(missing.err, ContainsSubstring("none.stl: there is no such file"));
  CHECK(nlohmann::json::parse(missing.out)["problems"].size() == 1);
  const Outcome broken =
      run(scratch, "mass " + scratch.write("a.off", "OFF\n1 1 1\n0 0 nan\n3 0 0 0\n").string());
  CHECK(broken.exitCode == 1);
  CHECK_THAT(broken.err, ContainsSubstring("a.off:3: "));
}

TEST_CASE("wrong use has exit code 4") {
  const Scratch scratch;
  const std::string file = scratch.write("box.off", kBox).string();
  for (const std::string& arguments :
       {std::string(), std::string("weigh x"), std::string("mass"),
        "mass " + file + " --method guess", "mass " + file + " --density 0",
        "mass " + file + " --density -1", "mass " + file + " --density nan",
        "mass " + file + " --density inf", "mass " + file + " --density x",
        "mass " + file + " --colour"}) {
    INFO(arguments);
    const Outcome outcome = run(scratch, arguments);
    CHECK(outcome.exitCode == 4);
    CHECK(outcome.out.empty());
    CHECK_FALSE(outcome.err.empty());
  }
}

TEST_CASE("help and version are no errors") {
  const Scratch scratch;
  CHECK(run(scratch, "--help").exitCode == 0);
  CHECK_THAT(run(scratch, "mass --help").out, ContainsSubstring("--density"));
  CHECK_THAT(run(scratch, "--version").out, ContainsSubstring("carom "));
}

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "run_carom.hpp"

using carom_test::ContainsSubstring;
using carom_test::Outcome;
using carom_test::runCarom;
using carom_test::Scratch;
using carom_test::WithinAbs;

namespace {

using Corner = std::array<double, 3>;

// Boxes in one file, each with its own eight vertices.
std::string boxes(const std::vector<std::pair<Corner, Corner>>& all) {
  std::string vertices;
  std::string faces;
  int first = 0;
  for (const auto& [low, high] : all) {
    for (int i = 0; i < 8; ++i) {
      for (unsigned k = 0; k < 3; ++k)
        vertices += std::to_string(i >> k & 1 ? high[k] : low[k]) + (k < 2 ? " " : "\n");
    }
    for (const auto& face : {std::array{0, 4, 6, 2},
                             {1, 3, 7, 5},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 2, 3, 1},
                             {4, 5, 7, 6}}) {
      faces += "4";
      for (const int v : face) faces += " " + std::to_string(first + v);
      faces += "\n";
    }
    first += 8;
  }
  return "OFF\n" + std::to_string(8 * all.size()) + " " + std::to_string(6 * all.size()) + " 0\n" +
         vertices + faces;
}

const std::string kCube = boxes({{{0, 0, 0}, {1, 1, 1}}});

nlohmann::json contact(const Scratch& scratch, const std::string& arguments) {
  const Outcome outcome = runCarom(scratch, "contact " + arguments + " --json");
  INFO(outcome.err);
  CHECK(outcome.exitCode == 0);
  return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE(
    "carom contact tells how deep two cubes overlap, along which axis, and at which corners") {
  const Scratch scratch;
  const std::string cube = scratch.write("cube.off", kCube).string();
  const auto result = contact(scratch, cube + " " + cube + " --pose 0.75 0.125 0.25");
  CHECK(result["overlap"] == true);
  CHECK(result["verdict"] == "overlapping");
  CHECK_THAT(result["separation"].get<double>(), WithinAbs(-0.25, 1e-15));
  CHECK(result["normal"] == std::vector<double>{1, 0, 0});
  REQUIRE(result["points"].size() == 4);
  std::set<std::pair<double, double>> corners;
  for (const auto& point : result["points"]) {
    CHECK_THAT(point["separation"].get<double>(), WithinAbs(-0.25, 1e-15));
    CHECK_THAT(point["position"][0].get<double>(), WithinAbs(0.875, 1e-15));
    corners.insert({point["position"][1].get<double>(), point["position"][2].get<double>()});
  }
  CHECK(corners ==
        std::set<std::pair<double, double>>{{0.125, 0.25}, {0.125, 1}, {1, 0.25}, {1, 1}});
}

TEST_CASE("carom contact tells touching from apart and from overlapping") {
  const Scratch scratch;
  const std::string cube = scratch.write("cube.off", kCube).string();
  struct Case {
    const char* pose;
    const char* verdict;
    double separation;
  };
  for (const Case& c :
       {Case{"1 0 0", "touching", 0}, Case{"1 1 1", "touching", 0},
        Case{"1.25 0 0", "separated", 0.25}, Case{"0 -1.5 0", "separated", 0.5},
        Case{"0 0 1.0000000000000002", "separated", 0x1p-52},
        Case{"0 0 0.9999999999999999", "overlapping", -0x1p-53},
        // Turned by 45 degrees about z, its edge reaches sqrt(1/2) towards A; rounding decides.
        Case{"1.70710678118654752 0 0 0.92387953251128674 0 0 0.38268343236508977", nullptr, 0}}) {
    INFO(c.pose);
    const auto result = contact(scratch, cube + " " + cube + " --pose " + c.pose);
    CHECK_THAT(result["separation"].get<double>(), WithinAbs(c.separation, 1e-15));
    if (!c.verdict) continue;
    CHECK(result["verdict"] == c.verdict);
    CHECK(result["overlap"] == (c.separation < 0));
  }
  // Both moved: only the difference counts.
  const auto both = contact(scratch, cube + " " + cube + " --pose-a 5 6 7 --pose 6.5 6 7");
  CHECK_THAT(both["separation"].get<double>(), WithinAbs(0.5, 1e-15));
}

TEST_CASE("carom contact takes solids of several convex parts") {
  const Scratch scratch;
  // An L: a flat part and an upright one. A small cube sits in its corner and touches both.
  const std::string corner =
      scratch.write("corner.off", boxes({{{0, 0, -1}, {4, 1, 0}}, {{-1, 0, -1}, {0, 1, 4}}}))
          .string();
  const std::string cube = scratch.write("cube.off", kCube).string();
  const auto result = contact(scratch, corner + " " + cube + " --pose -0.125 0 -0.25");
  CHECK(result["overlap"] == true);
  std::set<std::vector<double>> normals;
  for (const auto& point : result["points"]) {
    normals.insert(point["normal"].get<std::vector<double>>());
    CHECK(point["part_b"] == 0);
  }
  CHECK(normals == std::set<std::vector<double>>{{0, 0, 1}, {1, 0, 0}});
  const Outcome text = runCarom(scratch, "contact " + corner + " " + cube);
  CHECK(text.exitCode == 0);
  CHECK_THAT(text.out, ContainsSubstring("corner.off (2 parts)") && ContainsSubstring("touching") &&
                           ContainsSubstring("normal, from A to B"));
}

TEST_CASE("carom contact names what is wrong with a file or a pose") {
  const Scratch scratch;
  const std::string cube = scratch.write("cube.off", kCube).string();
  // The cube with its top pushed in: vertex 7 of 8 lower than the others.
  std::string dented = kCube;
  const std::string seventh = "1.000000 1.000000 1.000000";
  dented.replace(dented.find(seventh), seventh.size(), "0.750000 0.750000 0.500000");
  struct Case {
    std::string arguments;
    std::vector<std::string> parts;
    int exitCode = 1;
  };
  const std::string bad = scratch.write("dented.off", dented).string();
  const std::string open =
      scratch
          .write("open.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n")
          .string();
  for (const Case& c :
       {Case{bad + " " + cube,
             {"dented.off: part 0 is not convex: vertex ", " m outside of the plane of triangle "}},
        Case{cube + " " + open, {"open.off: ", "edge"}},
        Case{cube + " none.off", {"none.off: there is no such file"}},
        Case{cube + " " + cube + " --pose nan 0 0", {"--pose: ", "finite"}},
        Case{cube + " " + cube + " --pose 0 0 0 0 0 0 0", {"--pose: ", "zero"}},
        Case{cube + " " + cube + " --pose 1 2 3 4", {"3 or 7 numbers"}, 4},
        Case{cube + " " + cube + " --pose x y z", {"--pose"}, 4},
        Case{cube, {"B is required"}, 4}}) {
    INFO(c.arguments);
    const Outcome outcome = runCarom(scratch, "contact " + c.arguments);
    CHECK(outcome.exitCode == c.exitCode);
    CHECK(outcome.out.empty());
    for (const auto& part : c.parts) CHECK_THAT(outcome.err, ContainsSubstring(part));
  }
  const Outcome inJson = runCarom(scratch, "contact " + bad + " " + cube + " --json");
  CHECK(inJson.exitCode == 1);
  const auto result = nlohmann::json::parse(inJson.out);
  CHECK(result["separation"].is_null());
  CHECK(result["problems"].size() == 1);
}

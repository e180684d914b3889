// Is every mistake in an exercise.ini told by name?

#include <unistd.h>

#include "runner/exercise.hpp"
#include "support/catch.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;

namespace {

const std::string kGood =
    "# Values run to the end of the line.\n"
    "id = 01.spin\ntitle = How it spins; and why\nkind = implement\nlevel = 2\nminutes = 20\n"
    "points = 3\norder = 10\nlayer = rotation\nhome = lib/carom/rotation\nread = Spin\n"
    "uses = Quaternion Vector3\n\n"
    "[check.first]\ntitle = it turns\npoints = 2\nwrong = 01_slip\n\n"
    "[check.second]\ntitle = it stops\npoints = 1\nread = Friction\n\n"
    "[wrong.01_slip]\nsays = The sign is wrong.\ncheck = first\n\n"
    "[hint.1]\ntext = What turns?\n\n[hint.2]\ntext = The whole.\n";

struct Course {
  fs::path root = fs::path(CAROM_BUILD_DIR) / "work" / ("ini-test-" + std::to_string(getpid()));
  ~Course() {
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
  void write(const std::string& name, const std::string& ini) const {
    writeFile(root / "solutions/01_rotation" / name / "exercise.ini", ini);
  }
  std::vector<std::string> problems() const {
    std::vector<std::string> all;
    readExercises(root, all);
    return all;
  }
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

}  // namespace

TEST_CASE("everything that an exercise.ini says is read") {
  const Course course;
  course.write("spin", kGood);
  std::vector<std::string> problems;
  const auto all = readExercises(course.root, problems);
  CHECK(problems.empty());
  REQUIRE(all.size() == 1);
  const Exercise& e = all[0];
  CHECK(e.id == "01.spin");
  CHECK(e.title == "How it spins; and why");
  CHECK(e.level == 2);
  CHECK(e.minutes == 20);
  CHECK(e.points == 3);
  CHECK(e.uses == std::vector<std::string>{"Quaternion", "Vector3"});
  CHECK(e.studentFile() == "exercises/01_rotation/spin.cpp");
  REQUIRE(e.checks.size() == 2);
  CHECK(e.checks[0].name == "first");
  CHECK(e.checks[0].wrong == "01_slip");
  CHECK(e.checks[0].read == "Spin");
  CHECK(e.checks[1].read == "Friction");
  REQUIRE(e.wrong.size() == 1);
  CHECK(e.wrong[0].says == "The sign is wrong.");
  CHECK(e.hints == std::vector<std::string>{"What turns?", "The whole."});
}

TEST_CASE("every mistake is told with the file that holds it") {
  struct Mistake {
    const char* what;
    const char* by;
    const char* problem;
  };
  const Mistake mistakes[] = {
      {"id = 01.spin\n", "", "needs 'id = ...'"},
      {"id = 01.spin", "id = 02.spin", "the id should be 01.spin"},
      {"title = How it spins; and why\n", "", "needs 'title = ...'"},
      {"kind = implement", "kind = implemnt", "unknown kind 'implemnt'"},
      {"level = 2", "level = 4", "'level = 4' is not a number from 1"},
      {"minutes = 20", "minutes = long", "'minutes = long' is not a number"},
      {"minutes = 20", "minutes = 20 min", "'minutes = 20 min' is not a number"},
      {"minutes = 20", "minutes = nan", "'minutes = nan' is not a number"},
      {"points = 3", "points = 4", "do not add up"},
      {"home = lib/carom/rotation\n", "", "needs 'home = ...'"},
      {"layer = rotation", "layr = rotation", "unknown key 'layr'"},
      {"layer = rotation\n", "", "needs 'layer = ...'"},
      {"title = it turns\n", "", "[check.first] needs 'title = ...'"},
      {"title = it turns\n", "titel = it turns\n", "unknown key 'titel'"},
      {"wrong = 01_slip", "wrong = 02_slip", "names the unknown misconception '02_slip'"},
      {"check = first", "check = third", "names the unknown check 'third'"},
      {"says = The sign is wrong.\n", "", "[wrong.01_slip] needs 'says = ...'"},
      {"[hint.2]", "[hint.3]", "hints are numbered 1, 2, ... in order"},
      {"[hint.2]", "[tip.2]", "unknown section [tip.2]"},
  };
  const Course course;
  for (const auto& mistake : mistakes) {
    INFO(mistake.what << " -> " << mistake.by);
    course.write("spin", replaced(kGood, mistake.what, mistake.by));
    bool told = false;
    for (const auto& problem : course.problems()) {
      CHECK_THAT(problem, ContainsSubstring("01_rotation/spin/exercise.ini: "));
      told |= problem.find(mistake.problem) != std::string::npos;
    }
    CHECK(told);
  }
}

TEST_CASE("an exercise without checks is told") {
  const Course course;
  course.write("spin",
               replaced(kGood.substr(0, kGood.find("[check.first]")), "points = 3", "points = 0"));
  const auto problems = course.problems();
  REQUIRE(problems.size() == 1);
  CHECK_THAT(problems[0], ContainsSubstring("has no [check. ...]"));
}

TEST_CASE("exercises are in the order of their files, then by level and name") {
  const Course course;
  for (const auto& [name, order] :
       {std::pair{"zebra", "order = 10"}, {"apple", "order = 30"}, {"mango", "order = 20"}}) {
    course.write(
        name, replaced(replaced(kGood, "01.spin", std::string("01.") + name), "order = 10", order));
  }
  course.write("aaa", replaced(replaced(kGood, "01.spin", "01.aaa"), "order = 10\n", ""));
  std::vector<std::string> problems;
  std::string names;
  for (const auto& e : readExercises(course.root, problems)) names += e.name + " ";
  CHECK(problems.empty());
  CHECK(names == "zebra mango apple aaa ");
}

TEST_CASE("two exercises with one id are told") {
  const Course course;
  course.write("spin", kGood);
  writeFile(course.root / "solutions/01_other/spin/exercise.ini", kGood);
  const auto problems = course.problems();
  REQUIRE(problems.size() == 1);
  CHECK(problems[0] == "two exercises have the id 01.spin");
}

TEST_CASE("a course without exercises has none, and no problems") {
  const Course course;
  CHECK(course.problems().empty());
}

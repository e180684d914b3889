// What `dev new` leaves behind: files that follow from the function, and blanks that dev check names.

#include <unistd.h>

#include "failure.hpp"
#include "runner/develop.hpp"
#include "runner/skeleton.hpp"
#include "support/catch.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;

namespace {

// A project with one chapter and one function that no exercise is about yet.
struct Draft {
  Draft() {
    project.root = fs::temp_directory_path() / ("carom-draft-" + std::to_string(getpid()));
    project.manifest = nlohmann::json::object();
    fs::remove_all(project.root);
    fs::create_directories(project.root / "chapters/05_impulse");
    writeFile(project.root / "lib/carom/impulse/bounce_height.hpp",
              "#pragma once\n// bounceHeight(nothing) in a comment is no declaration.\n\n"
              "namespace carom {\n\nReal bounceHeight(const std::array<Real, 2>& speeds, Real "
              "restitution,\n                  int bounces = 1);\n\n}\n");
    writeFile(project.root / "lib/carom/impulse/bounce_height.cpp",
              "// A comment of the library's own.\n#include \"carom/impulse/bounce_height.hpp\"\n\n"
              "#include <cmath>\n\nnamespace carom {\n\nReal bounceHeight(const std::array<Real, "
              "2>& speeds, Real restitution,\n                  int bounces) {\n  if (bounces < 0) "
              "{\n    return 0;\n  }\n  return speeds[0] * restitution;\n}\n\n}\n");
    fs::create_directories(project.root / "tests/grading");
    writeFile(project.root / "tests/grading/fields_impulse.hpp", "#pragma once\n");
  }
  ~Draft() {
    std::error_code ignored;
    fs::remove_all(project.root, ignored);
  }
  std::string read(const std::string& file) const {
    return readFile(project.root / file);
  }
  Project project{.root = {}, .build = {}, .manifest = {}, .exercises = {}, .problems = {}};
};

}  // namespace

TEST_CASE("a new exercise is cut from the library's function, and its seam is written") {
  const Draft draft;
  const auto written = newExercise(draft.project, {.chapter = "5", .name = "bounce_height"});
  CHECK(written.size() == 8);
  for (const auto& file : written) CHECK(fs::exists(draft.project.root / file));

  const std::string answer = draft.read("solutions/05_impulse/bounce_height/bounce_height.cpp");
  const std::string skeleton = cutSkeleton(answer, "x.cpp");
  CHECK_THAT(skeleton, ContainsSubstring("return todo<Real>(\"bounceHeight\");") &&
                           ContainsSubstring("./course check 05.bounce_height") &&
                           ContainsSubstring("#include \"carom/core/todo.hpp\"") &&
                           !ContainsSubstring("speeds[0]") &&
                           !ContainsSubstring("A comment of the library's own"));
  CHECK_THAT(cutAnswer(answer, "x.cpp"),
             ContainsSubstring("return speeds[0] * restitution;") && !ContainsSubstring("todo<"));
  CHECK_THAT(
      draft.read("tests/graders/05_impulse/bounce_height_seam.cpp"),
      ContainsSubstring("CAROM_SEAM(Real, bounceHeight, (const std::array<Real, 2>& speeds, "
                        "Real restitution, int bounces = 1), (speeds, restitution, bounces))") &&
          ContainsSubstring("grading/fields_impulse.hpp"));
  CHECK_THAT(draft.read("solutions/05_impulse/bounce_height/exercise.ini"),
             ContainsSubstring("id = 05.bounce_height\n") &&
                 ContainsSubstring("layer = impulse\n") &&
                 ContainsSubstring("home = lib/carom/impulse\n"));
}

TEST_CASE("what is still blank in a new exercise is named, each by its key") {
  const Draft draft;
  newExercise(draft.project, {.chapter = "5", .name = "bounce_height"});
  std::vector<std::string> problems;
  const auto e = readExercise(draft.project.root / "solutions/05_impulse/bounce_height", problems);
  std::string all;
  for (const auto& problem : problems) all += problem + "\n";
  for (const char* key :
       {"'title = ...'", "'read = ...'", "[check.first] needs 'title = ...'",
        "[wrong.01_first_slip] needs 'says = ...'", "[hint.2] needs 'text = ...'"})
    CHECK_THAT(all, ContainsSubstring(key));
  CHECK(all.find("unknown") == std::string::npos);

  // Everything is there but the line in the layer's list of seams.
  CHECK(missingFiles(draft.project, e).size() == 1);
  CHECK_THAT(missingFiles(draft.project, e)[0],
             ContainsSubstring("lib/carom/impulse/CMakeLists.txt"));
  fs::remove(draft.project.root / "tests/graders/05_impulse/bounce_height_test.cpp");
  fs::remove(draft.project.root / "lib/carom/impulse/bounce_height.cpp");
  CHECK(missingFiles(draft.project, e).size() == 2);
}

TEST_CASE("a new exercise is refused where it cannot be, with what to do") {
  const Draft draft;
  const auto refused = [&](const NewExercise& wanted) {
    return carom_test::failureOf([&] { newExercise(draft.project, wanted); });
  };
  CHECK_THAT(
      refused({.chapter = "5", .name = "bounce_hight"}),
      ContainsSubstring("there is no bounce_hight.hpp") && ContainsSubstring("Adding an exercise"));
  CHECK_THAT(refused({.chapter = "5", .name = "Bounce"}), ContainsSubstring("small letters"));
  CHECK_THAT(refused({.chapter = "12", .name = "bounce_height"}),
             ContainsSubstring("there is no chapter '12'"));
  CHECK_THAT(refused({.chapter = "5", .name = "bounce_height", .kind = "quiz"}),
             ContainsSubstring("there is no kind 'quiz'"));
  CHECK_THAT(refused({.chapter = "5", .name = "cases", .kind = "test"}),
             ContainsSubstring("--tests"));
  newExercise(draft.project, {.chapter = "5", .name = "bounce_height"});
  CHECK_THAT(refused({.chapter = "5", .name = "bounce_height"}),
             ContainsSubstring("exists already"));
}

TEST_CASE("a new prediction asks for a number with its unit") {
  const Draft draft;
  newExercise(draft.project, {.chapter = "5", .name = "how_high", .kind = "predict"});
  const std::string answer = draft.read("solutions/05_impulse/how_high/how_high.txt");
  CHECK_THAT(cutSkeleton(answer, "x.txt"), ContainsSubstring("answer = ? m"));
  CHECK_THAT(cutAnswer(answer, "x.txt"), ContainsSubstring("answer = 1 m"));
}

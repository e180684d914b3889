// Does progress survive what happens to its file?

#include "runner/state.hpp"

#include <unistd.h>

#include "support/catch.hpp"

using namespace carom::runner;

namespace {

struct Course {
  fs::path root = fs::path(CAROM_BUILD_DIR) / "work" / ("state-test-" + std::to_string(getpid()));
  Project project;
  Course() {
    fs::create_directories(root);
    project.root = root;
    Exercise e;
    e.id = "01.spin";
    e.name = "spin";
    e.chapter = "01_rotation";
    e.extension = ".cpp";
    e.folder = root / "solutions/01_rotation/spin";
    project.exercises.push_back(e);
    writeFile(e.folder / "spin.cpp", "//# solution\na;\n//# stub\n//#| b;\n//# end\n");
    writeFile(root / e.studentFile(), "my answer;\n");
  }
  ~Course() {
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
  const Exercise& exercise() const {
    return project.exercises[0];
  }
  fs::path file() const {
    return root / ".carom/state.json";
  }
  void pass() const {
    State state(root);
    ExerciseResult result;
    result.exercise = &exercise();
    result.status = Status::passed;
    state.remember(project, result);
    state.sawHint("01.spin", 2);
    state.save();
  }
};

}  // namespace

TEST_CASE("a pass is remembered for just the file that passed") {
  const Course course;
  CHECK(State(course.root).statusOf(course.project, course.exercise()) == Status::notRun);
  course.pass();
  CHECK(State(course.root).statusOf(course.project, course.exercise()) == Status::passed);
  CHECK(State(course.root).hintsSeen("01.spin") == 2);
  writeFile(course.root / course.exercise().studentFile(), "my other answer;\n");
  CHECK(State(course.root).statusOf(course.project, course.exercise()) == Status::notRun);
  writeFile(course.root / course.exercise().studentFile(), "my answer;\n");
  CHECK(State(course.root).statusOf(course.project, course.exercise()) == Status::passed);
}

TEST_CASE("the skeleton, or no file at all, is not started") {
  const Course course;
  course.pass();
  writeFile(course.root / course.exercise().studentFile(), "b;\n");
  CHECK(State(course.root).statusOf(course.project, course.exercise()) == Status::notStarted);
  fs::remove(course.root / course.exercise().studentFile());
  CHECK(State(course.root).statusOf(course.project, course.exercise()) == Status::notStarted);
}

TEST_CASE("hints are counted up, never down") {
  const Course course;
  State state(course.root);
  CHECK(state.hintsSeen("01.spin") == 0);
  state.sawHint("01.spin", 2);
  state.sawHint("01.spin", 1);
  CHECK(state.hintsSeen("01.spin") == 2);
}

TEST_CASE("a damaged file is put aside, and progress begins anew") {
  for (const char* damaged :
       {"", "{", "[]", "7", "{\"01.spin\": 5}", "{\"01.spin\": {\"hash\": 5}}",
        "{\"01.spin\": {\"status\": []}}", "{\"01.spin\": {\"hints\": \"many\"}}", "\xff\xfe"}) {
    INFO(damaged);
    const Course course;
    writeFile(course.file(), damaged);
    State state(course.root);
    CHECK(state.statusOf(course.project, course.exercise()) == Status::notRun);
    CHECK(state.hintsSeen("01.spin") == 0);
    CHECK(readIfThere(course.root / ".carom/state.json.damaged") == std::string(damaged));
    course.pass();
    CHECK(State(course.root).statusOf(course.project, course.exercise()) == Status::passed);
  }
}

TEST_CASE("an empty course has no damaged file") {
  const Course course;
  CHECK(State(course.root).hintsSeen("01.spin") == 0);
  CHECK_FALSE(fs::exists(course.root / ".carom/state.json.damaged"));
}

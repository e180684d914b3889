#pragma once
// A course as a student has it: the runner itself, on a copy of a few exercises, in a folder whose name has a blank and
// an accent. The working tree's own exercises are never read: somebody may be working on them.

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "grading/process.hpp"
#include "runner/skeleton.hpp"
#include "runner/text.hpp"
#include "support/catch.hpp"

namespace carom_test {

using nlohmann::json;
namespace runner = carom::runner;
namespace fs = std::filesystem;

inline const std::string kId = "01.hamilton_product";
inline const fs::path kSolution =
    fs::path(CAROM_SOURCE_DIR) / "solutions/01_rotation/hamilton_product";

class Course {
 public:
  Course() {
    root_ = fs::path(CAROM_BUILD_DIR) / "work" / ("cöurse test " + std::to_string(getpid()));
    fs::remove_all(root_);
    fs::create_directories(root_ / "solutions/01_rotation");
    fs::create_directories(root_ / "chapters/01_rotation");
    fs::create_directories(root_ / "tests/graders/01_rotation");
    fs::copy(kSolution, root_ / "solutions/01_rotation/hamilton_product",
             fs::copy_options::recursive);
    const char* const prints = "tests/graders/01_rotation/hamilton_product.fingerprints.json";
    fs::copy(fs::path(CAROM_SOURCE_DIR) / prints, root_ / prints);
    write(skeleton());
  }
  ~Course() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  const fs::path& root() const {
    return root_;
  }
  fs::path file() const {
    return root_ / "exercises/01_rotation/hamilton_product.cpp";
  }
  static std::string skeleton() {
    return runner::cutSkeleton(runner::readFile(kSolution / "hamilton_product.cpp"), "x.cpp");
  }
  static std::string answer() {
    return runner::cutAnswer(runner::readFile(kSolution / "hamilton_product.cpp"), "x.cpp");
  }
  static std::string wrong(const char* name) {
    return runner::readFile(kSolution / "wrong" / name);
  }
  void write(const std::string& content) const {
    runner::writeFile(file(), content);
  }

  // One more exercise: "03_detection/test_aabb_overlap".
  void take(const std::string& exercise) const {
    const fs::path source = fs::path(CAROM_SOURCE_DIR) / "solutions" / exercise;
    fs::create_directories((root_ / "solutions" / exercise).parent_path());
    fs::create_directories(root_ / "chapters" / fs::path(exercise).parent_path());
    fs::copy(source, root_ / "solutions" / exercise, fs::copy_options::recursive);
    for (const char* what : {".fingerprints.json", ".versions.json"}) {
      const std::string packed = "tests/graders/" + exercise + what;
      if (!fs::exists(fs::path(CAROM_SOURCE_DIR) / packed)) continue;
      fs::create_directories((root_ / packed).parent_path());
      fs::copy(fs::path(CAROM_SOURCE_DIR) / packed, root_ / packed);
    }
    const fs::path name = fs::path(exercise).filename().string() + ".cpp";
    runner::writeFile(root_ / "exercises" / (exercise + ".cpp"),
                      runner::cutSkeleton(runner::readFile(source / name), "x.cpp"));
  }

  carom::grading::Finished operator()(std::vector<std::string> words) const {
    return with({}, std::move(words));
  }
  // With other variables of the environment.
  carom::grading::Finished with(const std::vector<std::string>& environment,
                                std::vector<std::string> words) const {
    carom::grading::Command command;
    command.words = {CAROM_RUNNER, "--root", root_.string(), "--build", CAROM_BUILD_DIR};
    command.words.insert(command.words.end(), words.begin(), words.end());
    command.environment = environment;
    return run(std::move(command));
  }
  // With what a command writes as its input, for as long as that runs.
  carom::grading::Finished shell(const std::string& input, std::vector<std::string> words) const {
    carom::grading::Command command;
    command.words = {"sh",     "-c",           input + " | \"$@\"", "sh",           CAROM_RUNNER,
                     "--root", root_.string(), "--build",           CAROM_BUILD_DIR};
    command.words.insert(command.words.end(), words.begin(), words.end());
    return run(std::move(command));
  }
  json inJson(std::vector<std::string> words, int exitCode) const {
    words.push_back("--json");
    const auto done = (*this)(words);
    INFO(done.output);
    CHECK(done.exitCode == exitCode);
    // A Failure is said on both streams: in JSON, and in words behind it.
    const auto end = exitCode == runner::usage ? done.output.rfind("}\n") : std::string::npos;
    json parsed = json::parse(done.output.substr(0, end == std::string::npos ? end : end + 1),
                              nullptr, false);
    CHECK_FALSE(parsed.is_discarded());
    return parsed;
  }

 private:
  static carom::grading::Finished run(carom::grading::Command command) {
    // A compiler that knows the language writes typographic quotes.
    command.environment.push_back("LC_ALL=C.UTF-8");
    command.limits = {.wallSeconds = 300, .cpuSeconds = 0, .outputKilobytes = 4096};
    return carom::grading::run(command);
  }

  fs::path root_;
};

}  // namespace carom_test

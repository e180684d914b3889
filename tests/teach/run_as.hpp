#pragma once
// Programs that tests run in the place of a student, git above all: with a name and a date that are
// the same in every run, and nobody's settings.

#include <filesystem>
#include <string>
#include <vector>

#include "grading/process.hpp"
#include "support/catch.hpp"

namespace carom_test {

/// Who runs something, and when.
struct Author {
  std::string name;  ///< one word
  std::string date;  ///< of what is committed: "2026-11-30T12:00:00Z"
};

/// Runs a program, which must succeed. \param author for git \param words the program and what it
/// is given \param folder where it runs
inline void runAs(const Author& author, const std::vector<std::string>& words,
                  const std::filesystem::path& folder) {
  carom::grading::Command command;
  command.words = words;
  command.directory = folder.string();
  command.environment = {"GIT_CONFIG_GLOBAL=/dev/null"};
  for (const std::string role : {"AUTHOR", "COMMITTER"}) {
    command.environment.push_back("GIT_" + role + "_NAME=" + author.name);
    command.environment.push_back("GIT_" + role + "_EMAIL=" + author.name + "@example.org");
    command.environment.push_back("GIT_" + role + "_DATE=" + author.date);
  }
  const auto done = carom::grading::run(command);
  INFO(done.output);
  REQUIRE(done.ok());
}

}  // namespace carom_test

#include "runner/manifest.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>

#include "grading/process.hpp"

namespace carom::runner {

using nlohmann::json;

const json& Project::entry(const Exercise& exercise) const {
  const auto& all = manifest.at("exercises");
  const auto found = all.find(exercise.id);
  if (found == all.end()) {
    throw Failure{ourFault,
                  "the build does not know exercise " + exercise.id + ": run ./course doctor"};
  }
  return *found;
}

const Exercise& Project::find(const std::string& id) const {
  const Exercise* found = nullptr;
  std::string near;
  for (const auto& e : exercises) {
    if (e.id == id || e.name == id) found = &e;
    if (!id.empty() &&
        (e.id.find(id) != std::string::npos || e.title.find(id) != std::string::npos)) {
      near += "\n  " + e.id + "  " + e.title;
    }
  }
  if (!found) {
    throw Failure{usage,
                  "there is no exercise '" + id + "'" +
                      (near.empty() ? "; ./course list shows them all" : "; did you mean" + near)};
  }
  return *found;
}

std::string Project::chapterFolder(const std::string& chapter) const {
  std::string digits = chapter;
  if (!digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos &&
      digits.size() < 2) {
    digits = "0" + digits;
  }
  std::error_code none;
  std::string all;
  for (const auto& folder : fs::directory_iterator(root / "chapters", none)) {
    const std::string name = folder.path().filename().string();
    if (!folder.is_directory()) continue;
    if (name == chapter || name.substr(0, 2) == digits ||
        (name.size() > 3 && name.substr(3) == chapter))
      return name;
    all += " " + name;
  }
  throw Failure{usage, "there is no chapter '" + chapter + "'; there are" + all};
}

std::vector<const Exercise*> Project::select(const std::string& what) const {
  std::vector<const Exercise*> selected;
  if (what == "all") {
    for (const auto& e : exercises) selected.push_back(&e);
    return selected;
  }
  for (const auto& e : exercises) {
    if (e.id == what || e.name == what) return {&e};
  }
  if (what.find('.') == std::string::npos) {
    try {
      const std::string folder = chapterFolder(what);
      for (const auto& e : exercises) {
        if (e.chapter == folder) selected.push_back(&e);
      }
      return selected;
    } catch (const Failure&) {
      // Not a chapter: let the message of find() say what there is.
    }
  }
  return {&find(what)};
}

std::string Project::text(const char* key) const {
  return manifest.at(key).get<std::string>();
}

Project openProject(const fs::path& root, const fs::path& build) {
  Project project{.root = root, .build = build, .manifest = {}, .exercises = {}, .problems = {}};
  const auto content = readIfThere(build / "course.json");
  if (!content)
    throw Failure{ourFault, "the project is not configured (no course.json): run ./course start"};
  project.manifest = json::parse(*content, nullptr, false);
  if (project.manifest.is_discarded()) {
    throw Failure{ourFault, (build / "course.json").string() + " is damaged: run ./course start"};
  }
  project.exercises = readExercises(root, project.problems);
  return project;
}

void buildTargets(const Project& project, const std::vector<std::string>& targets, bool quiet) {
  if (targets.empty()) return;
  // One builder at a time: `watch` in one window and `check` in another would build the same files at once. The lock
  // goes with the process.
  const int lock =
      open((project.build / ".course-lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  const struct Unlock {
    int file;
    ~Unlock() {
      if (file >= 0) close(file);
    }
  } unlock{lock};
  while (lock >= 0 && flock(lock, LOCK_EX) != 0 && errno == EINTR) {
  }
  grading::Command command;
  command.words = {project.text("cmake"), "--build", project.build.string(), "--target"};
  command.words.insert(command.words.end(), targets.begin(), targets.end());
  command.limits = {.wallSeconds = 0, .cpuSeconds = 0, .outputKilobytes = 0};
  command.inheritOutput = !quiet && isatty(1);
  const auto done = grading::run(command);
  if (!done.ok()) {
    std::string tail;
    const auto lines = splitLines(done.output);
    for (std::size_t i = lines.size() > 30 ? lines.size() - 30 : 0; i < lines.size(); ++i)
      tail += lines[i] + "\n";
    throw Failure{ourFault, "the build failed (" + done.end + ")\n" + tail};
  }
}

}  // namespace carom::runner

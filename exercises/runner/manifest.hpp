#pragma once
// How this build compiles and links: the file course.json that CMake writes.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/exercise.hpp"

namespace carom::runner {

/// Where things are, and how to build them.
struct Project {
  fs::path root;
  fs::path build;
  nlohmann::json manifest;
  std::vector<Exercise> exercises;
  std::vector<std::string> problems;  ///< what is wrong with the exercises' metadata

  /// The entry of course.json for an exercise. \throws Failure when the build does not know it
  const nlohmann::json& entry(const Exercise& exercise) const;
  /// The exercise with this id, or with this id less its chapter number. \throws Failure (usage) with the nearest ids
  const Exercise& find(const std::string& id) const;
  /// All exercises, of a chapter ("1", "01", "01_rotation"), or one.
  std::vector<const Exercise*> select(const std::string& what) const;
  /// The folder of a chapter. \throws Failure (usage)
  std::string chapterFolder(const std::string& chapter) const;
  std::string text(const char* key) const;
};

Project openProject(const fs::path& root, const fs::path& build);

/// Brings targets of the build up to date, showing progress only when there is something to do.
/// \throws Failure (ourFault) with the build's last lines
void buildTargets(const Project& project, const std::vector<std::string>& targets, bool quiet);

}  // namespace carom::runner

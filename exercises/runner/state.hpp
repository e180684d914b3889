#pragma once
// What the runner remembers between calls: which file passed, and how many hints were seen.

#include "runner/check.hpp"

namespace carom::runner {

/// Progress, kept in .carom/state.json by exercise id and by the content of the student's file, so that an edit
/// after a pass is seen and a renamed chapter loses nothing. A damaged file is put aside, never trusted.
class State {
 public:
  explicit State(const fs::path& root);
  /// The outcome of the last check of just this content; notRun when it was never checked.
  Status statusOf(const Project& project, const Exercise& exercise) const;
  void remember(const Project& project, const ExerciseResult& result);
  int hintsSeen(const std::string& id) const;
  void sawHint(const std::string& id, int number);
  void save() const;

 private:
  fs::path file_;
  nlohmann::json all_;
};

/// Has the student's file been changed since it was cut?
bool isSkeleton(const Project& project, const Exercise& exercise);

}  // namespace carom::runner

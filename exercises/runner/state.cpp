#include "runner/state.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

// Has the file the shape that save() gives it? Then nothing below meets a value of another type.
bool isSound(const json& all) {
  if (!all.is_object()) return false;
  for (const auto& entry : all) {
    if (!entry.is_object()) return false;
    for (const char* text : {"hash", "status"}) {
      if (entry.contains(text) && !entry[text].is_string()) return false;
    }
    if (entry.contains("hints") && !entry["hints"].is_number_integer()) return false;
  }
  return true;
}

}  // namespace

State::State(const fs::path& root) : file_(root / ".carom" / "state.json") {
  const auto content = readIfThere(file_);
  all_ = json::parse(content.value_or("{}"), nullptr, false);
  if (!isSound(all_)) {
    std::error_code ignored;
    fs::path aside = file_;
    aside += ".damaged";
    fs::rename(file_, aside, ignored);
    all_ = json::object();
  }
}

Status State::statusOf(const Project& project, const Exercise& exercise) const {
  const auto content = readIfThere(project.root / exercise.studentFile());
  if (!content || isSkeleton(project, exercise)) return Status::notStarted;
  const auto entry = all_.find(exercise.id);
  if (entry == all_.end() || entry->value("hash", "") != hashOf(*content)) return Status::notRun;
  const std::string name = entry->value("status", "");
  for (const Status status : {Status::passed, Status::wrong, Status::notStarted, Status::stopped,
                              Status::refused, Status::doesNotCompile}) {
    if (name == nameOf(status)) return status;
  }
  return Status::notRun;
}

void State::remember(const Project& project, const ExerciseResult& result) {
  const auto content = readIfThere(project.root / result.exercise->studentFile());
  if (!content) return;
  auto& entry = all_[result.exercise->id];
  entry["hash"] = hashOf(*content);
  entry["status"] = nameOf(result.status);
}

int State::hintsSeen(const std::string& id) const {
  const auto entry = all_.find(id);
  return entry == all_.end() ? 0 : entry->value("hints", 0);
}

void State::sawHint(const std::string& id, int number) {
  all_[id]["hints"] = std::max(number, hintsSeen(id));
}

void State::save() const {
  writeFile(file_, all_.dump(1) + "\n");
}

bool isSkeleton(const Project& project, const Exercise& exercise) {
  const auto content = readIfThere(project.root / exercise.studentFile());
  return content && content == skeletonOf(exercise);
}

}  // namespace carom::runner

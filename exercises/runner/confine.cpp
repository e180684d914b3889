#include "runner/confine.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <map>
#include <mutex>
#include <set>

namespace carom::runner {

namespace {

// Processes of uid 65534 at once: a bomb's end, and room for the compilers of a machine with many cores.
constexpr int kProcesses = 512;

// Copies what has changed, so that it can be read by everybody and looks as old as it is: a precompiled header asks.
void copyIfNewer(const fs::path& from, const fs::path& to) {
  std::error_code none;
  const auto time = fs::last_write_time(from);
  if (fs::last_write_time(to, none) == time && fs::file_size(to, none) == fs::file_size(from))
    return;
  // Another grader may be about to read it.
  fs::path fresh = to;
  fresh += "." + std::to_string(getpid());
  fs::copy_file(from, fresh, fs::copy_options::overwrite_existing);
  chmod(fresh.c_str(), 0644);
  fs::last_write_time(fresh, time);
  fs::rename(fresh, to);
}

// The headers of a folder without its sources, which hold answers. A copy in the build folder, brought up to date once
// in the life of the process.
fs::path headersOf(const Project& project, const fs::path& folder) {
  static std::mutex lock;
  static std::map<fs::path, fs::path> made;
  const std::lock_guard guard(lock);
  auto& copy = made[project.build / folder.relative_path()];
  if (!copy.empty()) return copy;
  const fs::path target = project.build / "headers" / folder.relative_path();
  std::set<fs::path> kept;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".hpp" || !entry.is_regular_file()) continue;
    const fs::path relative = entry.path().lexically_relative(folder);
    fs::create_directories((target / relative).parent_path());
    copyIfNewer(entry.path(), target / relative);
    kept.insert(relative);
  }
  for (const auto& entry : fs::recursive_directory_iterator(target)) {
    if (entry.path().extension() == ".hpp" &&
        !kept.contains(entry.path().lexically_relative(target)))
      fs::remove(entry.path());
  }
  return copy = target;
}

// Libraries that a program of ours is linked with, the loader among them: the loader lists them.
std::vector<fs::path> librariesOf(const fs::path& program) {
  static std::mutex lock;
  static std::map<fs::path, std::vector<fs::path>> known;
  const std::lock_guard guard(lock);
  auto& libraries = known[program];
  if (!libraries.empty()) return libraries;
  grading::Command command;
  command.words = {program.string()};
  command.environment = {"LD_TRACE_LOADED_OBJECTS=1"};
  const auto done = grading::run(command);
  for (const auto& line : splitLines(done.output)) {
    for (const auto& word : words(line)) {
      if (word.starts_with("/") && fs::exists(word)) libraries.emplace_back(word);
    }
  }
  if (libraries.empty())
    throw Failure{ourFault, program.string() + " does not say what it is linked with: " + done.end};
  return libraries;
}

grading::Confinement toolchain(const Project& project) {
  grading::Confinement confinement;
  confinement.toolchain = true;
  confinement.hidden = {project.root, project.build};
  // A compiler of one's own, /opt/gcc-14/bin/g++, and what belongs to it: only that folder of /opt is shown.
  for (const char* tool : {"compiler", "nm"}) {
    const fs::path path = fs::weakly_canonical(project.text(tool));
    if (std::distance(path.begin(), path.end()) > 3 && *std::next(path.begin()) == "opt")
      confinement.readable.push_back("/opt" / *std::next(path.begin(), 2));
  }
  return confinement;
}

grading::Command confinedTo(grading::Command command, const grading::Confinement& confinement,
                            const grading::Sandbox& sandbox) {
  command.limits.processes = kProcesses;
  try {
    return grading::confined(std::move(command), confinement, sandbox);
  } catch (const std::invalid_argument& error) {
    throw Failure{ourFault, error.what()};
  }
}

// A compiler keeps no intermediate files where it can do without, and the rest beside its output.
void keepTogether(grading::Command& command, const fs::path& out) {
  command.words.push_back("-pipe");
  command.environment.push_back("TMPDIR=" + out.string());
  command.environment.push_back("PATH=/usr/local/bin:/usr/bin:/bin");
}

}  // namespace

OutFolder::OutFolder(const fs::path& beside) : path_(beside / "out") {
  fs::create_directory(path_);
}

OutFolder::~OutFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

bool OutFolder::take(const std::string& name, const fs::path& target) const {
  const fs::path file = path_ / name;
  struct stat entry {};
  // A second name for the file would be a way to change it afterwards.
  if (lstat(file.c_str(), &entry) != 0 || !S_ISREG(entry.st_mode) || entry.st_nlink != 1)
    return false;
  if (geteuid() == 0 && lchown(file.c_str(), 0, 0) != 0) return false;
  fs::rename(file, target);
  return chmod(target.c_str(), entry.st_mode & S_IXUSR ? 0755 : 0644) == 0;
}

grading::Command confinedCompiler(const Project& project, const Exercise& exercise,
                                  grading::Command command, const fs::path& source,
                                  const fs::path& out, const grading::Sandbox& sandbox) {
  const fs::path home = project.entry(exercise).at("home").get<std::string>();
  auto confinement = toolchain(project);
  auto headers = [&](const fs::path& folder) {
    confinement.shown.emplace_back(headersOf(project, folder), folder);
  };
  bool homeSeen = false;
  for (const auto& include : project.manifest.at("includes")) {
    const fs::path folder = include.get<std::string>();
    headers(folder);
    homeSeen |= home.lexically_relative(folder).string().rfind("..", 0) != 0;
  }
  if (!homeSeen) headers(home);
  if (exercise.isTest()) headers(project.root / "tests/support");
  for (const auto& include : project.manifest.at("system_includes")) {
    const fs::path folder = include.get<std::string>();
    // What is in /usr is part of the toolchain.
    if (!folder.empty() && !folder.string().starts_with("/usr/"))
      confinement.readable.push_back(folder);
  }
  confinement.readable.push_back(project.text("no_geometry_include"));
  confinement.readable.push_back(project.build / "course_pch");
  confinement.readable.push_back(source);
  confinement.writable.push_back(out);
  keepTogether(command, out);
  return confinedTo(std::move(command), confinement, sandbox);
}

grading::Command confinedTool(const Project& project, grading::Command command,
                              const std::vector<fs::path>& inputs, const fs::path& out,
                              const grading::Sandbox& sandbox) {
  auto confinement = toolchain(project);
  confinement.readable.insert(confinement.readable.end(), inputs.begin(), inputs.end());
  if (!out.empty()) {
    confinement.writable.push_back(out);
    keepTogether(command, out);
  }
  return confinedTo(std::move(command), confinement, sandbox);
}

grading::Command confinedProgram(grading::Command command, const fs::path& trusted,
                                 const grading::Sandbox& sandbox) {
  grading::Confinement confinement;
  confinement.readable = librariesOf(trusted.empty() ? "/proc/self/exe" : trusted);
  confinement.readable.emplace_back(command.words.at(0));
  command.shutIn = true;
  command.directory.clear();
  return confinedTo(std::move(command), confinement, sandbox);
}

}  // namespace carom::runner

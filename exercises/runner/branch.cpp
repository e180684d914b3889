#include "runner/branch.hpp"

#include <algorithm>
#include <iostream>
#include <set>

#include "runner/build.hpp"
#include "runner/skeleton.hpp"
#include "runner/trial.hpp"

namespace carom::runner {

namespace {

// The last line of every commit that is written here, by which it is known again.
const std::string kMark = "Cut-By: course teach branch";

struct Ref {
  std::string name;  // refs/heads/student
  std::string commit;
};

std::string numberOf(const std::string& chapter) {
  return chapter.substr(0, 2);
}

// Is this branch or tag absent, or one that an earlier run has written?
void requireOurs(const Git& git, const std::string& ref) {
  const auto message = git.tried({"log", "-1", "--format=%B", ref, "--"});
  if (!message || message->find(kMark) != std::string::npos) return;
  throw Failure{usage, ref +
                           " is there already and was not written by teach branch: choose other "
                           "names with --student and --solved"};
}

void requireNotCheckedOut(const Git& git, const std::string& ref) {
  for (const auto& line : splitLines(git({"worktree", "list", "--porcelain"}))) {
    if (line == "branch " + ref) {
      throw Failure{usage, "the branch " + ref.substr(std::string("refs/heads/").size()) +
                               " is checked out: switch to another one first"};
    }
  }
}

Cut readCut(const Project& project, const BranchOptions& options, const fs::path& source) {
  const Git root(project.root);
  if (!root.tried({"rev-parse", "--verify", "-q", "HEAD"}))
    throw Failure{usage, project.root.string() + " is no git repository with a commit"};
  const std::string changed = root({"status", "--porcelain", "--untracked-files=no"});
  if (!changed.empty()) {
    std::cout << "The branches are cut from the last commit. Changes that are not committed are "
                 "not in them:\n"
              << changed << "\n";
  }
  root({"clone", "-q", "--shared", "--no-tags", project.root.string(), source.string()});
  Cut cut{.source = source,
          .files = readTree(Git(source), "HEAD"),
          .exercises = {},
          .course = {},
          .upto = {},
          .today = options.today.empty() ? todaysDate() : options.today};
  if (!isDate(cut.today))
    throw Failure{usage, "--today " + cut.today + ": a day is written 2026-12-01"};
  std::vector<std::string> problems;
  cut.exercises = readExercises(source, problems);
  if (cut.exercises.empty())
    throw Failure{usage, "there are no exercises below solutions/ in the last commit"};
  if (!problems.empty()) throw Failure{ourFault, problems.front()};
  const Project clean{.root = source,
                      .build = project.build,
                      .manifest = {},
                      .exercises = cut.exercises,
                      .problems = {}};
  cut.course =
      options.courseFile.empty() ? defaultCourse(clean) : readCourse(options.courseFile, clean);
  cut.upto =
      options.upto.empty() ? *cut.course.chapters.rbegin() : clean.chapterFolder(options.upto);
  if (!cut.course.secretFile.empty()) {
    const std::string inside =
        fs::relative(cut.course.secretFile, fs::canonical(project.root)).string();
    if (cut.files.count(inside))
      throw Failure{usage,
                    "the secret " + inside + " is committed: git rm --cached it, and take another"};
  }
  return cut;
}

// A repository of our own, in which commits are made before anybody sees them.
Git openScratch(const Project& project, const BranchOptions& options, const fs::path& folder) {
  const Git root(project.root);
  root({"clone", "-q", "--bare", "--shared", "--no-tags", project.root.string(), folder.string()});
  const Git git(folder);
  if (options.out.empty()) return git;
  for (const auto& name : {options.student, options.solved})
    git.tried({"update-ref", "-d", "refs/heads/" + name});
  if (!fs::exists(options.out) || fs::is_empty(options.out)) return git;
  const Git out(fs::absolute(options.out));
  if (!out.tried({"rev-parse", "--git-dir"}))
    throw Failure{usage, "--out " + options.out.string() + " is neither empty nor a repository"};
  const std::string ref = "refs/heads/" + options.student;
  if (out.tried({"rev-parse", "--verify", "-q", ref}))
    git({"fetch", "-q", "--no-tags", out.folder().string(), ref + ":" + ref});
  return git;
}

std::string titleOf(const Cut& cut) {
  const auto chapters = cut.chapters();
  std::string text = cut.course.title + ": ";
  if (chapters.empty()) return text + "no chapter";
  if (chapters.size() == 1) return text + "chapter " + numberOf(chapters.front());
  return text + "chapters " + numberOf(chapters.front()) + " to " + numberOf(chapters.back());
}

std::vector<std::string> exercisesOf(const Cut& cut, const std::string& chapter) {
  std::vector<std::string> ids;
  for (const auto& e : cut.exercises) {
    const auto standing = cut.standing(e);
    if (e.chapter == chapter && (standing == Standing::open || standing == Standing::shown))
      ids.push_back(e.id);
  }
  return ids;
}

// The student branch: a root of its own, and then one commit for each time that something is new.
std::string commitStudent(const Cut& cut, const Git& git, const Tree& tree, const std::string& tip,
                          const Signature& by, const fs::path& scratch) {
  const std::string id = writeTree(git, tree, scratch);
  if (!tip.empty() && git({"rev-parse", tip + "^{tree}"}) == id) return tip;
  return commitTree(git, id, tip, titleOf(cut) + "\n\n" + kMark, by);
}

// The solution branch: the student's files, and then a commit for each chapter that puts in its answers.
std::vector<Ref> commitSolved(const Cut& cut, const Git& git, const Tree& student,
                              const BranchOptions& options, const Signature& by,
                              const fs::path& scratch) {
  std::string at = commitTree(git, writeTree(git, student, scratch), "",
                              titleOf(cut) + ", before the first answer\n\n" + kMark, by);
  std::vector<Ref> refs;
  std::vector<std::string> done;
  for (const auto& chapter : cut.chapters()) {
    refs.push_back({"refs/tags/ch" + numberOf(chapter) + "-start", at});
    done.push_back(chapter);
    std::string message = "Chapter " + numberOf(chapter) + ", solved";
    for (const auto& id : exercisesOf(cut, chapter))
      message += (id == exercisesOf(cut, chapter)[0] ? "\n\n" : "\n") + id;
    at = commitTree(git, writeTree(git, solvedTree(cut, student, done), scratch), at,
                    message + "\n\n" + kMark, by);
    refs.push_back({"refs/tags/ch" + numberOf(chapter) + "-solved", at});
  }
  refs.push_back({"refs/heads/" + options.solved, at});
  return refs;
}

// exercises/x/given/y/skeleton.cpp is exercises/x/y.cpp once more.
std::string asAuthored(const std::string& path) {
  const fs::path file(path);
  if (file.stem() != "skeleton" || path.find("/given/") == std::string::npos) return path;
  return (file.parent_path().parent_path().parent_path() /
          (file.parent_path().filename().string() + file.extension().string()))
      .string();
}

int tell(const std::vector<Leak>& leaks) {
  std::size_t told = 0;
  for (const auto& leak : leaks) {
    if (++told > 30) {
      std::cout << "and " << leaks.size() - 30 << " more\n";
      break;
    }
    std::cout << leak.exercise << ": " << leak.where
              << (leak.line ? ":" + std::to_string(leak.line) : "") << " holds of its answer  "
              << leak.text << "\n";
  }
  if (!leaks.empty()) {
    std::cout << "No branch was written: an answer that does not show is left. Take it out, or say "
                 "in solutions/ordinary_lines.tsv why the line is none.\n";
  }
  return leaks.empty() ? Exit::pass : Exit::checkFailed;
}

// Moves all branches and tags at once.
void deliver(const Project& project, const BranchOptions& options, const Git& made,
             const std::vector<Ref>& refs) {
  const Git target(options.out.empty() ? project.root : fs::absolute(options.out));
  if (!fs::exists(target.folder()) || fs::is_empty(target.folder())) {
    fs::create_directories(target.folder());
    target({"init", "-q", "--bare", "-b", options.student, "."});
  }
  std::vector<std::string> command = {"fetch",
                                      "-q",
                                      "--atomic",
                                      "--no-tags",
                                      "--no-write-fetch-head",
                                      "--no-auto-maintenance",
                                      made.folder().string()};
  for (const auto& ref : refs) {
    const std::string own = "refs/cut/" + ref.name.substr(std::string("refs/").size());
    made({"update-ref", own, ref.commit});
    command.push_back("+" + own + ":" + ref.name);
  }
  target(command);
}

}  // namespace

SecretLines secretLines(const Cut& cut) {
  std::set<std::string> answers;
  for (const auto& e : cut.exercises) answers.insert(Cut::libraryFile(e));
  std::vector<SourceText> texts;
  for (const auto& [path, file] : cut.files) {
    const bool code = path.ends_with(".cpp") || path.ends_with(".hpp");
    if (code && (path.starts_with("lib/") || path.starts_with("chapters/")) && !answers.count(path))
      texts.push_back({path, readFile(cut.source / path)});
  }
  return {cut.source, cut.secret(), texts};
}

std::vector<Leak> leaksInHistory(const Cut& cut, const SecretLines& secrets, const Git& git,
                                 const std::string& commit, const fs::path& scratch) {
  // Whole files: everything that is authored for a secret exercise and not meant to be read.
  std::map<std::string, std::pair<std::string, std::string>> forbidden;  // blob: exercise, path
  for (const auto* e : cut.secret()) {
    const std::string folder = "solutions/" + e->chapter + "/" + e->name + "/";
    // What is to be mended may be one of the known wrong versions as it stands.
    const std::string skeleton =
        cutSkeleton(readFile(cut.source / folder / e->fileName()), e->fileName());
    for (const auto& [path, file] : cut.files) {
      const bool open = path == folder + "statement.md" || path == folder + "exercise.ini";
      const bool answer = (path.starts_with(folder) && !open) || path == Cut::libraryFile(*e);
      if (answer && readFile(cut.source / path) != skeleton) forbidden[file.blob] = {e->id, path};
    }
  }
  // Packed, so that their lines are not found.
  for (const auto& e : cut.exercises) {
    const auto versions = cut.files.find(Cut::versionsFile(e));
    if (versions != cut.files.end() && !cut.showsVersions(e))
      forbidden[versions->second.blob] = {e.tests, versions->first};
  }
  std::vector<Leak> leaks;
  for (const auto& blob : reachableBlobs(git, commit, scratch)) {
    const auto whole = forbidden.find(blob.id);
    if (whole != forbidden.end() && !blob.content.empty())
      leaks.push_back({whole->second.first, blob.path, 0, "the whole of " + whole->second.second});
    const auto lines = secrets.leaksIn(asAuthored(blob.path), blob.content);
    leaks.insert(leaks.end(), lines.begin(), lines.end());
  }
  return leaks;
}

int cutBranches(const Project& project, const BranchOptions& options) {
  const WorkFolder folder(project);
  const fs::path scratch = folder.path() / "scratch";
  if (options.student == options.solved)
    throw Failure{usage, "--student and --solved name the same branch"};
  for (const auto& name : {options.student, options.solved}) {
    if (!Git(project.root).tried({"check-ref-format", "--branch", name}))
      throw Failure{usage, "'" + name + "' cannot be the name of a branch"};
  }
  const Cut cut = readCut(project, options, folder.path() / "source");
  const Git git = openScratch(project, options, folder.path() / "made.git");
  const std::string studentRef = "refs/heads/" + options.student;
  requireOurs(git, studentRef);
  const Git target(options.out.empty() ? project.root : fs::absolute(options.out));
  if (options.out.empty()) {
    for (const auto& name : {options.student, options.solved})
      requireNotCheckedOut(target, "refs/heads/" + name);
  }

  const Signature by = committerOf(Git(cut.source), "HEAD");
  const Tree tree = studentTree(cut);
  const std::string before = git.tried({"rev-parse", "--verify", "-q", studentRef}).value_or("");
  const std::string student = commitStudent(cut, git, tree, before, by, scratch);
  std::vector<Ref> refs = commitSolved(cut, git, tree, options, by, scratch);
  const std::string solved = refs.back().commit;
  refs.push_back({studentRef, student});
  if (fs::exists(target.folder())) {
    for (const auto& ref : refs) requireOurs(target, ref.name);
  }

  const SecretLines secrets = secretLines(cut);
  if (!secrets.problems().empty()) throw Failure{ourFault, secrets.problems().front()};
  const auto leaks = leaksInHistory(cut, secrets, git, student, scratch);
  if (tell(leaks) != Exit::pass) return Exit::checkFailed;
  std::cout << "No line of " << cut.secret().size() << " answers (" << secrets.size()
            << " lines) is left in the history of the student branch.\n";

  if (options.build) {
    const Trial trial = tryBranches(cut, secrets, git, student, solved, folder.path() / "clean");
    for (const auto& problem : trial.problems) std::cout << problem << "\n";
    if (tell(trial.leaks) != Exit::pass || !trial.problems.empty()) {
      if (trial.leaks.empty()) std::cout << "No branch was written.\n";
      return Exit::checkFailed;
    }
    std::cout
        << trial.exercises
        << " exercises: skeletons are not started, worked answers pass, wrong ones are named.\n"
        << (trial.pages ? "No answer is in the " + std::to_string(trial.pages) +
                              " files of the students' site.\n"
                        : "The students' site was not built: " + trial.withoutSite + "\n");
  }
  deliver(project, options, git, refs);
  int shown = 0;
  std::size_t all = 0;
  for (const auto& e : cut.exercises) {
    const auto standing = cut.standing(e);
    shown += standing == Standing::shown;
    all += standing == Standing::shown || standing == Standing::open;
  }
  std::cout << options.student << "  " << student.substr(0, 10) << "  " << titleOf(cut) << "; "
            << all << " exercises, " << shown << " with their answers"
            << (student == before ? "; nothing is new" : "") << "\n"
            << options.solved << "  " << solved.substr(0, 10) << "  git diff chNN-start chNN-solved"
            << " is the lesson of a chapter\n";
  return Exit::pass;
}

}  // namespace carom::runner

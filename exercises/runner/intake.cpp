#include "runner/intake.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <set>

#include "grading/process.hpp"

namespace carom::runner {

namespace {

// Why a submission is not taken as a whole, in a sentence.
struct Refused {
  std::string why;
};

enum class Kind { file, link, other };

// A thing in a submission. Contents are read only where the name may be one of the course's.
struct Entry {
  std::string path;
  Kind kind = Kind::file;
  std::string content;
  std::string refused;
};

std::string megabytes(std::size_t bytes) {
  return std::to_string(bytes >> 20) + " MB";
}

std::vector<std::string> parts(std::string_view path) {
  std::vector<std::string> all;
  while (!path.empty()) {
    const auto slash = path.find('/');
    const auto part = path.substr(0, slash);
    if (!part.empty() && part != ".") all.emplace_back(part);
    if (slash == std::string_view::npos) break;
    path.remove_prefix(slash + 1);
  }
  return all;
}

// Names from archives and git trees. Honest tools write none of these.
void checkName(std::string_view name) {
  const std::string shown = "'" + safeName(name.substr(0, 80)) + "'";
  if (name.empty()) throw Refused{"an entry has no name"};
  if (name.front() == '/' || (name.size() > 1 && name[1] == ':'))
    throw Refused{"the entry " + shown + " has an absolute path"};
  for (const unsigned char c : name) {
    if (c < 0x20 || c == 0x7f)
      throw Refused{"the name of the entry " + shown + " holds control characters"};
    if (c == '\\') throw Refused{"the name of the entry " + shown + " holds a backslash"};
  }
  for (const auto& part : parts(name)) {
    if (part == "..") throw Refused{"the entry " + shown + " leads out of its folder (..)"};
  }
}

std::string contentProblem(std::string_view content) {
  if (content.find('\0') != std::string_view::npos) return "holds a zero byte, so it is no text";
  return "";
}

// What a program answers on its output alone; nothing when it fails.
std::optional<std::string> outputOf(const std::vector<std::string>& words,
                                    const std::vector<std::string>& environment, long kilobytes) {
  grading::Command command;
  // Complaints go nowhere: they would be taken for part of the answer.
  command.words = {"/bin/sh", "-c", "exec \"$@\" 2>/dev/null", "sh"};
  command.words.insert(command.words.end(), words.begin(), words.end());
  command.environment = environment;
  command.limits = {.wallSeconds = 60,
                    .cpuSeconds = 30,
                    .memoryMegabytes = 2048,
                    .fileKilobytes = 256 << 10,
                    .outputKilobytes = kilobytes};
  auto done = grading::run(command);
  if (!done.ok()) return std::nullopt;
  return std::move(done.output);
}

// A folder of its own, gone with the object.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "carom-intake-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      throw Failure{ourFault, "cannot make a folder in " + fs::temp_directory_path().string()};
    path_ = pattern;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const {
    return path_;
  }

 private:
  fs::path path_;
};

bool endsWith(const std::string& name, std::initializer_list<const char*> ends) {
  std::string lower = name;
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return std::any_of(ends.begin(), ends.end(), [&](const char* e) { return lower.ends_with(e); });
}

constexpr auto kArchives = {".zip",    ".tar", ".tar.gz",  ".tgz",
                            ".tar.xz", ".txz", ".tar.bz2", ".tbz2"};
constexpr auto kOtherArchives = {".rar", ".7z", ".tar.zst", ".gz", ".xz", ".bz2", ".lzh", ".iso"};

std::string withoutArchiveEnd(const std::string& name) {
  for (const auto& ends : {kArchives, kOtherArchives, {".bundle", ".git"}}) {
    for (const char* end : ends) {
      if (endsWith(name, {end})) return name.substr(0, name.size() - std::string(end).size());
    }
  }
  return name;
}

// Moodle's download names a folder "Ann Example_12345_assignsubmission_file_".
std::string studentOf(const std::string& name) {
  const std::string plain = withoutArchiveEnd(name);
  return plain.substr(0, plain.find("_assignsubmission_"));
}

bool isRepository(const fs::path& folder) {
  std::error_code none;
  const auto is = [&](const fs::path& path) { return fs::exists(fs::symlink_status(path, none)); };
  return is(folder / ".git") ||
         (is(folder / "HEAD") && is(folder / "objects") && is(folder / "refs"));
}

class Taker {
 public:
  Taker(const std::vector<const Exercise*>& which, const IntakeLimits& limits)
      : which_(which), limits_(limits) {
    for (const auto* e : which) names_.insert(e->fileName());
  }

  Submission take(const fs::path& source, const std::string& student) const {
    Submission s;
    s.student = safeName(student);
    s.source = safeName(source.filename().string());
    try {
      std::error_code none;
      const auto status = fs::symlink_status(source, none);
      if (fs::is_symlink(status)) throw Refused{"it is a link"};
      if (fs::is_directory(status)) {
        takeFolder(source, s);
      } else if (!fs::is_regular_file(status)) {
        throw Refused{"it is neither a folder nor a file"};
      } else if (endsWith(source.filename().string(), {".bundle"})) {
        choose(bundleEntries(source, s), s);
      } else if (endsWith(source.filename().string(), kArchives)) {
        choose(archiveEntries(source), s);
      } else {
        throw Refused{
            "archives of this kind are not read: zip, tar, tar.gz, tar.xz and tar.bz2 are"};
      }
    } catch (const Refused& refused) {
      s.files.clear();
      s.refused.clear();
      s.refusedWhole = refused.why;
    } catch (const fs::filesystem_error&) {
      s.files.clear();
      s.refused.clear();
      s.refusedWhole = "it cannot be read";
    }
    return s;
  }

  /// Is a folder one submission, rather than a class?
  bool isSubmission(const fs::path& folder) const {
    if (isRepository(folder)) return true;
    std::error_code none;
    if (fs::is_directory(fs::symlink_status(folder / "exercises", none))) return true;
    for (const auto* e : which_) {
      if (fs::exists(fs::symlink_status(folder / e->fileName(), none)) ||
          fs::exists(fs::symlink_status(folder / e->chapter / e->fileName(), none)))
        return true;
    }
    return false;
  }

 private:
  bool wanted(const std::string& path) const {
    const auto slash = path.rfind('/');
    return names_.count(slash == std::string::npos ? path : path.substr(slash + 1)) > 0;
  }

  void count(std::size_t& entries) const {
    if (++entries > limits_.entries) {
      throw Refused{"it holds more than " + std::to_string(limits_.entries) +
                    " files: the folder exercises is enough"};
    }
  }

  // ---- folders

  void takeFolder(const fs::path& folder, Submission& s) const {
    if (isRepository(folder)) {
      choose(repositoryEntries(folder, s), s);
      return;
    }
    std::vector<Entry> entries;
    std::vector<fs::path> archives;
    std::size_t number = 0;
    walk(folder, "", 0, entries, archives, number);
    const bool some = std::any_of(entries.begin(), entries.end(),
                                  [&](const Entry& e) { return level(parts(e.path)).first >= 0; });
    // Platforms put a student's archive into a folder with the student's name.
    if (!some && archives.size() > 1) {
      throw Refused{"it holds " + std::to_string(archives.size()) +
                    " archives, and which of them counts only the student knows"};
    }
    if (!some && archives.size() == 1) {
      s.notes.push_back("taken from " + safeName(archives[0].filename().string()));
      if (endsWith(archives[0].filename().string(), {".bundle"}))
        choose(bundleEntries(archives[0], s), s);
      else
        choose(archiveEntries(archives[0]), s);
      return;
    }
    choose(std::move(entries), s);
  }

  // What lies deeper than top/top/exercises/chapter/file belongs to no exercise.
  static constexpr int kDeepest = 4;

  void walk(const fs::path& folder, const std::string& prefix, int depth,
            std::vector<Entry>& entries, std::vector<fs::path>& archives,
            std::size_t& number) const {
    std::vector<fs::path> children;
    for (const auto& child : fs::directory_iterator(folder)) {
      count(number);
      children.push_back(child.path());
    }
    std::sort(children.begin(), children.end());
    for (const auto& child : children) {
      const std::string name = child.filename().string();
      const auto status = fs::symlink_status(child);
      const std::string path = prefix + name;
      if (fs::is_directory(status)) {
        if (name != ".git" && name != "__MACOSX" && depth < kDeepest)
          walk(child, path + "/", depth + 1, entries, archives, number);
        continue;
      }
      if (fs::is_symlink(status)) {
        entries.push_back({path, Kind::link, {}, {}});
      } else if (!fs::is_regular_file(status)) {
        entries.push_back({path, Kind::other, {}, {}});
      } else if (wanted(name)) {
        entries.push_back(readEntry(child, path));
      } else if (depth == 0 && endsWith(name, kArchives)) {
        archives.push_back(child);
      } else if (depth == 0 && endsWith(name, {".bundle"})) {
        archives.push_back(child);
      }
    }
  }

  Entry readEntry(const fs::path& file, const std::string& path) const {
    Entry entry{path, Kind::file, {}, {}};
    const int fd = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat facts {};
    if (fd < 0 || fstat(fd, &facts) != 0 || !S_ISREG(facts.st_mode)) {
      if (fd >= 0) close(fd);
      entry.refused = "cannot be read";
      return entry;
    }
    char buffer[1 << 16];
    ssize_t got = 0;
    while (entry.content.size() <= limits_.fileBytes && (got = read(fd, buffer, sizeof buffer)) > 0)
      entry.content.append(buffer, static_cast<std::size_t>(got));
    close(fd);
    if (got < 0) entry.refused = "cannot be read";
    return entry;
  }

  // ---- archives

  std::vector<Entry> archiveEntries(const fs::path& file) const {
    std::error_code none;
    if (fs::file_size(file, none) > limits_.archiveBytes)
      throw Refused{"the archive is larger than " + megabytes(limits_.archiveBytes)};
    const std::unique_ptr<archive, int (*)(archive*)> a(archive_read_new(), archive_read_free);
    if (!a) throw Failure{ourFault, "no memory for an archive"};
    // No more formats than are asked for. A zip is read by its directory alone, so that one without
    // is damaged.
    archive_read_support_format_zip_seekable(a.get());
    archive_read_support_format_tar(a.get());
    archive_read_support_filter_gzip(a.get());
    archive_read_support_filter_xz(a.get());
    archive_read_support_filter_bzip2(a.get());
    if (archive_read_open_filename(a.get(), file.c_str(), 1 << 16) != ARCHIVE_OK)
      throw Refused{"it is damaged, or not the archive that its name says"};
    std::vector<Entry> entries;
    std::set<std::string> seen;
    std::size_t unpacked = 0;
    std::size_t number = 0;
    archive_entry* header = nullptr;
    for (;;) {
      const int next = archive_read_next_header(a.get(), &header);
      if (next == ARCHIVE_EOF) break;
      if (next < ARCHIVE_WARN) throw Refused{"the archive is damaged or cut off"};
      count(number);
      if (archive_entry_is_encrypted(header)) throw Refused{"the archive is encrypted"};
      const char* utf8 = archive_entry_pathname_utf8(header);
      const char* raw = utf8 ? utf8 : archive_entry_pathname(header);
      const std::string name = raw ? raw : "";
      checkName(name);
      std::string path;
      for (const auto& part : parts(name)) path += (path.empty() ? "" : "/") + part;
      const auto type = archive_entry_filetype(header);
      if (type == AE_IFDIR) continue;
      Entry entry{path, Kind::file, {}, {}};
      if (archive_entry_hardlink(header) || archive_entry_symlink(header) || type == AE_IFLNK)
        entry.kind = Kind::link;
      else if (type != AE_IFREG)
        entry.kind = Kind::other;
      if (!seen.insert(path).second)
        throw Refused{"the archive holds '" + safeName(path) + "' twice"};
      const bool keep = wanted(path);
      // Everything is read, also what nobody wants: a bomb is one wherever it lies.
      char buffer[1 << 16];
      for (;;) {
        const la_ssize_t got = archive_read_data(a.get(), buffer, sizeof buffer);
        if (got == 0) break;
        if (got < 0) {
          throw Refused{archive_read_has_encrypted_entries(a.get()) > 0
                            ? "the archive is encrypted"
                            : "the archive is damaged or cut off"};
        }
        unpacked += static_cast<std::size_t>(got);
        if (unpacked > limits_.unpackedBytes) {
          throw Refused{"the archive unpacks to more than " + megabytes(limits_.unpackedBytes) +
                        ": the folder exercises is enough"};
        }
        if (keep && entry.content.size() <= limits_.fileBytes)
          entry.content.append(buffer, static_cast<std::size_t>(got));
      }
      if (keep || entry.kind != Kind::file) entries.push_back(std::move(entry));
    }
    if (number == 0) throw Refused{"the archive is empty"};
    return entries;
  }

  // ---- git
  //
  // A repository brings settings along that make git run programs. So git never works in it: the
  // objects are read through an empty repository of our own, and the files that say what HEAD is
  // are read here.

  static std::vector<std::string> gitEnvironment(const fs::path& own, const fs::path& objects) {
    return {"GIT_DIR=" + own.string(),
            "GIT_OBJECT_DIRECTORY=" + objects.string(),
            "GIT_ALTERNATE_OBJECT_DIRECTORIES=",
            "GIT_INDEX_FILE=" + (own / "index").string(),
            "GIT_WORK_TREE=" + own.string(),
            "GIT_CONFIG_NOSYSTEM=1",
            "GIT_CONFIG_GLOBAL=/dev/null",
            "GIT_CONFIG_COUNT=0",
            "GIT_ATTR_NOSYSTEM=1",
            "GIT_NO_REPLACE_OBJECTS=1",
            "GIT_NO_LAZY_FETCH=1",
            "GIT_TERMINAL_PROMPT=0",
            "LC_ALL=C"};
  }

  static void makeOwn(const fs::path& own) {
    const auto made =
        outputOf({"git", "init", "-q", "--bare", "--template=", own.string()},
                 {"GIT_DIR=" + own.string(), "GIT_CONFIG_NOSYSTEM=1", "GIT_CONFIG_GLOBAL=/dev/null",
                  "GIT_OBJECT_DIRECTORY=" + (own / "objects").string()},
                 64);
    if (!made) throw Failure{ourFault, "git cannot make a repository in " + own.string()};
  }

  static std::string hash(std::string_view text) {
    const std::string line = trimmed(text);
    const bool good = line.size() == 40 && line.find_first_not_of("0123456789abcdef") == line.npos;
    return good ? line : "";
  }

  // No reference has a name that leads elsewhere.
  static bool goodReference(const std::string& name) {
    return name.starts_with("refs/") && name.find("..") == name.npos &&
           name.find_first_not_of(
               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
               "0123456789/._-") == name.npos;
  }

  static std::string smallFile(const fs::path& file) {
    std::error_code none;
    if (!fs::is_regular_file(fs::symlink_status(file, none)) ||
        fs::file_size(file, none) > 4u << 20)
      return "";
    return readIfThere(file).value_or("");
  }

  static std::string headOf(const fs::path& git) {
    const std::string head = trimmed(smallFile(git / "HEAD"));
    if (!hash(head).empty()) return hash(head);
    if (!head.starts_with("ref: ")) throw Refused{"the repository's HEAD cannot be read"};
    const std::string name = trimmed(head.substr(5));
    if (!goodReference(name)) throw Refused{"the repository's HEAD names no branch"};
    if (const auto loose = hash(smallFile(git / name)); !loose.empty()) return loose;
    for (const auto& line : splitLines(smallFile(git / "packed-refs"))) {
      if (line.size() > 41 && line.substr(41) == name) return hash(line.substr(0, 40));
    }
    throw Refused{"the repository holds no commit"};
  }

  std::vector<Entry> repositoryEntries(const fs::path& folder, Submission& s) const {
    std::error_code none;
    fs::path git = folder;
    const auto below = fs::symlink_status(folder / ".git", none);
    if (fs::exists(below)) {
      if (!fs::is_directory(below)) throw Refused{"its .git is not a folder but leads elsewhere"};
      git /= ".git";
    }
    // Alternates and links would let it read objects of other repositories of this machine.
    std::size_t number = 0;
    for (auto i = fs::recursive_directory_iterator(git); i != fs::recursive_directory_iterator();
         ++i) {
      if (++number > 10 * limits_.entries) throw Refused{"the repository holds too many files"};
      if (fs::is_symlink(i->symlink_status())) throw Refused{"the repository holds links"};
      const auto type = i->symlink_status().type();
      if (type != fs::file_type::directory && type != fs::file_type::regular)
        throw Refused{"the repository holds things that are no files"};
    }
    for (const char* other : {"objects/info/alternates", "objects/info/http-alternates"}) {
      if (fs::exists(git / other)) throw Refused{"the repository borrows objects from another one"};
    }
    const Scratch scratch;
    const fs::path own = scratch.path() / "git";
    makeOwn(own);
    return treeEntries(headOf(git), gitEnvironment(own, fs::absolute(git / "objects")), s);
  }

  std::vector<Entry> bundleEntries(const fs::path& file, Submission& s) const {
    std::error_code none;
    if (fs::file_size(file, none) > limits_.archiveBytes)
      throw Refused{"the bundle is larger than " + megabytes(limits_.archiveBytes)};
    const Scratch scratch;
    const fs::path own = scratch.path() / "git";
    makeOwn(own);
    const auto environment = gitEnvironment(own, own / "objects");
    const auto heads = outputOf(
        {"git", "-c", "fetch.fsckObjects=true", "bundle", "unbundle", fs::absolute(file).string()},
        environment, 1024);
    if (!heads) throw Refused{"the bundle is damaged or not complete"};
    std::map<std::string, std::string> byName;
    for (const auto& line : splitLines(*heads)) {
      if (line.size() > 41 && !hash(line.substr(0, 40)).empty())
        byName[line.substr(41)] = line.substr(0, 40);
    }
    for (const char* name : {"HEAD", "refs/heads/main", "refs/heads/master"}) {
      if (byName.count(name)) return treeEntries(byName.at(name), environment, s);
    }
    if (byName.size() != 1)
      throw Refused{"the bundle does not say which of its branches is the submission"};
    return treeEntries(byName.begin()->second, environment, s);
  }

  std::vector<Entry> treeEntries(const std::string& commit,
                                 const std::vector<std::string>& environment, Submission& s) const {
    const auto head = outputOf({"git", "cat-file", "commit", commit}, environment, 256);
    if (!head) throw Refused{"the repository lacks its last commit, or it is damaged"};
    for (const auto& line : splitLines(*head)) {
      if (line.empty()) break;
      const auto end = line.rfind(' ');
      const auto begin = line.rfind(' ', end == 0 ? 0 : end - 1);
      if (!line.starts_with("committer ") || begin == line.npos) continue;
      const std::time_t when = std::strtoll(line.c_str() + begin, nullptr, 10);
      std::tm day{};
      char text[32] = "";
      if (when > 0 && when < 253402300800 && gmtime_r(&when, &day))
        std::strftime(text, sizeof text, "%Y-%m-%d", &day);
      s.date = text;
    }
    const auto list =
        outputOf({"git", "ls-tree", "-r", "-l", "-z", "--full-tree", commit}, environment, 8192);
    if (!list) throw Refused{"the tree of the last commit is damaged or too large"};
    std::vector<Entry> entries;
    std::size_t number = 0;
    for (std::string_view rest = *list; !rest.empty();) {
      const auto end = rest.find('\0');
      const auto tab = rest.find('\t');
      if (end == rest.npos || tab == rest.npos || tab > end)
        throw Refused{"the tree of the last commit is damaged"};
      const auto facts = words(rest.substr(0, tab));
      const std::string path(rest.substr(tab + 1, end - tab - 1));
      rest.remove_prefix(end + 1);
      count(number);
      checkName(path);
      if (facts.size() != 4) throw Refused{"the tree of the last commit is damaged"};
      Entry entry{path, Kind::file, {}, {}};
      if (facts[0] == "120000") entry.kind = Kind::link;
      if (facts[0] == "160000") entry.kind = Kind::other;
      if (entry.kind == Kind::file && wanted(path)) {
        const std::size_t size = std::strtoull(facts[3].c_str(), nullptr, 10);
        if (size > limits_.fileBytes) {
          entry.content.assign(limits_.fileBytes + 1, ' ');
        } else {
          const auto content =
              outputOf({"git", "cat-file", "blob", hash(facts[2])}, environment, 1024);
          if (!content || content->size() != size)
            entry.refused = "is missing in the repository";
          else
            entry.content = *content;
        }
      }
      if (entry.kind != Kind::file || wanted(path)) entries.push_back(std::move(entry));
    }
    return entries;
  }

  // ---- which file is which exercise's

  // How a path names an exercise: 0 as the course has it, exercises/chapter/file below at most two
  // folders; 1 chapter/file; 2 the file alone, each below at most one. -1: not at all.
  std::pair<int, const Exercise*> level(const std::vector<std::string>& path) const {
    const std::size_t n = path.size();
    if (n == 0 || n > 5) return {-1, nullptr};
    for (const auto* e : which_) {
      if (path[n - 1] != e->fileName()) continue;
      const bool chapter = n > 1 && path[n - 2] == e->chapter;
      if (chapter && n > 2 && path[n - 3] == "exercises") return {0, e};
      // The course's own folders hold other files of the same names.
      if (chapter && (n == 2 || (n == 3 && path[0] != "chapters"))) return {1, e};
      if (n <= 2 && !chapter) return {2, e};
    }
    return {-1, nullptr};
  }

  void choose(std::vector<Entry> entries, Submission& s) const {
    // A link in place of the folder exercises, or of a chapter's.
    for (const auto& entry : entries) {
      const auto path = parts(entry.path);
      if (entry.kind != Kind::link || path.empty() || path.size() > 4) continue;
      const bool chapter = std::any_of(which_.begin(), which_.end(), [&](const Exercise* e) {
        return e->chapter == path.back();
      });
      const bool below = path.size() > 1 && path[path.size() - 2] == "exercises";
      if (path.back() == "exercises" || (chapter && below))
        s.notes.push_back("the folder '" + safeName(entry.path) +
                          "' is a link and is not followed");
    }
    int best = 3;
    for (const auto& entry : entries) {
      const int l = level(parts(entry.path)).first;
      if (l >= 0) best = std::min(best, l);
    }
    std::map<std::string, std::string> takenFrom;
    for (auto& entry : entries) {
      const auto [l, e] = level(parts(entry.path));
      if (l < 0) continue;
      if (l > best) {
        s.notes.push_back("'" + safeName(entry.path) +
                          "' is not where the course has it, and others "
                          "are: not looked at");
        continue;
      }
      const auto before = takenFrom.find(e->id);
      std::string why;
      if (before != takenFrom.end())
        why = "was handed in twice, as '" + before->second + "' and '" + safeName(entry.path) + "'";
      else if (entry.kind == Kind::link)
        why = "is a link, not a file";
      else if (entry.kind == Kind::other)
        why = "is not a file";
      else if (!entry.refused.empty())
        why = entry.refused;
      else if (entry.content.size() > limits_.fileBytes)
        why = "is larger than " + std::to_string(limits_.fileBytes >> 10) + " kB";
      else
        why = contentProblem(entry.content);
      takenFrom[e->id] = safeName(entry.path);
      if (why.empty()) {
        s.files[e->id] = std::move(entry.content);
      } else {
        s.files.erase(e->id);
        s.refused[e->id] = e->fileName() + " " + why;
      }
    }
  }

  const std::vector<const Exercise*>& which_;
  IntakeLimits limits_;
  std::set<std::string> names_;
};

std::string lowered(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace

std::string safeName(std::string_view name) {
  static const std::string_view kSigns = " _-.,@'()";
  constexpr std::size_t kLongest = 100;
  std::string safe;
  while (!name.empty() && safe.size() < kLongest) {
    std::size_t length = 1;
    const char32_t c = nextCharacter(name, length);
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    const bool sign = c < 0x80 && c != 0 && kSigns.find(static_cast<char>(c)) != kSigns.npos;
    if (letter || sign || (c >= 0x80 && !unseen(c)))
      safe += name.substr(0, length);
    else
      safe += '_';
    name.remove_prefix(length);
  }
  while (!safe.empty() && (safe.back() == ' ' || safe.back() == '.')) safe.pop_back();
  if (safe.empty()) return "_";
  // In front: a hidden file, an option, a formula.
  if (std::string_view(".-@ '").find(safe.front()) != std::string_view::npos) safe = "_" + safe;
  return safe;
}

Intake takeIn(const std::vector<const Exercise*>& which, const std::vector<fs::path>& from,
              const std::string& student, const IntakeLimits& limits) {
  const Taker taker(which, limits);
  Intake intake;
  std::vector<std::pair<fs::path, std::string>> sources;
  for (const auto& given : from) {
    std::error_code none;
    if (!fs::exists(given, none)) throw Failure{usage, "there is no " + given.string()};
    // "folder/" and "." have no name of their own.
    fs::path source = fs::absolute(given).lexically_normal();
    if (source.filename().empty()) source = source.parent_path();
    const std::string name = source.filename().string();
    if (!fs::is_directory(source, none) || !student.empty() || taker.isSubmission(source)) {
      sources.emplace_back(source, student.empty() ? studentOf(name) : student);
      continue;
    }
    for (const auto& child : fs::directory_iterator(source)) {
      const std::string childName = child.path().filename().string();
      const bool folder = fs::is_directory(child.symlink_status());
      const bool link = fs::is_symlink(child.symlink_status());
      if (childName.starts_with(".") || childName == "__MACOSX") continue;
      if (folder || link || endsWith(childName, kArchives) || endsWith(childName, kOtherArchives) ||
          endsWith(childName, {".bundle"})) {
        sources.emplace_back(child.path(), studentOf(childName));
      } else {
        intake.notes.push_back("'" + safeName(childName) +
                               "' lies beside the submissions and is nobody's");
      }
    }
  }
  if (!student.empty() && sources.size() != 1)
    throw Failure{usage, "--student names one submission, but " + std::to_string(sources.size()) +
                             " are given"};
  std::sort(intake.notes.begin(), intake.notes.end());
  std::sort(sources.begin(), sources.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.second, a.first) < std::make_pair(b.second, b.first);
  });
  // One folder of reports for each: also on disks that do not tell capitals apart.
  std::map<std::string, Submission> byName;
  for (const auto& [source, name] : sources) {
    auto s = taker.take(source, name);
    const auto key = lowered(s.student);
    const auto before = byName.find(key);
    if (before == byName.end()) {
      byName.emplace(key, std::move(s));
      continue;
    }
    auto& first = before->second;
    first.source += ", " + s.source;
    first.files.clear();
    first.refused.clear();
    first.refusedWhole = "there is more than one submission with this name (" + first.source +
                         "): which of them counts?";
  }
  for (auto& [key, s] : byName) intake.submissions.push_back(std::move(s));
  return intake;
}

}  // namespace carom::runner

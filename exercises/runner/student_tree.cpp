#include "runner/student_tree.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "runner/skeleton.hpp"

namespace carom::runner {

namespace {

bool startsWithAny(const std::string& path, std::initializer_list<const char*> prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const char* prefix) { return path.starts_with(prefix); });
}

// The second folder of chapters/01_rotation/page.md; empty for a file that lies in the first.
std::string secondFolder(const std::string& path) {
  const auto first = path.find('/');
  const auto second = first == std::string::npos ? first : path.find('/', first + 1);
  return second == std::string::npos ? "" : path.substr(first + 1, second - first - 1);
}

std::string label(const Exercise& e) {
  std::string text = "exercise_" + e.id;
  std::replace(text.begin(), text.end(), '.', '_');
  return text;
}

// Pieces of a source file: what is between blank lines outside of braces.
std::vector<std::string> pieces(std::string_view source) {
  std::vector<std::string> all(1);
  for (const auto& line : splitLines(source)) {
    // clang-format leaves no blank line unindented within a function except where it has ended: a piece goes on
    // while the last line of it was indented or opened something.
    all.back() += line + "\n";
    if (!line.empty()) continue;
    all.emplace_back();
  }
  // A function with blank lines in it was torn apart; its pieces begin with an indented line or a closing brace.
  std::vector<std::string> whole;
  for (auto& piece : all) {
    const bool inside =
        !whole.empty() && (piece.starts_with(" ") || piece.starts_with("}\n") ||
                           piece.starts_with("};") || piece.starts_with("})") || piece == "\n");
    if (inside)
      whole.back() += piece;
    else
      whole.push_back(std::move(piece));
  }
  return whole;
}

// The name that a function, constant or type introduces, where it stands at the beginning of a line.
std::string declaredName(const std::string& piece) {
  for (const auto& line : splitLines(piece)) {
    if (line.starts_with("//") || line.starts_with("#") || line.starts_with("template") ||
        line.empty())
      continue;
    std::smatch match;
    static const std::regex type(R"(^(?:enum class|enum|struct|class|using) (\w+))");
    if (std::regex_search(line, match, type)) return match[1];
    const std::string head = line.substr(0, line.find_first_of("({=;["));
    static const std::regex last(R"((\w+)\s*$)");
    return std::regex_search(head, match, last) ? match[1].str() : "";
  }
  return "";
}

bool hasWord(const std::string& text, const std::string& word) {
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const auto isWord = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    const auto end = at + word.size();
    if ((at == 0 || !isWord(text[at - 1])) && (end == text.size() || !isWord(text[end])))
      return true;
  }
  return false;
}

// The sections of an ini file; the first is its head.
std::vector<std::string> sectionsOf(std::string_view ini) {
  std::vector<std::string> all(1);
  for (const auto& line : splitLines(ini)) {
    if (line.starts_with("[")) all.emplace_back();
    all.back() += line + "\n";
  }
  return all;
}

std::string nameOfSection(const std::string& section) {
  return section.starts_with("[") ? section.substr(1, section.find(']') - 1) : "";
}

std::string valueOf(const std::string& section, const std::string& key) {
  for (const auto& line : splitLines(section)) {
    if (line.starts_with(key + " = ")) return trimmed(line.substr(key.size() + 3));
  }
  return "";
}

// What pages may refer to.
std::set<std::string> labelsIn(std::string_view page) {
  std::set<std::string> all;
  static const std::regex given(R"(\{#([\w-]+)\}|[\\@](?:anchor|page) ([\w-]+))");
  const std::string text(page);
  for (std::sregex_iterator it(text.begin(), text.end(), given), end; it != end; ++it)
    all.insert((*it)[1].matched ? (*it)[1] : (*it)[2]);
  return all;
}

// A reference to a page that is not there becomes the words that it would have shown.
std::string withoutReferences(const std::string& page, const std::set<std::string>& gone) {
  static const std::regex reference(
      R"re([\\@](ref|subpage) ([\w-]+)( "([^"]*)")?|\[([^\]]*)\]\((?:#|@ref |\\ref )([\w-]+)\))re");
  std::string out;
  for (const auto& line : splitLines(page)) {
    std::string left;
    bool dropped = false;
    auto at = line.cbegin();
    for (std::sregex_iterator it(line.begin(), line.end(), reference), end; it != end; ++it) {
      const auto& match = *it;
      const std::string name = match[2].matched ? match[2] : match[6];
      if (!gone.count(name)) continue;
      left.append(at, match[0].first);
      at = match[0].second;
      if (match[1] == "subpage") dropped = true;
      left += match[4].matched   ? match[4].str()
              : match[5].matched ? match[5].str()
                                 : "a later chapter";
    }
    left.append(at, line.cend());
    // An entry of a menu without its page is nothing.
    if (!dropped) out += left + "\n";
  }
  return out;
}

// A page without what it says to teachers.
std::string withoutTeaching(const std::string& page) {
  std::string out;
  bool teaching = false;
  for (const auto& line : splitLines(page)) {
    if (line.starts_with("## "))
      teaching = line.starts_with("## Teaching") || line.starts_with("## For teachers");
    if (!teaching) out += line + "\n";
  }
  return out;
}

class Maker {
 public:
  explicit Maker(const Cut& cut) : cut_(cut) {}

  Tree make() {
    for (const auto& e : cut_.exercises) {
      if (cut_.isSecret(e) && !Cut::libraryFile(e).empty()) secretFiles_[Cut::libraryFile(e)] = &e;
    }
    for (const auto& [path, file] : cut_.files) {
      if (keeps(path)) tree_[path] = {.mode = file.mode, .blob = file.blob, .content = {}};
    }
    for (const auto& e : cut_.exercises) exercise(e);
    pages();
    readme();
    return std::move(tree_);
  }

 private:
  std::string read(const std::string& path) const {
    return readFile(cut_.source / path);
  }

  void put(const std::string& path, std::string content) {
    auto& file = tree_[path];
    if (const auto old = cut_.files.find(path);
        old != cut_.files.end() && file.mode == old->second.mode && read(path) == content) {
      file.blob = old->second.blob;
      return;
    }
    file.content = std::move(content);
  }

  // The same file in another place.
  void move(const std::string& from, const std::string& to) {
    const auto file = cut_.files.find(from);
    if (file == cut_.files.end()) throw Failure{usage, from + " is not in the commit"};
    tree_[to] = {.mode = file->second.mode, .blob = file->second.blob, .content = {}};
  }

  bool isCourseFile(const std::string& path) const {
    for (const auto& own : {cut_.course.file, cut_.course.secretFile}) {
      if (!own.empty() && fs::path(path).filename() == own.filename()) return true;
    }
    return false;
  }

  // Files of a chapter; the headers stay as long as a later chapter may include them.
  bool keepsOfChapter(const std::string& folder, const std::string& path) const {
    return cut_.hasChapter(folder) || (path.ends_with(".hpp") && folder <= cut_.upto);
  }

  bool keeps(const std::string& path) const {
    if (secretFiles_.count(path) || isCourseFile(path)) return false;
    if (startsWithAny(path, {"solutions/", ".ci/", ".github/", ".gitlab", "docs/teaching/"}) ||
        path == "docs/teachers.md")
      return false;
    const std::string folder = secondFolder(path);
    if (path.starts_with("chapters/")) return folder.empty() || keepsOfChapter(folder, path);
    // Skeletons are put there one by one.
    if (path.starts_with("exercises/")) return folder.empty() || folder == "runner";
    if (path.starts_with("tests/graders/")) {
      const std::string inside = path.substr(std::string("tests/graders/").size());
      const auto slash = inside.find('/');
      if (slash == std::string::npos) return true;
      // Of the files of exercises, those that are there are put there one by one.
      for (const char* end : {"_test.cpp", "_seam.cpp", ".fingerprints.json", ".versions.json"}) {
        if (inside.ends_with(end)) return false;
      }
      return keepsOfChapter(inside.substr(0, slash), path);
    }
    if (path.starts_with("tests/"))
      return startsWithAny(path, {"tests/grading/", "tests/support/"}) ||
             path == "tests/CMakeLists.txt";
    return true;
  }

  void exercise(const Exercise& e) {
    const auto standing = cut_.standing(e);
    const std::string authored = "solutions/" + e.chapter + "/" + e.name + "/";
    const std::string given = "exercises/" + e.chapter + "/given/" + e.name + "/";
    if (standing == Standing::leftOut) return;
    const std::string skeleton = cutSkeleton(read(authored + e.fileName()), e.fileName());
    if (standing == Standing::later) {
      // The library needs something in its place, in a chapter that is not there nothing does.
      if (e.home.starts_with("lib/")) put(given + "skeleton" + e.extension, skeleton);
      return;
    }
    put(e.studentFile().string(), skeleton);
    move(authored + "statement.md", given + "statement.md");
    const auto policy = cut_.course.policy(e);
    const std::string ini = read(authored + "exercise.ini");
    const std::string left = withoutChecks(ini, policy.hidden);
    if (policy.hidden.empty())
      move(authored + "exercise.ini", given + "exercise.ini");
    else
      put(given + "exercise.ini", left);
    if (standing == Standing::shown) {
      move(authored + e.fileName(), given + e.fileName());
      move(authored + "why.md", given + "why.md");
    } else {
      put(given + "skeleton" + e.extension, skeleton);
    }
    if (cut_.showsVersions(e) && cut_.files.count(Cut::versionsFile(e)))
      move(Cut::versionsFile(e), Cut::versionsFile(e));
    const std::string grader = (e.graderFolder() / e.name).string();
    for (const char* end : {"_test.cpp", "_seam.cpp", ".fingerprints.json"}) {
      const std::string path = grader + end;
      if (!cut_.files.count(path)) continue;
      move(path, path);
      if (policy.hidden.empty()) continue;
      if (path.ends_with("_test.cpp")) put(path, withoutTestCases(read(path), policy.hidden, path));
      if (path.ends_with(".json")) put(path, withoutFingerprints(read(path), left));
    }
  }

  // The answer that a line of a page quotes, if it is one that does not show.
  const Exercise* quoted(const std::string& line) const {
    static const std::regex quote(
        R"(^\s*[\\@](?:answer|snippet|snippetlineno|include|dontinclude|program) (\S+).*)");
    std::smatch match;
    if (!std::regex_match(line, match, quote)) return nullptr;
    const std::string file = "/" + match[1].str();
    for (const auto& [path, e] : secretFiles_) {
      if (("/" + path).ends_with(file)) return e;
    }
    return nullptr;
  }

  std::string withoutAnswers(const std::string& page) const {
    std::string out;
    for (const auto& line : splitLines(page)) {
      const Exercise* e = quoted(line);
      if (!e) {
        out += line + "\n";
      } else if (cut_.standing(*e) == Standing::open) {
        out +=
            "The library's version of this function is kept back: you write it in exercise "
            "\\ref " +
            label(*e) + " \"" + e->id + "\".\n";
      } else {
        out += "The library's version of this function is kept back: exercise " + e->id +
               " asks for it later.\n";
      }
    }
    return out;
  }

  void pages() {
    std::set<std::string> gone;
    for (const auto& [path, file] : cut_.files) {
      if (!path.ends_with(".md") || tree_.count(path) || path.starts_with("solutions/")) continue;
      gone.merge(labelsIn(read(path)));
    }
    for (const auto& e : cut_.exercises) {
      const auto standing = cut_.standing(e);
      if (standing == Standing::leftOut || standing == Standing::later) gone.insert(label(e));
    }
    for (auto& [path, file] : tree_) {
      const bool text = path.ends_with(".md") || path.ends_with(".dox") || path.ends_with(".tsv") ||
                        path.ends_with(".hpp");
      if (!text || !cut_.files.count(path) || path == "README.md") continue;
      const std::string before = read(path);
      const bool front = path == "docs/index.md";
      const std::string after =
          withoutReferences(withoutAnswers(front ? withoutTeaching(before) : before), gone);
      if (after != before) put(path, after);
    }
    // A statement may refer to a page too.
    for (auto& [path, file] : tree_) {
      if (!path.ends_with("/statement.md") || file.content) continue;
      const std::string before =
          read("solutions/" + secondFolder(path) + "/" +
               fs::path(path).parent_path().filename().string() + "/statement.md");
      const std::string after = withoutReferences(before, gone);
      if (after != before) file.content = after;
    }
  }

  // What the front page says to teachers.
  void readme() {
    if (!tree_.count("README.md")) return;
    std::string out;
    for (const auto& line : splitLines(withoutTeaching(read("README.md")))) {
      if (line.find("`solutions/`") == std::string::npos) out += line + "\n";
    }
    put("README.md", out);
  }

  const Cut& cut_;
  Tree tree_;
  std::map<std::string, const Exercise*> secretFiles_;
};

}  // namespace

Standing Cut::standing(const Exercise& exercise) const {
  if (!course.policy(exercise).taken) return Standing::leftOut;
  if (exercise.chapter > upto) return Standing::later;
  return course.solutionShows(exercise, today) ? Standing::shown : Standing::open;
}

bool Cut::hasChapter(const std::string& folder) const {
  return folder <= upto && course.chapters.count(folder);
}

std::vector<const Exercise*> Cut::secret() const {
  std::vector<const Exercise*> all;
  for (const auto& e : exercises) {
    if (isSecret(e)) all.push_back(&e);
  }
  return all;
}

std::string Cut::libraryFile(const Exercise& exercise) {
  const bool replaces =
      exercise.kind == "implement" || exercise.kind == "fix" || exercise.kind == "measure";
  return exercise.home.empty() || !replaces ? "" : exercise.home + "/" + exercise.fileName();
}

std::string Cut::versionsFile(const Exercise& exercise) {
  return (exercise.graderFolder() / (exercise.name + ".versions.json")).string();
}

bool Cut::showsVersions(const Exercise& exercise) const {
  return exercise.isTest() && std::none_of(exercises.begin(), exercises.end(), [&](const auto& e) {
           return e.id == exercise.tests && isSecret(e);
         });
}

std::vector<std::string> Cut::chapters() const {
  std::vector<std::string> all;
  for (const auto& folder : course.chapters) {
    if (folder <= upto) all.push_back(folder);
  }
  return all;
}

Tree studentTree(const Cut& cut) {
  return Maker(cut).make();
}

Tree solvedTree(const Cut& cut, const Tree& student, const std::vector<std::string>& chapters) {
  Tree tree = student;
  for (const auto& e : cut.exercises) {
    const auto file = tree.find(e.studentFile().string());
    if (file == tree.end() ||
        std::find(chapters.begin(), chapters.end(), e.chapter) == chapters.end())
      continue;
    const std::string source =
        readFile(cut.source / "solutions" / e.chapter / e.name / e.fileName());
    file->second.content = cutAnswer(source, e.fileName());
  }
  return tree;
}

std::string withoutTestCases(std::string_view source, const std::vector<std::string>& names,
                             const std::string& file) {
  std::vector<std::string> kept;
  std::vector<std::string> found;
  for (auto& piece : pieces(source)) {
    static const std::regex testCase(R"re((?:^|\n)TEST_CASE\(\s*"([^"]+)")re");
    std::smatch match;
    if (std::regex_search(piece, match, testCase) &&
        std::find(names.begin(), names.end(), match[1].str()) != names.end()) {
      found.push_back(match[1]);
      // Two test cases without a blank line between them would go together.
      if (std::distance(std::sregex_iterator(piece.begin(), piece.end(), testCase),
                        std::sregex_iterator()) > 1) {
        throw Failure{ourFault,
                      file + ": there is no blank line behind test case '" + found.back() + "'"};
      }
      continue;
    }
    kept.push_back(std::move(piece));
  }
  for (const auto& name : names) {
    if (std::find(found.begin(), found.end(), name) == found.end())
      throw Failure{ourFault, file + " has no test case '" + name + "' to leave out"};
  }
  // What only they used, again and again until nothing is left that nobody uses.
  for (bool changed = true; changed;) {
    changed = false;
    bool unnamed = false;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i].find("namespace {\n") != std::string::npos) {
        unnamed = true;
        continue;
      }
      if (kept[i].find("}  // namespace\n") != std::string::npos) unnamed = false;
      if (!unnamed) continue;
      const std::string name = declaredName(kept[i]);
      if (name.empty()) continue;
      bool used = false;
      for (std::size_t j = 0; j < kept.size() && !used; ++j)
        used = j != i && hasWord(kept[j], name);
      if (used) continue;
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
      changed = true;
      break;
    }
  }
  std::string out;
  for (const auto& piece : kept) out += piece;
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

std::string withoutChecks(std::string_view ini, const std::vector<std::string>& hidden) {
  if (hidden.empty()) return std::string(ini);
  const auto isHidden = [&](const std::string& check) {
    return std::find(hidden.begin(), hidden.end(), check) != hidden.end();
  };
  const auto all = sectionsOf(ini);
  std::set<std::string> wrongGone;
  double points = 0;
  for (const auto& section : all) {
    const std::string name = nameOfSection(section);
    if (name.starts_with("wrong.") && isHidden(valueOf(section, "check")))
      wrongGone.insert(name.substr(6));
    if (name.starts_with("check.") && !isHidden(name.substr(6)))
      points += std::strtod(valueOf(section, "points").c_str(), nullptr);
  }
  char sum[32];
  std::snprintf(sum, sizeof sum, "%g", points);
  std::string out;
  for (const auto& section : all) {
    const std::string name = nameOfSection(section);
    if (name.starts_with("check.") && isHidden(name.substr(6))) continue;
    if (name.starts_with("wrong.") && wrongGone.count(name.substr(6))) continue;
    for (const auto& line : splitLines(section)) {
      if (name.empty() && line.starts_with("points = ")) {
        out += std::string("points = ") + sum + "\n";
      } else if (!(name.starts_with("check.") && line.starts_with("wrong = ") &&
                   wrongGone.count(trimmed(line.substr(8))))) {
        out += line + "\n";
      }
    }
  }
  return out;
}

std::string withoutFingerprints(std::string_view json, std::string_view ini) {
  const auto all = nlohmann::ordered_json::parse(json);
  nlohmann::ordered_json left = nlohmann::ordered_json::object();
  for (const auto& section : sectionsOf(ini)) {
    const std::string name = nameOfSection(section);
    if (name.starts_with("wrong.") && all.contains(name.substr(6)))
      left[name.substr(6)] = all[name.substr(6)];
  }
  return left.dump(1) + "\n";
}

}  // namespace carom::runner

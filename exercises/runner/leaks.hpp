#pragma once
// Is a line of an answer left where students can read it?
//
// The secret lines of an exercise are those between the markers of its worked answer, those of its other right
// answers, and those of the library's own version. A line counts if it has at least twelve characters besides blanks
// and comments, does not stand in the skeleton, and says something: the head of a loop, a declaration without a
// computation, a guard that compares a name with a number, a label of a switch and the return of a name say nothing of
// an answer. Blanks and ends of
// lines are taken out on both sides before they are compared, so that code which was laid out anew, or quoted within
// another line, is found too. A line that stands in at least three files of library and programs, answers apart, is
// common C++. Every other line that is allowed is listed in solutions/ordinary_lines.tsv with its file and a reason.
//
// The last hint of an exercise may hold a line of its answer, and is not searched for that.
//
// Not found: an answer in which names were changed, or one that says the same in other words.

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "runner/exercise.hpp"

namespace carom::runner {

/// A line of an answer, and where it was met.
struct Leak {
  std::string exercise;
  std::string where;
  int line = 0;      ///< of the file; 0: it has none
  std::string text;  ///< without blanks
};

/// A text of the tree that answers may have in common with it.
struct SourceText {
  std::string path;
  std::string content;
};

/// Takes out blanks and, where `code`, comments of C++.
std::string withoutBlanks(std::string_view text, bool code);

/// What a reader of a page of the site sees: its text without tags, its characters unescaped.
std::string textOfHtml(std::string_view html);

class SecretLines {
 public:
  /// \param source folder with the files of the commit that is cut
  /// \param secret exercises whose answers are not to be seen
  /// \param texts library and programs, in which common lines are looked for; answers apart
  SecretLines(const fs::path& source, const std::vector<const Exercise*>& secret,
              const std::vector<SourceText>& texts);

  /// The secret lines in a file of the branch.
  std::vector<Leak> leaksIn(const std::string& path, std::string_view content) const;
  /// The secret lines in a file of the site, which holds what is allowed anywhere.
  std::vector<Leak> leaksInSite(const std::string& path, std::string_view content) const;

  std::size_t size() const {
    return lines_.size();
  }
  /// The list of allowed lines, as far as it is wrong: a line without a reason or out of shape.
  const std::vector<std::string>& problems() const {
    return problems_;
  }

 private:
  struct Secret {
    std::string exercise;
    std::string text;
  };
  void add(const Exercise& exercise, std::string_view line, const std::string& skeleton);
  void readAllowed(const fs::path& file);
  template <class Found>
  void search(std::string_view text, Found found) const;

  std::vector<Secret> lines_;
  std::set<std::string> known_;
  std::unordered_map<std::string, std::vector<std::size_t>> byHead_;  // first twelve characters
  std::vector<bool> heads_;                                // of which two they begin with
  std::set<std::pair<std::string, std::string>> allowed_;  // file, line
  std::set<std::string> allowedSomewhere_;
  std::vector<std::string> problems_;
};

}  // namespace carom::runner

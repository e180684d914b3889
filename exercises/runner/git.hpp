#pragma once
// Git, as far as branches for a course need it: whole trees and commits, made without a working
// tree, so that nobody's files, index or current branch are touched.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runner/text.hpp"

namespace carom::runner {

/// A repository that commands are given to.
class Git {
 public:
  explicit Git(fs::path folder) : folder_(std::move(folder)) {}
  const fs::path& folder() const {
    return folder_;
  }
  /// What the command prints, without the last line's end. \throws Failure (ourFault) with what git says
  std::string operator()(const std::vector<std::string>& words,
                         const std::vector<std::string>& environment = {}) const;
  /// The same with a file as its input.
  std::string from(const fs::path& input, const std::vector<std::string>& words,
                   const std::vector<std::string>& environment = {}) const;
  /// Nothing where the command fails.
  std::optional<std::string> tried(const std::vector<std::string>& words) const;

 private:
  std::string run(const std::vector<std::string>& words,
                  const std::vector<std::string>& environment, bool* failed) const;
  fs::path folder_;
};

/// A file of a tree: a blob that the repository has, or a new content.
struct TreeFile {
  std::string mode = "100644";
  std::string blob;
  std::optional<std::string> content;  ///< goes before `blob`
};
using Tree = std::map<std::string, TreeFile>;

/// The files of a commit, and the blob of each.
Tree readTree(const Git& git, const std::string& commit);

/// Writes a tree's new contents and the tree. \param scratch a folder for the files that this takes
/// \return its name
std::string writeTree(const Git& git, const Tree& tree, const fs::path& scratch);

/// Who made a commit, and when.
struct Signature {
  std::string name, email, date;
};
Signature committerOf(const Git& git, const std::string& commit);

/// Makes a commit and gives its name; no branch is moved. \param parent empty: a root
std::string commitTree(const Git& git, const std::string& tree, const std::string& parent,
                       const std::string& message, const Signature& signature);

/// A blob that can be reached from a commit, with the first path under which it was met.
struct Blob {
  std::string id;
  std::string path;
  std::string content;
};
/// All of them, of the whole history.
std::vector<Blob> reachableBlobs(const Git& git, const std::string& commit,
                                 const fs::path& scratch);

}  // namespace carom::runner

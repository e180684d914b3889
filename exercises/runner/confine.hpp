#pragma once
// What a compiler, a linker, a reader of symbols and a submission itself see while they run confined
// (grading/sandbox.hpp): no grader's sources, no solutions, no hidden checks, no other submission.

#include "grading/sandbox.hpp"
#include "runner/manifest.hpp"

namespace carom::runner {

/// A folder for what a confined program writes. What comes out of it is a regular file or nothing.
class OutFolder {
 public:
  /// \param beside the folder in which it is made
  explicit OutFolder(const fs::path& beside);
  ~OutFolder();
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;
  const fs::path& path() const {
    return path_;
  }
  /// Moves a file out, as ours, to be written by nobody else. \return false when there is none, or it is a link
  bool take(const std::string& name, const fs::path& target) const;

 private:
  fs::path path_;
};

/// The command of a compiler that reads one source file.
/// \param command compiles `source` into `out`
/// \param exercise what it answers
grading::Command confinedCompiler(const Project& project, const Exercise& exercise,
                                  grading::Command command, const fs::path& source,
                                  const fs::path& out, const grading::Sandbox& sandbox);

/// The command of a tool (linker, nm) that reads a few files.
/// \param inputs every file that it may read
/// \param out the folder that it may write to; empty: none
grading::Command confinedTool(const Project& project, grading::Command command,
                              const std::vector<fs::path>& inputs, const fs::path& out,
                              const grading::Sandbox& sandbox);

/// The command of a linked submission: sees itself and the system's libraries that it needs, nothing else, and has
/// the lock on system calls.
/// \param trusted a program of ours, linked with the same libraries, which says where they are; empty: this program
grading::Command confinedProgram(grading::Command command, const fs::path& trusted,
                                 const grading::Sandbox& sandbox);

}  // namespace carom::runner

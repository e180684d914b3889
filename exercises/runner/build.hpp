#pragma once
// From a submission's source file to something that can be run.

#include "grading/sandbox.hpp"
#include "runner/manifest.hpp"
#include "runner/screen.hpp"

namespace carom::runner {

/// A folder of its own for the files of one check, removed with the object.
class WorkFolder {
 public:
  explicit WorkFolder(const Project& project);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const fs::path& path() const {
    return path_;
  }

 private:
  fs::path path_;
};

struct Compiled {
  fs::path object;
  bool ok = false;
  bool limited = false;            ///< the compiler was stopped by a limit
  std::string firstError;          ///< file:line:column: message, with the source line
  std::string plain;               ///< the same in a plain sentence, for the commonest mistakes
  std::string full;                ///< everything that the compiler said
  std::vector<fs::path> included;  ///< every file that was read, the submission itself first
  int warnings = 0;
  double seconds = 0;
};

/// Compiles one file as the answer to an exercise, with limits on time and memory.
/// \param cpuSeconds limit on the compiler's processor time; 0: the usual
/// \param sandbox what confines the compiler; none: it can read all that we can
Compiled compileSubmission(const Project& project, const Exercise& exercise, const fs::path& source,
                           const fs::path& folder, int cpuSeconds = 0,
                           const grading::Sandbox* sandbox = nullptr,
                           const std::vector<std::string>& moreFlags = {});

/// Links the submission with the tests (self-check). \throws Failure (ourFault) when the link fails
fs::path linkSelfCheck(const Project& project, const Exercise& exercise, const fs::path& object,
                       const fs::path& folder);

/// Links the submission with the program that answers the pipe (grading).
/// \param sandbox what confines the linker, which reads an object that a hostile source was made into
fs::path linkChild(const Project& project, const Exercise& exercise, const fs::path& object,
                   const fs::path& folder, const grading::Sandbox* sandbox = nullptr);

/// Links a student's test cases into a program that asks its questions through the pipe (kind test).
/// \throws Failure (ourFault) when the link fails
fs::path linkTester(const Project& project, const Exercise& exercise, const fs::path& object,
                    const fs::path& folder, const grading::Sandbox* sandbox = nullptr);

/// Links test cases with the library's version of the function in one program, for a debugger (kind test).
fs::path linkCases(const Project& project, const Exercise& exercise, const fs::path& object,
                   const fs::path& folder);

/// Links a chapter's program with the submission's function in place of the library's.
/// \param replaced objects by seam name
fs::path linkProgram(const Project& project, const std::string& program,
                     const std::vector<std::pair<std::string, fs::path>>& replaced,
                     const fs::path& folder);

}  // namespace carom::runner

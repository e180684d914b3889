#pragma once
// What a submission may use.
//
// An exercise is a function that returns an answer. Everything else that a C++ file can do (end the program, run
// code before main, open files, define main) is either a mistake or a way around the question, and is named as
// what it is. The screen reads the source text and the object file's symbols; the pipe, not the screen, is what
// makes grading safe.

#include <string>
#include <vector>

#include "grading/sandbox.hpp"
#include "runner/manifest.hpp"

namespace carom::runner {

struct Screening {
  std::vector<std::string> refused;  ///< reasons not to run it, in sentences
  std::vector<std::string> notes;    ///< allowed, but worth a word
};

/// Looks at the source text for what leaves no trace in the object file.
/// \param isTest test cases may include what they are written with
void screenSource(std::string_view source, Screening& result, bool isTest = false);

/// Looks at the files that the compiler read for a submission: its own, the course's headers, the system's.
/// \param included as the compiler lists them, see Compiled::included
/// \param source the submission
void screenIncludes(const Project& project, const Exercise& exercise,
                    const std::vector<fs::path>& included, const fs::path& source,
                    Screening& result);

/// Looks at the symbols that the object defines and needs.
/// \param project the compiler's tools
/// \param exercise what is asked: a function, or test cases
/// \param object the compiled submission
/// \param library the library's own version of the function: what it defines is what a submission must define
/// \param stage the library that the answer may use
/// \param result collects what is found
/// \param sandbox what confines the reader of the submission's symbols
void screenObject(const Project& project, const Exercise& exercise, const fs::path& object,
                  const fs::path& library, const fs::path& stage, Screening& result,
                  const grading::Sandbox* sandbox = nullptr);

/// The functions that an object file defines for others, by their readable names without parameters.
std::vector<std::string> definedFunctions(const Project& project, const fs::path& object);

/// A symbol's readable name, or the symbol itself.
std::string demangled(const std::string& symbol);

}  // namespace carom::runner

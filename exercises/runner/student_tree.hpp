#pragma once
// The files that students get, made from those of the project.
//
// Left out: solutions/, hidden checks, the tests of the library, what is only for teachers, and the chapters that come
// later. What an exercise needs besides its skeleton moves to exercises/<chapter>/given/<name>/. The library's version
// of a function whose answer does not show is left out too: the build takes the student's own file in its place.

#include <string>
#include <vector>

#include "runner/course_file.hpp"
#include "runner/git.hpp"

namespace carom::runner {

/// What becomes of an exercise on the student branch.
enum class Standing {
  leftOut,  ///< not part of the course: the library keeps its version, nothing else of it is there
  later,    ///< its chapter comes later: its answer is secret already
  open,     ///< to be worked on
  shown     ///< its worked answer may be seen
};

/// The project's files and the decisions about them.
struct Cut {
  fs::path source;  ///< a clean copy of the commit
  Tree files;       ///< all files of the commit
  std::vector<Exercise> exercises;
  Course course;
  std::string upto;   ///< folder of the last chapter
  std::string today;  ///< as 2026-12-01

  Standing standing(const Exercise& exercise) const;
  bool isSecret(const Exercise& exercise) const {
    return standing(exercise) == Standing::open || standing(exercise) == Standing::later;
  }
  /// Is the chapter's page on the branch?
  bool hasChapter(const std::string& folder) const;
  /// The exercises whose answers nobody is to see.
  std::vector<const Exercise*> secret() const;
  /// Path of the library's version; empty where there is none.
  static std::string libraryFile(const Exercise& exercise);
  /// Path of the packed versions that students' own test cases meet; right answers are among them.
  static std::string versionsFile(const Exercise& exercise);
  /// Are those versions on the branch? Not while the answer to the exercise that is tested is secret.
  bool showsVersions(const Exercise& exercise) const;
  /// The chapters that are on the branch, in order.
  std::vector<std::string> chapters() const;
};

/// The tree of the student branch. \throws Failure naming a file that is not as it should be
Tree studentTree(const Cut& cut);

/// The student tree with the worked answers of these chapters in place of the skeletons.
Tree solvedTree(const Cut& cut, const Tree& student, const std::vector<std::string>& chapters);

/// Takes test cases out of the source of a grader, and what only they use in its unnamed namespace.
/// \throws Failure naming a check that has no test case
std::string withoutTestCases(std::string_view source, const std::vector<std::string>& names,
                             const std::string& file);

/// The facts of an exercise without its hidden checks and the misunderstandings that only those find.
std::string withoutChecks(std::string_view ini, const std::vector<std::string>& hidden);

/// The same of its fingerprints. \param ini the facts that are left
std::string withoutFingerprints(std::string_view json, std::string_view ini);

}  // namespace carom::runner

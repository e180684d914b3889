#pragma once
// Exercises of the kind `test`: the student writes test cases, and what they catch is graded.
//
// The cases are compiled once, into a program without the function that they call. The program meets the library's
// version of the function, other right ones, and wrong ones, each in a process of its own behind a pipe. It has to
// pass on all that are right; each scored check is one wrong version on which some case has to fail. A program that
// ends early passes everywhere and catches nothing; one that always fails fails on the right ones as well; one that
// fails at random, or counts, meets each version twice and in an order that it cannot know.
//
// The versions travel with the course packed (tests/graders/<chapter>/<name>.versions.json), so that nobody who reads
// the folder reads them by accident. Packed is not locked: who unpacks them spoils the exercise for himself, and gains
// no points that the cases do not earn.
//
// Idea: grading tests by the faulty versions that they catch, as the course EECS 280 of the University of Michigan
// does; in research it is called mutation analysis (DeMillo, Lipton and Sayward, 1978).

#include "runner/check.hpp"

namespace carom::runner {

/// One version of the function that the cases are about.
struct TestedVersion {
  std::string check;  ///< the check that is earned by catching it; empty: it is right
  std::string source;
};

/// The file of packed versions of an exercise, relative to the project.
fs::path versionsFile(const Exercise& exercise);

/// The versions that travel with the course. \throws Failure (ourFault) if the file is missing or damaged
std::vector<TestedVersion> packedVersions(const Project& project, const Exercise& exercise);

/// The same from the sources below solutions/: other right versions are those in right/ of the exercise that
/// `tests` names and its worked answer; wrong ones stand in versions/ of this exercise, or in wrong/ of that one.
/// \throws Failure (ourFault) naming a version that does not exist
std::vector<TestedVersion> authoredVersions(const Project& project, const Exercise& exercise);

/// The content of versionsFile().
std::string packed(const std::vector<TestedVersion>& versions);

/// Runs the student's cases against all versions and fills in the checks and the status.
/// \param program the cases, linked by linkTester()
void checkVersions(const Project& project, const Exercise& exercise, const CheckOptions& options,
                   const fs::path& program, const fs::path& folder, ExerciseResult& result);

}  // namespace carom::runner

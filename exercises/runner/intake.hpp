#pragma once
// What students handed in: folders, archives and git repositories, of which only the files that
// exercises name are taken.
//
// Everything here is hostile until it has been looked at. Nothing is unpacked to disk, no link is
// followed, no repository's own settings are read and none of its programs (hooks, filters) is run.
// What cannot be taken is said in a sentence that belongs to one student; it never ends the intake
// of the others.

#include <map>
#include <string>
#include <vector>

#include "runner/manifest.hpp"

namespace carom::runner {

/// The bounds of a submission: far above what honest work needs.
struct IntakeLimits {
  std::size_t fileBytes = 256u << 10;     ///< of a file that an exercise names
  std::size_t unpackedBytes = 64u << 20;  ///< of everything in an archive
  std::size_t archiveBytes = 64u << 20;   ///< of the archive itself
  std::size_t entries = 20000;            ///< files and folders
};

struct Submission {
  std::string student;                         ///< fit to be the name of a folder
  std::string source;                          ///< what was handed in: the name of a file or folder
  std::map<std::string, std::string> files;    ///< contents, by the exercise's id
  std::map<std::string, std::string> refused;  ///< why a file is not taken, by the exercise's id
  std::string refusedWhole;                    ///< why nothing of it is taken; empty: something is
  std::vector<std::string> notes;              ///< worth a word to the teacher
  std::string date;                            ///< of the last commit, if git; anybody can set it
};

struct Intake {
  std::vector<Submission> submissions;  ///< by student
  std::vector<std::string> notes;       ///< what in a class's folder is nobody's submission
};

/// Takes what is handed in. A folder is one submission when it is a git repository or holds files
/// of the course, and a class otherwise: then each folder and archive in it is a student's.
/// \param which the exercises of the course
/// \param from folders, archives (zip, tar, tar.gz, tar.xz, tar.bz2), git repositories and bundles
/// \param student the name for the only submission; empty: names of files and folders are names of
/// students
/// \throws Failure (usage) when a source does not exist, or `student` is given for several
Intake takeIn(const std::vector<const Exercise*>& which, const std::vector<fs::path>& from,
              const std::string& student, const IntakeLimits& limits = {});

/// A student's name as a name of a folder, a cell and a heading: letters of all scripts, digits,
/// blanks and the signs _ - . , @ ' ( ) stay, everything else becomes _; no dot or sign of a
/// formula in front.
std::string safeName(std::string_view name);

}  // namespace carom::runner

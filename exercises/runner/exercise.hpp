#pragma once
// What an exercise is: the facts of its exercise.ini, and where its files are.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "runner/text.hpp"

namespace carom::runner {

/// A scored question: one TEST_CASE of the grader, conditioned on one misconception.
struct Check {
  std::string name;
  std::string title;
  double points = 0;         ///< 0: a guard, which must hold but earns nothing
  std::string wrong;         ///< the misconception that it finds, if one
  std::string read;          ///< section of the chapter to read
  std::string catches = "";  ///< kind test: the wrong version on which some case must fail
  std::string slipped =
      "";  ///< kind test: what kind of mistake gets past cases that do not catch it
};

/// The two checks that every exercise of the kind test has by itself; both must hold and earn nothing.
inline constexpr const char* kPassesOnRight = "passes_on_right";
inline constexpr const char* kEveryCaseAsks = "every_case_asks";

/// A catalogued misconception: wrong/<name>.cpp holds the version that has it.
struct Wrong {
  std::string name;
  std::string says;  ///< what was misunderstood, in a sentence
  std::string read;
  std::string check;              ///< the check that must fail on it
  std::vector<std::string> also;  ///< what else may fail with it, because it leans on the same
  /// Whether a check is its own or one of those.
  bool mayFail(const std::string& one) const {
    return one == check || std::find(also.begin(), also.end(), one) != also.end();
  }
};

struct Exercise {
  std::string id;  ///< 01.hamilton_product
  std::string title;
  std::string kind;  ///< implement, fix, predict, test, measure, explore
  int level = 1;
  int minutes = 0;
  double points = 0;
  std::string chapter;  ///< folder: 01_rotation
  std::string name;     ///< file name: hamilton_product
  std::string layer;
  std::string home;     ///< folder that holds the library's version
  std::string tests;    ///< kind test: the exercise whose function the cases are about
  std::string program;  ///< chapter/program that shows the function at work
  std::string read;     ///< section of the chapter page
  std::vector<std::string> uses;
  std::vector<std::string> hints;
  std::vector<Check> checks;
  std::vector<Wrong> wrong;
  fs::path folder;        ///< one of exerciseFolders()
  std::string extension;  ///< .cpp, or .txt for a prediction

  std::string fileName() const {
    return name + extension;
  }
  /// The file that a student edits, relative to the project.
  fs::path studentFile() const {
    return fs::path("exercises") / chapter / fileName();
  }
  fs::path graderFolder() const {
    return fs::path("tests/graders") / chapter;
  }
  bool isPrediction() const {
    return kind == "predict";
  }
  /// Does the student write test cases?
  bool isTest() const {
    return kind == "test";
  }
};

/// Reads one exercise.ini. Problems (a missing key, an unknown one, a number that is none) are added to
/// `problems`, each beginning with the file's name.
Exercise readExercise(const fs::path& folder, std::vector<std::string>& problems);

/// The folders of all exercises: solutions/<chapter>/<name>, where they are authored, and in a student's copy of the
/// course exercises/<chapter>/given/<name>, which holds the facts, the statement and the skeleton.
std::vector<fs::path> exerciseFolders(const fs::path& root);

/// What the student's file was before anything was written: cut from the answer, or as it is kept where there is none.
std::optional<std::string> skeletonOf(const Exercise& exercise);

/// All exercises of exerciseFolders(), in teaching order (by chapter, then as `order` in the file says, then by
/// level and name).
std::vector<Exercise> readExercises(const fs::path& root, std::vector<std::string>& problems);

}  // namespace carom::runner

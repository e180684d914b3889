#pragma once
// What a teacher decides about a course: which chapters and exercises, by when, what stays hidden,
// when worked answers show. It is read from a course file, the format of which is in
// docs/teachers.md.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runner/manifest.hpp"

namespace carom::runner {

/// What holds for one exercise in a course.
struct ExercisePolicy {
  bool taken = true;                     ///< is it part of the course?
  std::string due;                       ///< last day, as 2026-12-01; empty: none
  std::string solutions = "after due";   ///< when worked answers show: always, after due, never
  double points = 0;                     ///< what all of its checks are worth together
  std::vector<std::string> hidden;       ///< checks that students do not have
  std::string topic = "further inputs";  ///< what reports call those
  /// Is this check one that students do not have?
  bool hides(const std::string& check) const;
};

/// The rules of a section of the course file. What is empty is taken from the section above it.
struct CourseRules {
  std::string due;
  std::string solutions;
  double points = -1;  ///< less than zero: as the exercise says
  std::vector<std::string> hidden;
  std::string topic;
};

struct Course {
  std::string title;
  fs::path file;                   ///< empty: the course of all exercises, without a file
  fs::path secretFile;             ///< empty: none
  std::string secret;              ///< the bytes of that file
  std::set<std::string> chapters;  ///< folders of the chapters that are taken
  std::set<std::string> without;   ///< ids of exercises that are left out
  CourseRules rules;
  std::map<std::string, CourseRules> chapterRules;   ///< by folder
  std::map<std::string, CourseRules> exerciseRules;  ///< by id

  /// What holds for an exercise: its own section goes before its chapter's, and that before the course's.
  ExercisePolicy policy(const Exercise& exercise) const;
  /// May its worked answer be seen on this day? After due means the day after the last one, and an exercise without
  /// a last day never shows then: who forgets a date gives nothing away.
  /// \param today as 2026-12-02
  bool solutionShows(const Exercise& exercise, const std::string& today) const;
};

/// Reads a course file. \throws Failure (usage) naming the file and every line of it that is wrong: a section or key
/// that is not known or is given twice, a chapter, exercise or check that does not exist, a date that is none, an
/// exercise with no check left for students, an empty secret
Course readCourse(const fs::path& file, const Project& project);

/// The course without a file: all exercises, no dates, nothing hidden, no secret.
Course defaultCourse(const Project& project);

/// The day as 2026-12-01, in the time zone of the machine.
std::string todaysDate();

/// Whether a text is a day of the calendar as 2026-12-01.
bool isDate(const std::string& text);

/// The seed of a student's inputs: the first eight bytes of HMAC-SHA-256 over student, zero byte, exercise, with the
/// course's secret as its key; never 0. A course without a secret has the fixed key "carom", which anybody can look up.
std::uint64_t seedOf(const Course& course, const std::string& student, const std::string& exercise);

}  // namespace carom::runner

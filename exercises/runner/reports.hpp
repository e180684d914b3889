#pragma once
// Reports from records: what students, teachers and platforms read. Formats:
//
//   grades.csv                a row per student, as spreadsheets and learning platforms import it
//   class.html                one page for the teacher; needs no network
//   junit.xml                 all students, as CI systems show it
//   <student>/feedback.md     for the student
//   <student>/junit.xml       the same student's checks
//   <student>/results.json    as Gradescope reads it
//   <student>/classroom.json  as GitHub Classroom's reporter reads it, base64 there
//
// Hidden checks are named by their topic in everything but class.html, which is the teacher's.

#include "runner/records.hpp"

namespace carom::runner {

/// Writes all reports into a folder. What it holds of students who are not in the records stays.
void writeReports(const fs::path& out, const Records& records);

/// What one student's results are worth, from records.
struct Grade {
  double points = 0;
  double of = 0;
  bool graded = true;     ///< false: something was not graded, and points says nothing
  std::string state;      ///< graded, not taken, not graded
  std::string firstWord;  ///< the remark that matters most; empty: none
};
Grade gradeOf(const nlohmann::json& course, const nlohmann::json& student);

/// What a student's exercise earned. A guard that does not hold takes all of its points.
double pointsOf(const nlohmann::json& exercise, const nlohmann::json& result);

/// Text inside HTML and XML: &, <, >, quotes, and no control characters.
std::string markupEscaped(const std::string& text);

/// A cell of a CSV file: quoted, in one line, and never read as a formula.
std::string csvCell(const std::string& text);

/// 12, 7.5, 0.33: at most two digits after the point.
std::string shortNumber(double value);

/// The page for the class.
std::string classPage(const Records& records);

/// Everything in a student's results that somebody should look at, in sentences.
std::vector<std::string> toLookAt(const nlohmann::json& course, const nlohmann::json& student);

}  // namespace carom::runner

#pragma once
// Grades a class: takes the submissions in, asks each of them everything twice, keeps what came
// out, and writes the reports.
//
// What came out is kept as records, one JSON file per student, beside the files that were graded.
// Reports are made from records alone, so a grade can be looked into, made anew or joined with
// others later. Nothing in records and reports depends on the time, the machine's folders, or the
// order and number of jobs: the same submissions give the same bytes.

#include "runner/course_file.hpp"

namespace carom::runner {

struct GradeOptions {
  std::vector<fs::path> from;  ///< what was handed in; see takeIn
  fs::path out;                ///< folder of reports and records
  std::string student;         ///< the name for a single submission; empty: as it is called
  std::string only;            ///< only this student; empty: all
  std::string check;           ///< only this exercise or ID/check; empty: all
  int jobs = 0;                ///< at a time; 0: as many as there are cores
  std::string today;           ///< as 2026-12-01; empty: today
  bool trust = false;          ///< grade without a sandbox, where none can be had
};

/// Grades submissions and writes the reports. Results of an earlier or an interrupted run into the
/// same folder are kept where neither the file nor the course nor the student's seed has changed.
/// \param project whose graders are built when they are not
/// \param course what is graded, and how much it counts
/// \param options which submissions, and where to
/// \return 0; 70 when something was not graded through a fault of ours
/// \throws Failure (usage) for options that make no sense and reports of another version
int gradeClass(const Project& project, const Course& course, const GradeOptions& options);

/// Grades anew what the records in options.out hold: everything, a student, an exercise or a check.
/// \param project whose graders are built when they are not
/// \param course as it was when the records were made
/// \param options what to grade anew; `from` and `student` play no part
/// \return 0; 70 when something was not graded through a fault of ours
/// \throws Failure (usage) when there are no such records
int regradeClass(const Project& project, const Course& course, const GradeOptions& options);

/// What the lib, the graders and the facts of the exercises are, as a short text: two folders of
/// reports can be joined only when it is the same.
std::string courseVersion(const Project& project);

}  // namespace carom::runner

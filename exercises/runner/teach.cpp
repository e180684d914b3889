#include "runner/teach.hpp"

#include <CLI/CLI.hpp>

#include "runner/branch.hpp"
#include "runner/course_file.hpp"
#include "runner/grade_class.hpp"
#include "runner/merge.hpp"

namespace carom::runner {

struct TeachVerbs::Words {
  CLI::App* teach = nullptr;
  CLI::App* branch = nullptr;
  CLI::App* grade = nullptr;
  CLI::App* regrade = nullptr;
  CLI::App* merge = nullptr;
  BranchOptions branches;
  bool noBuild = false;
  GradeOptions grading;
  std::string courseFile;
  std::vector<fs::path> folders;
};

TeachVerbs::TeachVerbs(CLI::App& app) : words_(std::make_unique<Words>()) {
  auto& w = *words_;
  w.teach = app.add_subcommand("teach", "For teachers: grade a class, publish branches");
  w.teach->require_subcommand(1);
  auto both = [&](CLI::App* verb) {
    verb->add_option("--out", w.grading.out, "Folder of the reports")->required();
    verb->add_option("--course", w.courseFile, "The course file; without: all exercises");
    verb->add_option("--only", w.grading.only, "Only this student");
    verb->add_option("--check", w.grading.check, "Only this exercise, or ID/check of it");
    verb->add_option("--jobs", w.grading.jobs, "How many are graded at a time (all cores)")
        ->check(CLI::Range(1, 64));
    verb->add_option("--today", w.grading.today, "The day for dates, as 2026-12-01 (today)");
    verb->add_flag("--trust-submissions", w.grading.trust,
                   "Grade even where no sandbox can be had");
  };
  w.branch = w.teach->add_subcommand("branch", "Cut the branches for students and for solutions");
  w.branch->add_option("--upto", w.branches.upto, "Last chapter (all)");
  w.branch->add_option("--course", w.branches.courseFile,
                       "The course file; without: all exercises");
  w.branch->add_option("--today", w.branches.today, "The day for dates, as 2026-12-01 (today)");
  w.branch->add_option("--student", w.branches.student, "Name of the students' branch (student)");
  w.branch->add_option("--solved", w.branches.solved, "Name of the branch with answers (solved)");
  w.branch->add_option("--out", w.branches.out, "Write to this bare repository instead");
  w.branch->add_flag("--no-build", w.noBuild, "Prove that no answer is left, and try nothing");
  w.grade = w.teach->add_subcommand("grade", "Grade submissions and write the reports");
  w.grade->add_option("from", w.grading.from, "Folders of a class, submissions, archives, git")
      ->required();
  w.grade->add_option("--student", w.grading.student, "The one submission given is this student's");
  both(w.grade);
  w.regrade = w.teach->add_subcommand("regrade", "Grade again what --out holds");
  both(w.regrade);
  w.merge = w.teach->add_subcommand("merge", "Join reports that were made elsewhere");
  w.merge->add_option("reports", w.folders, "Folders that grade has written")->required();
  w.merge->add_option("--out", w.grading.out, "Folder of the joined reports")->required();
}

TeachVerbs::~TeachVerbs() = default;

bool TeachVerbs::asked() const {
  return words_->teach->parsed();
}

int TeachVerbs::run(const Project& project) const {
  const auto& w = *words_;
  if (w.branch->parsed()) {
    BranchOptions branches = w.branches;
    branches.build = !w.noBuild;
    return cutBranches(project, branches);
  }
  if (w.merge->parsed()) return mergeReports(w.folders, w.grading.out);
  const Course course =
      w.courseFile.empty() ? defaultCourse(project) : readCourse(w.courseFile, project);
  if (w.regrade->parsed()) return regradeClass(project, course, w.grading);
  return gradeClass(project, course, w.grading);
}

}  // namespace carom::runner

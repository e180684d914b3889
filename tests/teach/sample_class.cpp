// Makes classes from what the course has, and judges what grading made of them. By hand:
//
//   sample_class ROOT BUILD mixture FOLDER STUDENTS EXERCISES
//   course teach grade FOLDER --out OUT
//   sample_class ROOT BUILD versions FOLDER
//   course teach grade FOLDER --out OUT
//   sample_class ROOT BUILD judge OUT

#include <iostream>

#include "teach/sample.hpp"

using namespace carom::runner;

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() < 4) throw Failure{usage, "see the head of sample_class.cpp"};
    const Project project = openProject(words[0], words[1]);
    std::vector<const Exercise*> which;
    for (const auto& e : project.exercises) {
      if (!e.checks.empty()) which.push_back(&e);
    }
    if (words[2] == "mixture" && words.size() == 6) {
      which.resize(std::min<std::size_t>(which.size(), std::stoul(words[5])));
      carom_test::writeMixture(which, std::stoi(words[4]), words[3]);
      return 0;
    }
    if (words[2] == "versions") {
      carom_test::writeVersions(which, words[3]);
      return 0;
    }
    const auto verdict = carom_test::judge(which, readRecords(words[3]));
    for (const auto& problem : verdict.problems) std::cout << "PROBLEM  " << problem << "\n";
    std::cout << verdict.right << " right versions, " << verdict.skeletons << " skeletons, "
              << verdict.wrong << " wrong versions (" << verdict.alone
              << " with a single check to lose); " << verdict.problems.size() << " problems\n";
    return verdict.problems.empty() ? 0 : 1;
  } catch (const Failure& failure) {
    std::cerr << failure.message << "\n";
    return failure.exitCode;
  }
}

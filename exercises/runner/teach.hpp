#pragma once
// The verbs of `course teach`: what they are called with, and who does the work.

#include <memory>

#include "runner/manifest.hpp"

namespace CLI {
class App;
}

namespace carom::runner {

/// The verbs below `teach`. Made before the command line is read, asked after it.
class TeachVerbs {
 public:
  /// \param app gets the verb `teach` and those below it
  explicit TeachVerbs(CLI::App& app);
  ~TeachVerbs();
  TeachVerbs(const TeachVerbs&) = delete;
  TeachVerbs& operator=(const TeachVerbs&) = delete;

  /// Was one of them asked for?
  bool asked() const;
  /// Does it. \return the exit code of the program
  int run(const Project& project) const;

 private:
  struct Words;
  std::unique_ptr<Words> words_;
};

}  // namespace carom::runner

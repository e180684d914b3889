#pragma once
// Runs the program `carom` as a user does.

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "scratch.hpp"
#include "support/catch.hpp"

namespace carom_test {

struct Outcome {
  int exitCode;
  std::string out, err;
};

inline Outcome runCarom(const Scratch& scratch, const std::string& arguments) {
  const std::string out = scratch.file("out").string(), err = scratch.file("err").string();
  const std::string command =
      std::string("\"") + CAROM_PROGRAM + "\" " + arguments + " >\"" + out + "\" 2>\"" + err + "\"";
  const int status = std::system(command.c_str());
  REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), Scratch::read(out), Scratch::read(err)};
}

}  // namespace carom_test

// Are limits kept, and is the end of a process told in words?

#include "grading/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>

#include "support/catch.hpp"

using namespace carom::grading;
using carom_test::ContainsSubstring;

namespace {

Finished shell(const std::string& script, const Limits& limits = {}) {
  Command command;
  command.words = {"/bin/sh", "-c", script};
  command.limits = limits;
  return run(command);
}

bool runs(pid_t process) {
  // A process that has ended but was not waited for is still listed, as a zombie.
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  file >> number >> name >> state;
  return !state.empty() && state != "Z";
}

}  // namespace

TEST_CASE("a program's output and exit code come back") {
  const auto done = shell("echo out; echo err >&2; exit 3");
  CHECK(done.exitCode == 3);
  CHECK_FALSE(done.ok());
  CHECK(done.output == "out\nerr\n");
  CHECK(done.end == "ended with exit code 3");
  CHECK(shell("exit 0").ok());
}

TEST_CASE("a program that does not exist is an end like any other") {
  Command command;
  command.words = {"/no/such/program"};
  const auto done = run(command);
  CHECK(done.exitCode == 127);
  CHECK_THAT(done.output, ContainsSubstring("cannot be run: No such file"));
}

TEST_CASE("environment and folder are the command's") {
  Command command;
  command.words = {"/bin/sh", "-c", "echo $CAROM_TEST_VALUE; pwd"};
  command.environment = {"CAROM_TEST_VALUE=a b", "PATH=/usr/bin:/bin"};
  command.directory = "/usr";
  CHECK(run(command).output == "a b\n/usr\n");
}

TEST_CASE("standard input is closed") {
  CHECK(shell("read x || echo nothing").output == "nothing\n");
}

TEST_CASE("a program that waits too long is ended, and all that it has started") {
  Limits limits;
  limits.wallSeconds = 0.5;
  const auto done = shell("sleep 300 & echo $!; sleep 300", limits);
  CHECK(done.timedOut);
  CHECK_FALSE(done.ok());
  CHECK(done.end == "did not end in time");
  CHECK(done.seconds < 20);
  const pid_t grandchild = std::stoi(done.output);
  for (int i = 0; i < 100 && runs(grandchild); ++i) usleep(20000);
  CHECK_FALSE(runs(grandchild));
}

TEST_CASE("a child that is left behind with the output open holds nobody up") {
  const auto done = shell("sleep 300 & exit 0");
  CHECK(done.exitCode == 0);
  CHECK_FALSE(done.timedOut);
  CHECK(done.seconds < 5);
}

TEST_CASE("a program that computes too long is ended") {
  Limits limits;
  limits.cpuSeconds = 1;
  limits.wallSeconds = 60;
  const auto done = shell("while :; do :; done", limits);
  CHECK(done.end == "used up its processor time");
  CHECK(done.exitCode == -1);
}

TEST_CASE("a program that prints too much is ended, and what it printed is cut") {
  Limits limits;
  limits.outputKilobytes = 8;
  const auto done = shell("while :; do echo 0123456789; done", limits);
  CHECK(done.tooMuchOutput);
  CHECK_FALSE(done.ok());
  CHECK(done.output.size() == 8192);
  CHECK(done.end == "printed more than 8 kB");
}

TEST_CASE("a program that writes too large a file is ended") {
  Limits limits;
  limits.fileKilobytes = 4;
  const std::string file = "/tmp/carom_process_test_" + std::to_string(getpid());
  const auto done = shell("exec head -c 100000 /dev/zero > " + file, limits);
  CHECK(done.end == "wrote more to a file than it may");
  std::ifstream written(file, std::ios::ate | std::ios::binary);
  CHECK(written.tellg() <= 4096);
  unlink(file.c_str());
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("a program gets no more memory than it may have") {
  Limits limits;
  limits.memoryMegabytes = 64;
  CHECK_FALSE(shell("exec head -c 200000000 /dev/zero | tail | wc -c", limits).output ==
              "200000000\n");
}
#endif

TEST_CASE("every signal has words that a beginner understands") {
  const auto wordsFor = [](int signal) {
    return shell("kill -" + std::to_string(signal) + " $$").end;
  };
  CHECK_THAT(wordsFor(SIGSEGV), ContainsSubstring("crashed") && ContainsSubstring("memory"));
  CHECK_THAT(wordsFor(SIGFPE), ContainsSubstring("an integer was divided by zero"));
  CHECK_THAT(wordsFor(SIGABRT), ContainsSubstring("aborted itself"));
  CHECK(wordsFor(SIGKILL) == "was killed");
  CHECK(wordsFor(SIGXCPU) == "used up its processor time");
  CHECK_THAT(wordsFor(SIGTERM), ContainsSubstring("was ended by the signal"));
}

TEST_CASE("behind the sandbox a process can answer, and nothing else") {
  int answer[2];
  REQUIRE(pipe(answer) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (!enterSandbox()) {
      // A kernel without system call filters: nothing to test here.
      if (write(answer[1], "none", 4) < 0) _exit(1);
      _exit(0);
    }
    std::string can;
    if (open("/tmp/carom_sandbox_test", O_WRONLY | O_CREAT, 0600) >= 0) can += "create ";
    if (open("/dev/null", O_RDWR) >= 0) can += "write ";
    if (open("/dev/null", O_RDONLY) < 0) can += "not-read ";
    if (fork() >= 0) can += "fork ";
    if (kill(getppid(), 0) == 0) can += "signal ";
    if (unlink("/tmp/no_such_file_for_carom") == 0 || errno != EPERM) can += "unlink ";
    if (setpgid(0, 0) == 0) can += "group ";
    can += "answer";
    if (write(answer[1], can.data(), can.size()) < 0) _exit(1);
    _exit(0);
  }
  close(answer[1]);
  char text[200] = {};
  CHECK(read(answer[0], text, sizeof text - 1) > 0);
  close(answer[0]);
  int status = 0;
  CHECK(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  const std::string can = text;
  CHECK((can == "answer" || can == "none"));
}

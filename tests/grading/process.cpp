#include "grading/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

namespace carom::grading {

namespace {

void limit(__rlimit_resource what, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(what, &both);
}

}  // namespace

void applyLimits(const Limits& limits) {
  limit(RLIMIT_CORE, 0);
  if (limits.cpuSeconds) limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpuSeconds));
  if (limits.memoryMegabytes) limit(RLIMIT_AS, static_cast<rlim_t>(limits.memoryMegabytes) << 20);
  if (limits.fileKilobytes) limit(RLIMIT_FSIZE, static_cast<rlim_t>(limits.fileKilobytes) << 10);
  if (limits.processes) limit(RLIMIT_NPROC, static_cast<rlim_t>(limits.processes));
}

std::string describeEnd(int waitStatus) {
  if (WIFEXITED(waitStatus))
    return "ended with exit code " + std::to_string(WEXITSTATUS(waitStatus));
  const int signal = WTERMSIG(waitStatus);
  switch (signal) {
    case SIGSEGV:
      return "crashed (it used memory that is not its own: an index out of range, endless "
             "recursion)";
    case SIGFPE:
      return "crashed (an integer was divided by zero)";
    case SIGABRT:
      return "aborted itself (an assertion failed, or an exception left a noexcept function)";
    case SIGXCPU:
      return "used up its processor time";
    case SIGXFSZ:
      return "wrote more to a file than it may";
    case SIGKILL:
      return "was killed";
    default:
      return std::string("was ended by the signal ") + strsignal(signal);
  }
}

void killGroup(pid_t leader) {
  kill(-leader, SIGKILL);
  kill(leader, SIGKILL);
}

Finished run(const Command& command) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  Finished done;
  int output[2] = {-1, -1};
  if (!command.inheritOutput && pipe2(output, O_CLOEXEC) != 0) {
    done.end = std::string("could not be started: ") + std::strerror(errno);
    return done;
  }
  // Everything that allocates happens before fork.
  std::vector<char*> words;
  for (const auto& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  std::vector<char*> environment;
  for (char** entry = environ; *entry; ++entry) {
    bool replaced = false;
    for (const auto& own : command.environment) {
      const auto name = own.substr(0, own.find('=') + 1);
      replaced |= std::strncmp(*entry, name.c_str(), name.size()) == 0;
    }
    if (!replaced) environment.push_back(*entry);
  }
  for (const auto& own : command.environment) environment.push_back(const_cast<char*>(own.c_str()));
  environment.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0) {
    done.end = std::string("could not be started: ") + std::strerror(errno);
    if (output[0] >= 0) close(output[0]), close(output[1]);
    return done;
  }
  if (child == 0) {
    setpgid(0, 0);
    if (!command.directory.empty() && chdir(command.directory.c_str()) != 0) _exit(127);
    if (!command.inheritInput) {
      const int nothing = open("/dev/null", O_RDONLY);
      dup2(nothing, 0);
    }
    if (!command.inheritOutput) {
      dup2(output[1], 1);
      dup2(output[1], 2);
    }
    applyLimits(command.limits);
    execvpe(words[0], words.data(), environment.data());
    const char* text = "cannot be run: ";
    if (write(2, text, std::strlen(text)) > 0) {
      const char* reason = std::strerror(errno);
      if (write(2, reason, std::strlen(reason)) < 0) _exit(127);
    }
    _exit(127);
  }
  setpgid(child, child);
  if (output[1] >= 0) close(output[1]);

  const auto deadline = begin + std::chrono::duration_cast<Clock::duration>(
                                    std::chrono::duration<double>(command.limits.wallSeconds));
  const bool timed = command.limits.wallSeconds > 0;
  auto timeLeft = [&]() -> int {
    if (!timed) return 1000;
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    return left < 0 ? 0 : static_cast<int>(left < 1000 ? left + 1 : 1000);
  };
  int status = 0;
  bool reaped = false;
  bool open = output[0] >= 0;
  char buffer[1 << 16];
  const auto most = static_cast<std::size_t>(command.limits.outputKilobytes) << 10;
  while (true) {
    if (open) {
      pollfd fd{output[0], POLLIN, 0};
      // A grandchild may hold the pipe open after the child has ended, so look at both.
      if (poll(&fd, 1, reaped ? 0 : std::min(timeLeft(), 20)) > 0) {
        const ssize_t got = read(output[0], buffer, sizeof buffer);
        if (got <= 0) {
          open = false;
        } else {
          done.output.append(buffer, static_cast<std::size_t>(got));
          if (most && done.output.size() > most) {
            done.output.resize(most);
            done.tooMuchOutput = true;
            break;
          }
          continue;
        }
      } else if (reaped) {
        open = false;
      }
    }
    if (!reaped && waitpid(child, &status, WNOHANG) == child) reaped = true;
    if (reaped && !open) break;
    if (timed && Clock::now() >= deadline) {
      done.timedOut = true;
      break;
    }
    if (!open && !reaped) usleep(1000);
  }
  killGroup(child);
  if (!reaped) waitpid(child, &status, 0);
  if (output[0] >= 0) close(output[0]);
  if (WIFEXITED(status) && !done.timedOut && !done.tooMuchOutput)
    done.exitCode = WEXITSTATUS(status);
  done.end = done.timedOut ? "did not end in time"
             : done.tooMuchOutput
                 ? "printed more than " + std::to_string(command.limits.outputKilobytes) + " kB"
                 : describeEnd(status);
  done.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return done;
}

}  // namespace carom::grading

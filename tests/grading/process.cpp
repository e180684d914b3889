#include "grading/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#if __has_include(<linux/seccomp.h>) && (defined(__x86_64__) || defined(__aarch64__))
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#define CAROM_HAS_SECCOMP 1
#endif

namespace carom::grading {

namespace {

void limit(__rlimit_resource what, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(what, &both);
}

#ifdef CAROM_HAS_SECCOMP

// What a program needs that is loaded, computes, and answers on open files. Everything else fails with EPERM,
// which a harmless program survives.
constexpr unsigned kHarmless[] = {
    __NR_read,
    __NR_write,
    __NR_readv,
    __NR_writev,
    __NR_pread64,
    __NR_lseek,
    __NR_close,
    __NR_fstat,
    __NR_newfstatat,
    __NR_statx,
    __NR_faccessat,
    __NR_faccessat2,
    __NR_readlinkat,
    __NR_mmap,
    __NR_mprotect,
    __NR_munmap,
    __NR_mremap,
    __NR_brk,
    __NR_madvise,
    __NR_execveat,
    __NR_exit,
    __NR_exit_group,
    __NR_rt_sigaction,
    __NR_rt_sigprocmask,
    __NR_rt_sigreturn,
    __NR_sigaltstack,
    __NR_futex,
    __NR_set_tid_address,
    __NR_set_robust_list,
    __NR_rseq,
    __NR_getrandom,
    __NR_getpid,
    __NR_gettid,
    __NR_getuid,
    __NR_geteuid,
    __NR_getgid,
    __NR_getegid,
    __NR_getppid,
    __NR_clock_gettime,
    __NR_clock_nanosleep,
    __NR_nanosleep,
    __NR_gettimeofday,
    __NR_uname,
    __NR_sched_yield,
    __NR_sched_getaffinity,
    __NR_restart_syscall,
    __NR_getrusage,
#ifdef __x86_64__
    __NR_stat,
    __NR_lstat,
    __NR_access,
    __NR_readlink,
    __NR_arch_prctl,
    __NR_getrlimit,
    __NR_time,
#endif
};

constexpr unsigned kMachine =
#ifdef __x86_64__
    AUDIT_ARCH_X86_64;
#else
    AUDIT_ARCH_AARCH64;
#endif

// The lower half of argument i of a system call (both machines are little-endian).
constexpr unsigned argument(int i) {
  return static_cast<unsigned>(offsetof(seccomp_data, args) + 8u * static_cast<unsigned>(i));
}

struct Filter {
  sock_filter rules[48 + 2 * std::size(kHarmless)];
  unsigned short size = 0;
};

// \param self the process that may send itself a signal; 0: whoever is in the same namespace
// \param exec may it run a program by name, and wait for it?
Filter makeFilter(unsigned self, bool exec) {
  constexpr unsigned short load = BPF_LD | BPF_W | BPF_ABS;
  constexpr unsigned short equal = BPF_JMP | BPF_JEQ | BPF_K;
  constexpr unsigned short anyBit = BPF_JMP | BPF_JSET | BPF_K;
  constexpr unsigned short leave = BPF_RET | BPF_K;
  constexpr unsigned allow = SECCOMP_RET_ALLOW;
  constexpr unsigned refuse = SECCOMP_RET_ERRNO | EPERM;
  constexpr unsigned number = offsetof(seccomp_data, nr);
  constexpr unsigned writing =
      O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND | (O_TMPFILE & ~O_DIRECTORY);
  Filter filter{};
  auto add = [&](unsigned short code, unsigned k, unsigned char yes = 0, unsigned char no = 0) {
    filter.rules[filter.size++] = sock_filter{code, yes, no, k};
  };
  // allowed(call, i, test, k): the call when argument i passes the test.
  auto allowed = [&](unsigned call, int i, unsigned short test, unsigned k, bool wanted) {
    add(equal, call, 0, 4);
    add(load, argument(i));
    add(test, k, wanted ? 0 : 1, wanted ? 1 : 0);
    add(leave, allow);
    add(leave, refuse);
  };
  auto always = [&](unsigned call) {
    add(equal, call, 0, 1);
    add(leave, allow);
  };
  add(load, offsetof(seccomp_data, arch));
  add(equal, kMachine, 1, 0);
  add(leave, refuse);
  add(load, number);
  for (const unsigned call : kHarmless) always(call);
  if (exec) {
    always(__NR_execve);
    always(__NR_wait4);
  }
  allowed(__NR_openat, 2, anyBit, writing, false);
#ifdef __x86_64__
  allowed(__NR_open, 1, anyBit, writing, false);
#endif
  allowed(__NR_prlimit64, 0, equal, 0, true);  // its own limits
  // abort()
  if (self) {
    allowed(__NR_tgkill, 0, equal, self, true);
  } else {
    always(__NR_tgkill);
  }
  add(leave, refuse);
  return filter;
}
#endif

}  // namespace

bool enterSandbox() {
#ifdef CAROM_HAS_SECCOMP
  // No new rights by exec, and for root none of the old ones either: uid 0 alone opens no other process.
  dropRights();
  Filter filter = makeFilter(static_cast<unsigned>(getpid()), false);
  const sock_fprog all{filter.size, filter.rules};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all, 0, 0) == 0;
#else
  return false;
#endif
}

std::string systemCallFilter() {
#ifdef CAROM_HAS_SECCOMP
  const Filter filter = makeFilter(0, true);
  return {reinterpret_cast<const char*>(filter.rules), filter.size * sizeof(sock_filter)};
#else
  return {};
#endif
}

int filterFile() {
  const std::string rules = systemCallFilter();
  const int file = memfd_create("filter", MFD_CLOEXEC);
  if (file >= 0 && (write(file, rules.data(), rules.size()) != static_cast<ssize_t>(rules.size()) ||
                    lseek(file, 0, SEEK_SET) != 0)) {
    close(file);
    return -1;
  }
  return file;
}

// The address sanitizer maps terabytes of shadow memory; what is started from here is built as this file is.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

void applyLimits(const Limits& limits) {
  limit(RLIMIT_CORE, 0);
  if (limits.cpuSeconds) {
    // SIGXCPU at the soft limit can be told in words; at the hard one, a second later, comes SIGKILL.
    const auto seconds = static_cast<rlim_t>(limits.cpuSeconds);
    const rlimit both{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &both);
  }
  if (limits.memoryMegabytes && !sanitized)
    limit(RLIMIT_AS, static_cast<rlim_t>(limits.memoryMegabytes) << 20);
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

int endInside(int waitStatus) {
  if (!WIFEXITED(waitStatus)) return waitStatus;
  const int signal = WEXITSTATUS(waitStatus) - 128;
  return signal > 0 && signal < 65 ? signal : waitStatus;
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
  const Enclosure& enclosure = command.enclosure;
  for (char** entry = environ; *entry && !enclosure.any; ++entry) {
    bool replaced = false;
    for (const auto& own : command.environment) {
      const auto name = own.substr(0, own.find('=') + 1);
      replaced |= std::strncmp(*entry, name.c_str(), name.size()) == 0;
    }
    if (!replaced) environment.push_back(*entry);
  }
  for (const auto& own : command.environment) environment.push_back(const_cast<char*>(own.c_str()));
  environment.push_back(nullptr);

  int filter = command.filtered ? filterFile() : -1;
  const pid_t child = fork();
  if (filter >= 0 && child != 0) close(filter);
  if (child < 0) {
    done.end = std::string("could not be started: ") + std::strerror(errno);
    if (output[0] >= 0) close(output[0]), close(output[1]);
    return done;
  }
  if (child == 0) {
    // Enclosed work has no terminal either.
    if (enclosure.any) {
      setsid();
    } else {
      setpgid(0, 0);
    }
    if (!command.directory.empty() && chdir(command.directory.c_str()) != 0) _exit(127);
    if (!command.inheritInput) {
      const int nothing = open("/dev/null", O_RDONLY);
      dup2(nothing, 0);
    }
    if (!command.inheritOutput) {
      dup2(output[1], 1);
      dup2(output[1], 2);
    }
    // Out of the way first: one of them may stand where another has to go.
    constexpr int away = 3 + 8;
    int next = 3;
    int moved[8];
    if (filter >= 0) filter = fcntl(filter, F_DUPFD_CLOEXEC, away + 8);
    for (std::size_t i = 0; i < command.files.size() && i < std::size(moved); ++i)
      moved[i] = fcntl(command.files[i], F_DUPFD_CLOEXEC, away);
    for (std::size_t i = 0; i < command.files.size() && i < std::size(moved); ++i)
      dup2(moved[i], next++);
    if (filter >= 0) dup2(filter, next++);
    if (enclosure.any) closeFrom(next);
    applyLimits(command.limits);
    auto leave = [](const char* what, int exitCode) {
      const char* reason = std::strerror(errno);
      if (write(2, what, std::strlen(what)) < 0 || write(2, reason, std::strlen(reason)) < 0)
        _exit(exitCode);
      _exit(exitCode);
    };
    if (!enter(enclosure)) leave("the sandbox cannot be entered: ", 126);
    if (command.shutIn) {
      // Opened before the rights go: root without them cannot enter the folders of other users.
      const int file = open(words[0], O_RDONLY | O_CLOEXEC);
      enterSandbox();
      syscall(SYS_execveat, file, "", words.data(), environment.data(), AT_EMPTY_PATH);
    } else {
      execvpe(words[0], words.data(), environment.data());
    }
    leave("cannot be run: ", 127);
  }
  if (!enclosure.any) setpgid(child, child);
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
  if (enclosure.any) status = endInside(status);
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

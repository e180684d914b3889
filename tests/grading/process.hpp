#pragma once
// Runs a program that may be hostile: in a process group of its own, with limits, and with an end that is
// described in words.

#include <sys/types.h>

#include <string>
#include <vector>

#include "grading/enclosure.hpp"

namespace carom::grading {

/// What a child process may use. Zero means no limit.
struct Limits {
  double wallSeconds = 10;
  int cpuSeconds = 10;
  long memoryMegabytes = 0;   ///< address space; not kept in a build with the address sanitizer
  long fileKilobytes = 0;     ///< largest file it may write
  long outputKilobytes = 64;  ///< what it may print before it is ended
  int processes = 0;          ///< threads and processes of this user (does not bind root)
};

/// Takes over the limits in a process that is about to become the child. Wall time and output are its parent's work.
void applyLimits(const Limits& limits);

/// Shuts the calling process in, for good and for everything that it starts: from here on it can read, compute and
/// answer on the files that are open already, but not write to another, start or signal a process, or look into
/// one. Needs no rights. For the child between fork and exec. \return false where the system has no such lock
bool enterSandbox();

/// The rules of enterSandbox() for a program in a process namespace of its own, as bubblewrap takes them: bytes of a
/// BPF program; none where the system has no such lock. They also allow execve and wait4, with which bubblewrap starts
/// it and waits for it.
std::string systemCallFilter();

/// systemCallFilter() in an open file. \return its descriptor, -1 when there is none
int filterFile();

/// Says how a process ended: "crashed (segmentation fault)", "ended with exit code 3".
std::string describeEnd(int waitStatus);

/// How the enclosed program ended, of the status of the process that guarded it: a shell's 128 + n is signal n.
int endInside(int waitStatus);

/// Kills the process group and everything in it.
void killGroup(pid_t leader);

struct Finished {
  int exitCode = -1;      ///< -1 when a signal ended it
  bool timedOut = false;  ///< the wall clock ran out
  bool tooMuchOutput = false;
  std::string output;  ///< what it printed, both streams, as far as allowed
  std::string end;     ///< how it ended, in words
  double seconds = 0;
  bool ok() const {
    return exitCode == 0 && !timedOut && !tooMuchOutput;
  }
};

struct Command {
  std::vector<std::string> words;        ///< program and arguments
  std::vector<std::string> environment;  ///< NAME=value, added to the parent's
  std::string directory;                 ///< where to run; empty: here
  Limits limits;
  Enclosure enclosure;         ///< see sandbox.hpp
  bool inheritOutput = false;  ///< print to our own streams instead of collecting
  bool inheritInput = false;
  /// Open files of ours that become 3, 4, ... in the child, in this order.
  std::vector<int> files;
  /// enterSandbox() before the program starts, which must then be named by its whole path.
  bool shutIn = false;
  /// filterFile() comes as one more of the files, for bubblewrap. Made by confined() of shutIn.
  bool filtered = false;
};

/// Runs a command and waits for its end or its limits. Never throws for what the command does.
Finished run(const Command& command);

}  // namespace carom::grading

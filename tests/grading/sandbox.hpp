#pragma once
// Shuts untrusted work in: compiling a submission, linking it, and running it.
//
// Three tiers, the best that this machine allows:
// - bubblewrap: the program of that name makes namespaces (files, processes, network, users) and shows in them what
//   is named and nothing else. Works for root and, where user namespaces are on, for everybody.
// - namespaces: the same, made here with unshare(2) and mount(2), for machines without bubblewrap. Fewer eyes have
//   looked at it.
// - limits: time, memory, file sizes, and the lock on system calls that every child behind the pipe has (see
//   process.hpp). Files and the network stay open to a compiler: not for work that nobody vouches for.
//
// Root becomes uid 65534 first, because the limit on processes does not bind root, and because what escapes should
// not be root. Where uid 65534 cannot reach the files, root stays root without any right.
//
// Idea: Linux namespaces; the limits of the sandboxes of online judges (Mares and Blackham, 2012, "A New Contest
// Sandbox").

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "grading/process.hpp"

namespace carom::grading {

/// What runs untrusted work, best first.
enum class Tier { bubblewrap, namespaces, limits };
/// The tier's name, as reports print it.
const char* nameOf(Tier tier);

/// A tier that has been tried and works here.
struct Sandbox {
  Tier tier = Tier::limits;
  std::string why;        ///< why not a better tier; empty for the best one
  bool asNobody = false;  ///< we are root, and it works as uid 65534
  bool asSelf = true;     ///< it works as the user that we are
};

/// Every tier that works here, best first; `limits` is always the last. Each is tried by running /usr/bin/true in it,
/// once in the life of the process.
const std::vector<Sandbox>& sandboxes();

/// The best of sandboxes().
Sandbox bestSandbox();

/// Tier and reason in one line: "bubblewrap", "limits (bubblewrap: not installed; namespaces: ...)".
std::string describe(const Sandbox& sandbox);

/// True when the sandbox can still be entered: tells a fault of ours from one of what runs in it.
bool works(const Sandbox& sandbox);

/// What confined work sees. Everything else does not exist for it (in the tier `limits`: is not hidden from it).
struct Confinement {
  std::vector<std::filesystem::path> readable;  ///< files and folders, at their own paths
  std::vector<std::filesystem::path> writable;  ///< folders that it may write to
  /// Files and folders that it sees at another path: {where it is, where it is seen}.
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> shown;
  std::vector<std::filesystem::path> hidden;  ///< folders in the toolchain's that it must not see
  bool toolchain = false;                     ///< the system's programs, headers and libraries
};

/// The command, changed so that it runs confined: with an empty environment but for its own, with no files open but the
/// standard ones and its own, in namespaces of its own. Its limits stay; the one on processes holds for uid 65534 only.
/// Gives the writable folders to the user that it will run as.
/// \throws std::invalid_argument for a path that is not absolute or does not exist
Command confined(Command command, const Confinement& confinement, const Sandbox& sandbox);

/// A confined command as one text, for a process that shall start it, and back.
std::string toText(const Command& confined);
Command fromText(const std::string& text);

}  // namespace carom::grading

#include "grading/sandbox.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>

namespace carom::grading {

namespace fs = std::filesystem;

namespace {

constexpr unsigned kNobody = 65534;

// The system's programs, headers and libraries. Not all of /usr, and not /opt: courses and submissions may lie there.
const std::vector<const char*> kToolchain = {"/usr/bin",
                                             "/usr/include",
                                             "/usr/lib",
                                             "/usr/lib32",
                                             "/usr/lib64",
                                             "/usr/libx32",
                                             "/usr/libexec",
                                             "/usr/local/bin",
                                             "/usr/local/include",
                                             "/usr/local/lib",
                                             "/usr/local/lib64",
                                             "/usr/local/libexec",
                                             "/bin",
                                             "/lib",
                                             "/lib32",
                                             "/lib64",
                                             "/libx32",
                                             "/nix/store",
                                             "/gnu/store",
                                             "/etc/alternatives",
                                             "/etc/ld.so.cache"};

// PATH is the caller's own: whoever can change it can do all that the caller can.
std::string findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  const std::string all = path ? path : "/usr/bin:/bin";
  for (std::size_t from = 0; from <= all.size();) {
    const auto end = std::min(all.find(':', from), all.size());
    const std::string file = all.substr(from, end - from) + "/" + name;
    if (file[0] == '/' && access(file.c_str(), X_OK) == 0) return file;
    from = end + 1;
  }
  return "";
}

bool isBelow(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  static_cast<void>(rest);
  return end == folder.end();
}

// Can uid 65534 get there, and read it?
bool openToAll(const fs::path& path, bool read) {
  struct stat entry {};
  for (fs::path above = path.parent_path(); above.has_relative_path();
       above = above.parent_path()) {
    if (stat(above.c_str(), &entry) != 0 || !(entry.st_mode & S_IXOTH)) return false;
  }
  if (!read) return true;
  if (stat(path.c_str(), &entry) != 0 || !(entry.st_mode & S_IROTH)) return false;
  return !S_ISDIR(entry.st_mode) || (entry.st_mode & S_IXOTH);
}

// What is seen inside, in the order in which it is mounted.
std::vector<Place> placesOf(const Confinement& confinement) {
  std::vector<Place> places;
  auto add = [&](Place::Kind kind, const fs::path& from, const fs::path& to) {
    if (!from.is_absolute() || !to.is_absolute() || !fs::exists(from))
      throw std::invalid_argument("the sandbox cannot show " + from.string() + " as " +
                                  to.string());
    places.push_back({.kind = kind,
                      .from = from.lexically_normal().string(),
                      .to = to.lexically_normal().string(),
                      .folder = fs::is_directory(from)});
  };
  if (confinement.toolchain) {
    for (const char* folder : kToolchain) {
      std::error_code none;
      const auto status = fs::symlink_status(folder, none);
      if (fs::is_symlink(status)) {
        places.push_back({.kind = Place::link,
                          .from = fs::read_symlink(folder).string(),
                          .to = folder,
                          .folder = false});
      } else if (fs::exists(status)) {
        add(Place::readable, folder, folder);
      }
    }
    for (const auto& folder : confinement.hidden) {
      const bool seen = std::any_of(kToolchain.begin(), kToolchain.end(),
                                    [&](const char* of) { return isBelow(folder, of); });
      if (seen) add(Place::hidden, folder, folder);
    }
  }
  for (const auto& path : confinement.readable) add(Place::readable, path, path);
  for (const auto& [from, to] : confinement.shown) add(Place::readable, from, to);
  for (const auto& path : confinement.writable) add(Place::writable, path, path);
  return places;
}

// A folder over which the new root is mounted: any that nothing is taken from.
std::string freeFolder(const std::vector<Place>& places) {
  for (const char* folder : {"/mnt", "/media", "/srv", "/opt", "/tmp"}) {
    std::error_code none;
    const bool taken = std::any_of(places.begin(), places.end(),
                                   [&](const Place& p) { return isBelow(p.from, folder); });
    if (!taken && fs::is_directory(folder, none)) return folder;
  }
  throw std::invalid_argument("the sandbox finds no folder for its root");
}

std::vector<std::string> bubblewrapWords(const Command& command, const std::vector<Place>& places) {
  // No --new-session: the group is the caller's to kill, and has no terminal already.
  std::vector<std::string> words = {
      findProgram("bwrap"), "--unshare-all", "--die-with-parent", "--cap-drop", "ALL",
      "--hostname",         "sandbox"};
  auto add = [&](std::initializer_list<std::string> more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  for (const auto& place : places) {
    switch (place.kind) {
      case Place::readable:
        add({"--ro-bind", place.from, place.to});
        break;
      case Place::writable:
        add({"--bind", place.from, place.to});
        break;
      case Place::hidden:
        add({"--tmpfs", place.to});
        break;
      case Place::link:
        add({"--symlink", place.from, place.to});
        break;
    }
  }
  // What is memory, the root too, nobody may fill.
  for (const auto& place : places) {
    if (place.kind == Place::hidden) add({"--remount-ro", place.to});
  }
  add({"--remount-ro", "/", "--chdir", command.directory.empty() ? "/" : command.directory});
  if (command.shutIn) add({"--seccomp", std::to_string(3 + command.files.size())});
  words.push_back("--");
  words.insert(words.end(), command.words.begin(), command.words.end());
  return words;
}

Finished runTrue(const Sandbox& sandbox) {
  Command command;
  command.words = {"/usr/bin/true"};
  command.limits = {.wallSeconds = 5, .cpuSeconds = 2};
  Confinement confinement;
  confinement.toolchain = true;
  return run(confined(command, confinement, sandbox));
}

// The tier, if it works; otherwise the reason.
std::optional<Sandbox> tryTier(Tier tier, std::string& reason) {
  Sandbox sandbox;
  sandbox.tier = tier;
  if (tier == Tier::bubblewrap && findProgram("bwrap").empty()) {
    reason = "not installed";
    return std::nullopt;
  }
  auto attempt = [&](bool nobody, bool self) {
    Sandbox one = sandbox;
    one.asNobody = nobody;
    one.asSelf = self;
    const auto done = runTrue(one);
    if (!done.ok()) {
      reason = done.output.empty() ? done.end : done.output.substr(0, done.output.find('\n'));
      if (reason.starts_with("bwrap: ")) reason.erase(0, 7);
    }
    return done.ok();
  };
  if (geteuid() != 0) {
    sandbox.asSelf = attempt(false, true);
  } else if (tier == Tier::namespaces) {
    // Root makes them with its own rights before it gives them up; where it may not, uid 65534 tries.
    sandbox.asSelf = attempt(true, true);
    sandbox.asNobody = sandbox.asSelf || attempt(true, false);
  } else {
    sandbox.asNobody = attempt(true, false);
    sandbox.asSelf = attempt(false, true);
  }
  if (!sandbox.asNobody && !sandbox.asSelf) return std::nullopt;
  return sandbox;
}

}  // namespace

const char* nameOf(Tier tier) {
  switch (tier) {
    case Tier::bubblewrap:
      return "bubblewrap";
    case Tier::namespaces:
      return "namespaces";
    case Tier::limits:
      return "limits";
  }
  return "";
}

const std::vector<Sandbox>& sandboxes() {
  static const std::vector<Sandbox> all = [] {
    std::vector<Sandbox> found;
    std::string why;
    for (const Tier tier : {Tier::bubblewrap, Tier::namespaces, Tier::limits}) {
      std::string reason;
      auto sandbox = tryTier(tier, reason);
      if (!sandbox && tier == Tier::limits) sandbox = Sandbox{};
      if (sandbox) {
        sandbox->why = why;
        found.push_back(*sandbox);
      }
      if (!why.empty()) why += "; ";
      why += std::string(nameOf(tier)) + ": " + (sandbox ? "works" : reason);
    }
    return found;
  }();
  return all;
}

Sandbox bestSandbox() {
  return sandboxes().front();
}

std::string describe(const Sandbox& sandbox) {
  std::string text = nameOf(sandbox.tier);
  if (!sandbox.why.empty()) text += " (" + sandbox.why + ")";
  return text;
}

bool works(const Sandbox& sandbox) {
  return runTrue(sandbox).ok();
}

Command confined(Command command, const Confinement& confinement, const Sandbox& sandbox) {
  const auto places = placesOf(confinement);
  Enclosure& enclosure = command.enclosure;
  enclosure.any = true;
  enclosure.nobody = geteuid() == 0 && sandbox.asNobody;
  // Where uid 65534 does not get to the files, root without rights does.
  if (sandbox.asSelf && !std::all_of(places.begin(), places.end(), [](const Place& p) {
        return p.kind == Place::link || p.kind == Place::hidden ||
               openToAll(p.from, p.kind == Place::readable);
      })) {
    enclosure.nobody = false;
  }
  if (enclosure.nobody) {
    for (const auto& folder : confinement.writable) {
      if (chown(folder.c_str(), kNobody, kNobody) != 0)
        throw std::invalid_argument("the sandbox cannot give away " + folder.string());
    }
  } else {
    // It would count everything else that this user runs.
    command.limits.processes = 0;
  }
  if (sandbox.tier == Tier::bubblewrap) {
    command.words = bubblewrapWords(command, places);
    command.filtered = command.shutIn;
    command.shutIn = false;
    command.directory.clear();
    return command;
  }
  enclosure.directory = command.directory;
  command.directory.clear();
  if (sandbox.tier == Tier::namespaces) {
    enclosure.namespaces = true;
    enclosure.userNamespace = geteuid() != 0 || !sandbox.asSelf;
    enclosure.places = places;
    enclosure.base = freeFolder(places);
    if (enclosure.directory.empty()) enclosure.directory = "/";
  }
  return command;
}

}  // namespace carom::grading

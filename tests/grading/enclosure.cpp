#include "grading/enclosure.hpp"

#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace carom::grading {

namespace {

constexpr uid_t kNobody = 65534;

bool becomeNobody() {
  return setgroups(0, nullptr) == 0 && setresgid(kNobody, kNobody, kNobody) == 0 &&
         setresuid(kNobody, kNobody, kNobody) == 0;
}

bool writeText(const char* file, const char* text) {
  const int to = open(file, O_WRONLY | O_CLOEXEC);
  if (to < 0) return false;
  const auto size = static_cast<ssize_t>(std::strlen(text));
  const bool done = write(to, text, std::strlen(text)) == size;
  close(to);
  return done;
}

// Makes the folders above a path, and the path itself where it is to be a folder.
void makeFolders(char* path, bool last) {
  for (char* at = path + 1; *at; ++at) {
    if (*at != '/') continue;
    *at = '\0';
    mkdir(path, 0755);
    *at = '/';
  }
  if (last) mkdir(path, 0755);
}

bool readOnly(const char* path) {
#if defined(SYS_mount_setattr) && defined(MOUNT_ATTR_RDONLY)
  mount_attr attributes{};
  attributes.attr_set = MOUNT_ATTR_RDONLY | MOUNT_ATTR_NOSUID | MOUNT_ATTR_NODEV;
  if (syscall(SYS_mount_setattr, AT_FDCWD, path, 0x8000 /* AT_RECURSIVE */, &attributes,
              sizeof attributes) == 0)
    return true;
#endif
  // What the mount below already forbids may not be allowed again by whoever has no rights over it.
  struct statvfs there {};
  if (statvfs(path, &there) != 0) return false;
  unsigned long flags = MS_REMOUNT | MS_BIND | MS_RDONLY | MS_NOSUID | MS_NODEV;
  if (there.f_flag & ST_NOEXEC) flags |= MS_NOEXEC;
  if (there.f_flag & ST_NOATIME) flags |= MS_NOATIME;
  if (there.f_flag & ST_NODIRATIME) flags |= MS_NODIRATIME;
  if (there.f_flag & ST_RELATIME) flags |= MS_RELATIME;
  return mount(nullptr, path, nullptr, flags, nullptr) == 0;
}

struct Path {
  char text[PATH_MAX] = "";
  Path(const std::string& base, const std::string& to) {
    if (base.size() + to.size() + 1 > sizeof text) return;  // no path: nothing can be mounted there
    std::memcpy(text, base.data(), base.size());
    std::memcpy(text + base.size(), to.c_str(), to.size() + 1);
  }
};

bool emptied(const std::string& base, const Place& place) {
  const Path path(base, place.to);
  return mount(nullptr, path.text, nullptr, MS_REMOUNT | MS_BIND | MS_RDONLY | MS_NOSUID | MS_NODEV,
               nullptr) == 0;
}

bool show(const std::string& base, const Place& place) {
  Path path(base, place.to);
  char* to = path.text;
  switch (place.kind) {
    case Place::link:
      makeFolders(to, false);
      return symlink(place.from.c_str(), to) == 0;
    case Place::hidden:
      makeFolders(to, true);
      return mount("none", to, "tmpfs", MS_NOSUID | MS_NODEV, "size=1m,mode=755") == 0;
    case Place::readable:
    case Place::writable:
      makeFolders(to, place.folder);
      if (!place.folder) {
        const int file = open(to, O_WRONLY | O_CREAT | O_CLOEXEC, 0444);
        if (file >= 0) close(file);
      }
      if (mount(place.from.c_str(), to, nullptr, MS_BIND | MS_REC, nullptr) != 0) return false;
      return place.kind == Place::writable || readOnly(to);
  }
  return false;
}

bool newRoot(const Enclosure& e) {
  if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  const char* base = e.base.c_str();
  if (mount("none", base, "tmpfs", MS_NOSUID | MS_NODEV, "size=4m,mode=755") != 0) return false;
  for (const auto& place : e.places) {
    if (!show(e.base, place)) return false;
  }
  for (const auto& place : e.places) {
    // Only now, because what follows may have been mounted in it.
    if (place.kind == Place::hidden && !emptied(e.base, place)) return false;
  }
  // The root alone: what is mounted in it has its own rights.
  if (mount(nullptr, base, nullptr, MS_REMOUNT | MS_BIND | MS_RDONLY | MS_NOSUID | MS_NODEV,
            nullptr) != 0)
    return false;
  if (chdir(base) != 0) return false;
  // The old root comes to lie on the new one, and is taken off.
  return syscall(SYS_pivot_root, ".", ".") == 0 && umount2(".", MNT_DETACH) == 0 && chdir("/") == 0;
}

// The process outside, which a parent waits for: ends as the one inside does.
[[noreturn]] void endAs(pid_t inside) {
  closeFrom(0);
  int status = 0;
  while (waitpid(inside, &status, 0) != inside) {
  }
  if (WIFEXITED(status)) _exit(WEXITSTATUS(status));
  _exit(128 + WTERMSIG(status));
}

}  // namespace

void dropRights() {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  for (unsigned long capability = 0; capability < 64; ++capability)
    prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct none[2]{};
  syscall(SYS_capset, &header, none);
}

void closeFrom(int first) {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, first, ~0u, 0) == 0) return;
#endif
  for (int fd = first; fd < 4096; ++fd) close(fd);
}

bool enter(const Enclosure& e) {
  if (!e.any) return true;
  // Without a namespace of users, root still needs its rights to make the others.
  if (e.nobody && (!e.namespaces || e.userNamespace)) {
    if (!becomeNobody()) return false;
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  }
  if (!e.namespaces) {
    return e.directory.empty() || chdir(e.directory.c_str()) == 0;
  }
  const auto user = static_cast<unsigned>(geteuid());
  const auto group = static_cast<unsigned>(getegid());
  const int kinds = CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC | CLONE_NEWUTS;
  if (unshare(e.userNamespace ? kinds | CLONE_NEWUSER : kinds) != 0) return false;
  if (e.userNamespace) {
    char map[64];
    // A process that hides its memory may not write its own maps either; it hides again at once.
    const int dumpable = prctl(PR_GET_DUMPABLE, 0, 0, 0, 0);
    prctl(PR_SET_DUMPABLE, 1, 0, 0, 0);
    writeText("/proc/self/setgroups", "deny");
    std::snprintf(map, sizeof map, "%u %u 1", user, user);
    if (!writeText("/proc/self/uid_map", map)) return false;
    std::snprintf(map, sizeof map, "%u %u 1", group, group);
    if (!writeText("/proc/self/gid_map", map)) return false;
    prctl(PR_SET_DUMPABLE, dumpable, 0, 0, 0);
  }
  const pid_t inside = fork();
  if (inside < 0) return false;
  if (inside > 0) endAs(inside);
  // The machine's own name is nobody's business.
  if (!newRoot(e) || sethostname("sandbox", 7) != 0) return false;
  if (e.nobody && !e.userNamespace && !becomeNobody()) return false;
  dropRights();
  // After the last change of users, which cancels it.
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  return e.directory.empty() || chdir(e.directory.c_str()) == 0;
}

}  // namespace carom::grading

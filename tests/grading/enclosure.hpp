#pragma once
// How does a process shut itself in between fork and exec?
//
// Everything is decided before the fork, in sandbox.cpp; here it is only done, with system calls and nothing that
// allocates, because other threads may have held a lock when the process was copied.

#include <string>
#include <vector>

namespace carom::grading {

/// Something that a process sees in its own namespace of files.
struct Place {
  enum Kind { readable, writable, hidden, link };
  Kind kind = readable;
  std::string from;     ///< outside; for a link what it points to
  std::string to;       ///< inside
  bool folder = false;  ///< else a file
};

/// What a process does between fork and exec to shut itself in. Made by confined() in sandbox.hpp.
struct Enclosure {
  bool any = false;            ///< false: none of this
  bool nobody = false;         ///< root becomes uid 65534
  bool namespaces = false;     ///< namespaces are made here; else by a program, or there are none
  bool userNamespace = false;  ///< the rights for that come from a namespace of users
  std::string base;  ///< an existing folder, over which the new root is mounted before it is one
  std::string directory;  ///< where to run, inside
  std::vector<Place> places;
};

/// Enters an enclosure: for the child between fork and exec, allocates nothing. Where processes get a namespace of
/// their own it returns in a new process, and the one that called it waits for that, and ends as it ends.
/// \return false when the system refuses
bool enter(const Enclosure& enclosure);

/// Gives up every right of root, and the way to new ones.
void dropRights();

/// Closes every file descriptor from this one on.
void closeFrom(int first);

}  // namespace carom::grading

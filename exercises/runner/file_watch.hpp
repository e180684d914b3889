#pragma once
// Has a file been saved? Found out by reading it, again and again.
//
// Notification (inotify) does not cross the borders that students work across: Windows' files seen from WSL, a folder
// mounted into a container, a network drive. Times do not help either: some file systems keep them to 2 s, and the
// clock of a server may be ahead or behind. So what is compared is the content. A file of an exercise has a few
// kilobytes; reading it four times a second costs less than drawing the cursor.
//
// Editors save in several ways: over the old file, which is empty or half written for a moment; or beside it with a
// new name that is then given to it, so that the file is gone for a moment. Both settle: a change counts when two
// looks in a row have found the same.

#include <chrono>
#include <optional>
#include <string>

namespace carom::runner {

class FileWatch {
 public:
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::milliseconds;

  enum class Seen {
    nothing,
    changed,  ///< saved with another content, and settled
    gone      ///< not there for more than a second; said once
  };

  /// \param content what the file holds when the watch begins; nothing where there is none
  FileWatch(const std::optional<std::string>& content, Clock::time_point now);

  /// Takes a look.
  /// \param content what the file holds now; nothing where there is none
  /// \param now when
  /// \param cost how long it took to find out
  Seen look(const std::optional<std::string>& content, Clock::time_point now,
            Milliseconds cost = {});

  /// How long to wait before the next look: short while a change settles or somebody is at work, longer in a
  /// pause, and never more than a twentieth of the time for reading from a slow drive.
  Milliseconds wait(Clock::time_point now) const;

 private:
  std::string accepted_;    // hash of the content that has been reported
  std::string candidate_;   // of another one, seen once
  Clock::time_point last_;  // when something changed
  std::optional<Clock::time_point> missing_;
  bool saidGone_ = false;
  Milliseconds cost_{0};
};

}  // namespace carom::runner

// Watching a file by its content: what editors, slow drives and clocks do to it, and that it is quick and cheap.

#include "runner/file_watch.hpp"

#include <array>

#include "support/catch.hpp"

using carom::runner::FileWatch;
using Seen = FileWatch::Seen;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

namespace {

// A file and a clock that do what a test wants.
struct Desk {
  FileWatch::Clock::time_point now{};
  std::optional<std::string> file = "old";
  FileWatch watch{file, now};

  Seen look(milliseconds later = milliseconds(200), milliseconds cost = milliseconds(0)) {
    now += later;
    return watch.look(file, now, cost);
  }
};

}  // namespace

TEST_CASE("a file that nobody saves is never checked again") {
  Desk desk;
  for (int i = 0; i < 50; ++i) CHECK(desk.look() == Seen::nothing);
}

TEST_CASE("a change counts when it has settled, once") {
  Desk desk;
  desk.file = "new";
  CHECK(desk.look() == Seen::nothing);
  CHECK(desk.watch.wait(desk.now) <= milliseconds(50));
  CHECK(desk.look() == Seen::changed);
  CHECK(desk.look() == Seen::nothing);
}

TEST_CASE("an editor that writes over the file is waited for until it has written everything") {
  Desk desk;
  for (const char* part : {"", "ne", "new co"}) {
    desk.file = part;
    CHECK(desk.look() == Seen::nothing);
  }
  desk.file = "new content";
  CHECK(desk.look() == Seen::nothing);
  CHECK(desk.look() == Seen::changed);
}

TEST_CASE("an editor that gives the file's name to another file is no loss") {
  Desk desk;
  desk.file.reset();
  CHECK(desk.look() == Seen::nothing);
  desk.file = "old";
  CHECK(desk.look() == Seen::nothing);
  CHECK(desk.look() == Seen::nothing);
  desk.file.reset();
  CHECK(desk.look() == Seen::nothing);
  desk.file = "new";
  CHECK(desk.look() == Seen::nothing);
  CHECK(desk.look() == Seen::changed);
}

TEST_CASE("a file that stays away is said to be gone, once, and is seen when it comes back") {
  Desk desk;
  desk.file.reset();
  std::array<int, 3> seen{};
  for (int i = 0; i < 20; ++i) ++seen[static_cast<std::size_t>(desk.look())];
  CHECK(seen[static_cast<std::size_t>(Seen::gone)] == 1);
  CHECK(seen[static_cast<std::size_t>(Seen::changed)] == 0);
  // Even with the content that it had: the answer before was given without it.
  desk.file = "old";
  CHECK(desk.look() == Seen::nothing);
  CHECK(desk.look() == Seen::changed);
}

TEST_CASE("a change of the same length is seen: no times, no sizes are asked") {
  Desk desk;
  desk.file = "odl";
  desk.look();
  CHECK(desk.look() == Seen::changed);
}

TEST_CASE("saving what was there before is no change") {
  Desk desk;
  desk.file = "new";
  CHECK(desk.look() == Seen::nothing);
  desk.file = "old";
  CHECK(desk.look() == Seen::nothing);
  CHECK(desk.look() == Seen::nothing);
}

TEST_CASE("who is at work waits a fifth of a second, and a forgotten window looks once a second") {
  Desk desk;
  CHECK(desk.watch.wait(desk.now) == milliseconds(200));
  CHECK(desk.watch.wait(desk.now + minutes(5)) == milliseconds(500));
  CHECK(desk.watch.wait(desk.now + minutes(60)) == milliseconds(1000));
  desk.now += minutes(60);
  desk.file = "new";
  desk.look();
  desk.look();
  CHECK(desk.watch.wait(desk.now) == milliseconds(200));
}

TEST_CASE("a slow drive is asked less often, and quickly again when it is quick") {
  Desk desk;
  desk.look(milliseconds(200), milliseconds(100));
  CHECK(desk.watch.wait(desk.now) == milliseconds(2000));
  for (int i = 0; i < 60; ++i) desk.look(seconds(1), milliseconds(1));
  CHECK(desk.watch.wait(desk.now) <= milliseconds(250));
}

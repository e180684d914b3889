// Does the sandbox keep in what runs in it? Every tier that works here is asked the same questions; where the question
// could also be answered outside, it is, so that no test passes because nothing works at all.

#include "grading/sandbox.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "runner/confine.hpp"
#include "runner/text.hpp"
#include "support/catch.hpp"

using namespace carom::grading;
using carom::runner::readIfThere;
using carom_test::ContainsSubstring;
namespace fs = std::filesystem;

namespace {

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "carom_sandbox_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()));
    path = name;
    chmod(name.c_str(), 0755);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path file(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    chmod((path / name).c_str(), 0644);
    return path / name;
  }
  fs::path folder(const std::string& name) const {
    fs::create_directory(path / name);
    chmod((path / name).c_str(), 0755);
    return path / name;
  }
  fs::path path;
};

Command shell(const std::string& script) {
  Command command;
  command.words = {"/bin/sh", "-c", script};
  return command;
}

Confinement toolchain() {
  Confinement confinement;
  confinement.toolchain = true;
  return confinement;
}

Finished inside(const Sandbox& sandbox, const std::string& script,
                const Confinement& confinement = toolchain(), const Limits& limits = {}) {
  Command command = shell(script);
  command.limits = limits;
  return run(confined(command, confinement, sandbox));
}

// The tiers in which nothing is seen; says which is missing here.
std::vector<Sandbox> closedTiers() {
  std::vector<Sandbox> closed;
  for (const auto& sandbox : sandboxes()) {
    if (sandbox.tier != Tier::limits) closed.push_back(sandbox);
  }
  if (closed.size() < 2) WARN("not tried here: " << sandboxes().back().why);
  return closed;
}

}  // namespace

TEST_CASE("the tiers that work are listed, best first, with the reason why not a better one") {
  const auto& all = sandboxes();
  REQUIRE_FALSE(all.empty());
  CHECK(all.back().tier == Tier::limits);
  CHECK(bestSandbox().tier == all.front().tier);
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(describe(all[i]));
    if (i > 0) CHECK(all[i - 1].tier < all[i].tier);
    CHECK(all[i].why.empty() == (all[i].tier == Tier::bubblewrap));
    CHECK_THAT(describe(all[i]), ContainsSubstring(nameOf(all[i].tier)));
    CHECK(works(all[i]));
  }
  CHECK_THAT(all.back().why, ContainsSubstring("bubblewrap: "));
  CHECK_THAT(all.back().why, ContainsSubstring("namespaces: "));
}

TEST_CASE("confined work sees what it is shown, and nothing else") {
  const Folder folder;
  const fs::path shown = folder.file("shown", "yes\n");
  const fs::path beside = folder.file("beside", "no\n");
  const fs::path other = folder.file("other", "elsewhere\n");
  const std::string sees = "for f in " + shown.string() + " " + beside.string() +
                           " /a/new/place " CAROM_SOURCE_DIR
                           "/README.md /etc/passwd /root "
                           "/etc/hostname /proc/self/stat /dev/null /tmp /home; do "
                           "[ -e $f ] && echo $f; done; cat " +
                           shown.string() + " /a/new/place; uname -n";
  CHECK_THAT(run(shell(sees)).output, ContainsSubstring("/etc/passwd\n"));
  for (const auto& sandbox : closedTiers()) {
    INFO(describe(sandbox));
    Confinement confinement = toolchain();
    confinement.readable = {shown};
    confinement.shown = {{other, "/a/new/place"}};
    // The folder above the shown file is there, because the file has a path.
    std::string expected = shown.string() + "\n/a/new/place\n";
    if (folder.path.string().starts_with("/tmp/")) expected += "/tmp\n";
    CHECK(inside(sandbox, sees, confinement).output == expected + "yes\nelsewhere\nsandbox\n");
    CHECK(inside(sandbox, "ls " + folder.path.string(), confinement).output == "shown\n");
  }
}

TEST_CASE("a folder of the toolchain can be hidden, with something in it shown") {
  for (const auto& sandbox : closedTiers()) {
    INFO(describe(sandbox));
    Confinement confinement = toolchain();
    confinement.hidden = {"/usr/include"};
    confinement.readable = {"/usr/include/stdio.h"};
    const auto done = inside(sandbox, "ls /usr/include; echo x > /usr/include/x", confinement);
    CHECK_THAT(done.output, ContainsSubstring("stdio.h\n"));
    CHECK(done.output.find("stdlib.h") == std::string::npos);
    CHECK_FALSE(done.ok());
  }
}

TEST_CASE("confined work writes to its own folder, and nowhere else") {
  const Folder folder;
  const fs::path shown = folder.file("shown", "as it was\n");
  const fs::path out = folder.folder("out");
  for (const auto& sandbox : closedTiers()) {
    INFO(describe(sandbox));
    Confinement confinement = toolchain();
    confinement.readable = {shown};
    confinement.writable = {out};
    const auto allowed = inside(sandbox, "echo x > " + out.string() + "/new", confinement);
    CHECK(allowed.ok());
    CHECK(readIfThere(out / "new") == "x\n");
    fs::remove(out / "new");
    for (const std::string& place : {shown.string(), folder.path.string() + "/new",
                                     std::string("/usr/bin/new"), std::string("/new")}) {
      INFO(place);
      CHECK_FALSE(inside(sandbox, "echo x > " + place, confinement).ok());
      CHECK_FALSE(inside(sandbox, "mkdir " + place + ".d", confinement).ok());
    }
    CHECK_FALSE(inside(sandbox, "rm -f " + shown.string(), confinement).ok());
    CHECK_FALSE(inside(sandbox, "chmod 777 " + shown.string(), confinement).ok());
    CHECK(readIfThere(shown) == "as it was\n");
    CHECK_FALSE(fs::exists(folder.path / "new"));
    CHECK_FALSE(fs::exists("/usr/bin/new"));
  }
}

TEST_CASE("confined work has no network, not even to its own machine") {
  if (!fs::exists("/bin/bash")) {
    WARN("no bash here, which could open a connection");
    return;
  }
  const int listening = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  REQUIRE(bind(listening, reinterpret_cast<sockaddr*>(&address), size) == 0);
  REQUIRE(listen(listening, 8) == 0);
  REQUIRE(getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size) == 0);
  const std::string connect = "exec 3<>/dev/tcp/127.0.0.1/" +
                              std::to_string(ntohs(address.sin_port)) + " && echo connected";
  Command command;
  command.words = {"/bin/bash", "-c", connect};
  CHECK(run(command).output == "connected\n");
  for (const auto& sandbox : closedTiers()) {
    INFO(describe(sandbox));
    const auto done = run(confined(command, toolchain(), sandbox));
    CHECK(done.output.find("connected") == std::string::npos);
    CHECK_FALSE(done.ok());
  }
  close(listening);
}

TEST_CASE("confined work sees no process but its own") {
  const std::string reach = "kill -0 " + std::to_string(getpid()) + " && echo reached";
  CHECK(run(shell(reach)).output == "reached\n");
  for (const auto& sandbox : closedTiers()) {
    INFO(describe(sandbox));
    const auto done = inside(sandbox, reach + "; [ $$ -lt 10 ] && echo alone");
    CHECK(done.output.find("reached") == std::string::npos);
    CHECK_THAT(done.output, ContainsSubstring("alone"));
  }
}

TEST_CASE("limits hold in every tier") {
  const Folder folder;
  for (const auto& sandbox : sandboxes()) {
    INFO(describe(sandbox));
    const auto computes =
        inside(sandbox, "while :; do :; done", toolchain(), {.wallSeconds = 30, .cpuSeconds = 1});
    CHECK_FALSE(computes.ok());
    CHECK_FALSE(computes.timedOut);

    const auto waits = inside(sandbox, "sleep 300", toolchain(), {.wallSeconds = 0.3});
    CHECK(waits.timedOut);
    CHECK(waits.seconds < 10);

    const auto prints = inside(sandbox, "while :; do echo 0123456789; done", toolchain(),
                               {.wallSeconds = 10, .outputKilobytes = 8});
    CHECK(prints.tooMuchOutput);

#if !defined(__SANITIZE_ADDRESS__)
    const auto grows = inside(sandbox, "x=12345678; while :; do x=$x$x; done", toolchain(),
                              {.wallSeconds = 10, .memoryMegabytes = 64});
    CHECK_FALSE(grows.ok());
    CHECK_FALSE(grows.timedOut);
#endif

    Confinement confinement = toolchain();
    confinement.writable = {folder.folder("out")};
    const auto writes =
        inside(sandbox, "while :; do echo 0123456789; done > " + folder.path.string() + "/out/file",
               confinement, {.wallSeconds = 10, .fileKilobytes = 4});
    CHECK_FALSE(writes.ok());
    CHECK_FALSE(writes.timedOut);
    CHECK(fs::file_size(folder.path / "out/file") <= 4096);
    fs::remove_all(folder.path / "out");

    CHECK(inside(sandbox, "ulimit -c; ulimit -H -c").output == "0\n0\n");
  }
}

TEST_CASE("a bomb of processes ends") {
  if (geteuid() != 0) {
    WARN("only root can count what it starts apart from what else the user runs");
    return;
  }
  // A pipeline: for what runs in the background a shell needs /dev/null, which is not there.
  std::string bomb = "sleep 5.125";
  for (int i = 0; i < 300; ++i) bomb += " | sleep 5.125";
  for (const auto& sandbox : sandboxes()) {
    if (!sandbox.asNobody) continue;
    INFO(describe(sandbox));
    const auto done = inside(sandbox, bomb, toolchain(), {.wallSeconds = 20, .processes = 200});
    CHECK_FALSE(done.ok());
    CHECK(done.output.substr(0, 200).find("fork") != std::string::npos);
  }
}

TEST_CASE("nothing that was started inside is left when the verdict is there") {
  const auto running = [](const std::string& word) {
    std::vector<pid_t> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator("/proc", none)) {
      std::ifstream file(entry.path() / "cmdline", std::ios::binary);
      std::string line;
      std::getline(file, line, '\1');
      if (line == "sleep" + std::string(1, '\0') + word + std::string(1, '\0'))
        found.push_back(std::stoi(entry.path().filename().string()));
    }
    return found;
  };
  // Outside it is left.
  CHECK(run(shell("setsid -f sleep 302.625")).ok());
  CHECK(running("302.625").size() == 1);
  for (const pid_t left : running("302.625")) kill(left, SIGKILL);
  for (const auto& sandbox : closedTiers()) {
    INFO(describe(sandbox));
    CHECK(inside(sandbox, "setsid -f sleep 301.625; exit 0").ok());
    CHECK(inside(sandbox, "setsid -f sleep 301.625; sleep 301.625 | sleep 301.625", toolchain(),
                 {.wallSeconds = 0.5})
              .timedOut);
    // The last of them dies with its namespace, which may take the kernel a moment.
    for (int i = 0; i < 100 && !running("301.625").empty(); ++i) usleep(10000);
    CHECK(running("301.625").empty());
  }
}

TEST_CASE("open files that were not given are closed") {
  const Folder folder;
  const fs::path file = folder.file("secret", "in the open file\n");
  const int open = ::open(file.c_str(), O_RDONLY);
  REQUIRE(open >= 0);
  REQUIRE(dup2(open, 9) == 9);
  REQUIRE(lseek(open, 0, SEEK_SET) == 0);
  CHECK(run(shell("cat <&9")).output == "in the open file\n");
  for (const auto& sandbox : sandboxes()) {
    INFO(describe(sandbox));
    REQUIRE(lseek(open, 0, SEEK_SET) == 0);
    const auto done = inside(sandbox, "cat <&9");
    CHECK(done.output.find("in the open file") == std::string::npos);
    CHECK_FALSE(done.ok());
    Command given = shell("cat <&3");
    given.files = {open};
    CHECK(run(confined(given, toolchain(), sandbox)).output == "in the open file\n");
  }
  close(9);
  close(open);
}

TEST_CASE("the environment is the command's own") {
  setenv("CAROM_TEST_SECRET", "known", 1);
  for (const auto& sandbox : sandboxes()) {
    INFO(describe(sandbox));
    Command command = shell("echo $CAROM_TEST_SECRET$CAROM_TEST_GIVEN$HOME$LD_PRELOAD");
    command.environment = {"CAROM_TEST_GIVEN=given"};
    CHECK(run(confined(command, toolchain(), sandbox)).output == "given\n");
  }
  unsetenv("CAROM_TEST_SECRET");
}

TEST_CASE("the lock on system calls is kept in every tier") {
  if (systemCallFilter().empty()) {
    WARN("this system has no lock on system calls");
    return;
  }
  for (const auto& sandbox : sandboxes()) {
    INFO(describe(sandbox));
    Command command = shell("echo before; /bin/true; /bin/true; echo after");
    CHECK(run(confined(command, toolchain(), sandbox)).output == "before\nafter\n");
    command.shutIn = true;
    const auto done = run(confined(command, toolchain(), sandbox));
    CHECK_THAT(done.output, ContainsSubstring("before\n"));
    CHECK(done.output.find("after") == std::string::npos);
    CHECK_FALSE(done.ok());
  }
}

TEST_CASE("a signal inside is told in words outside") {
  for (const auto& sandbox : sandboxes()) {
    if (sandbox.tier == Tier::namespaces)
      continue;  // there it is the first process, which signals do not end
    INFO(describe(sandbox));
    CHECK_THAT(inside(sandbox, "kill -SEGV $$").end, ContainsSubstring("crashed"));
    CHECK_THAT(inside(sandbox, "kill -ABRT $$").end, ContainsSubstring("aborted"));
  }
  CHECK(endInside(3 << 8) == 3 << 8);
  CHECK(endInside((128 + 11) << 8) == 11);
}

TEST_CASE("a process that hides its memory, as a grader does, can start confined work") {
  auto tiers = closedTiers();
  // As root on a machine where only uid 65534 may make namespaces.
  const Sandbox other{.tier = Tier::namespaces, .why = "", .asNobody = true, .asSelf = false};
  const auto makes = [](const Sandbox& sandbox) { return sandbox.tier == Tier::namespaces; };
  if (geteuid() == 0 && std::any_of(tiers.begin(), tiers.end(), makes) && works(other))
    tiers.push_back(other);
#if !defined(__SANITIZE_ADDRESS__)
  prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
#endif
  for (const auto& sandbox : tiers) {
    INFO(describe(sandbox));
    CHECK(inside(sandbox, "echo in").output == "in\n");
  }
  prctl(PR_SET_DUMPABLE, 1, 0, 0, 0);
}

TEST_CASE("a path that cannot be shown is named") {
  for (const auto& sandbox : sandboxes()) {
    for (const char* path : {"relative/path", "/no/such/file"}) {
      Confinement confinement;
      confinement.readable = {path};
      CHECK_THROWS_WITH(confined(shell("true"), confinement, sandbox), ContainsSubstring(path));
    }
  }
}

TEST_CASE("a confined command survives being written as text") {
  for (const auto& sandbox : sandboxes()) {
    Command command = shell("echo 'a \"b\" ü'; exit 3");
    command.environment = {"A=b"};
    command = confined(command, toolchain(), sandbox);
    const Command again = fromText(toText(command));
    CHECK(toText(again) == toText(command));
    CHECK(run(again).output == "a \"b\" ü\n");
    CHECK(run(again).exitCode == 3);
  }
}

TEST_CASE("what comes out of a folder is a regular file or nothing") {
  const Folder folder;
  const fs::path secret = folder.file("secret", "not to be copied\n");
  const carom::runner::OutFolder out(folder.path);
  const fs::path target = folder.path / "taken";
  CHECK_FALSE(out.take("nothing", target));
  fs::create_symlink(secret, out.path() / "link");
  CHECK_FALSE(out.take("link", target));
  fs::create_hard_link(secret, out.path() / "second");
  CHECK_FALSE(out.take("second", target));
  fs::create_directory(out.path() / "folder");
  CHECK_FALSE(out.take("folder", target));
  CHECK(mkfifo((out.path() / "pipe").c_str(), 0644) == 0);
  CHECK_FALSE(out.take("pipe", target));
  CHECK_FALSE(fs::exists(target));
  std::ofstream(out.path() / "file") << "good\n";
  chmod((out.path() / "file").c_str(), 04777);
  CHECK(out.take("file", target));
  CHECK(readIfThere(target) == "good\n");
  CHECK((fs::status(target).permissions() & fs::perms::set_uid) == fs::perms::none);
  CHECK((fs::status(target).permissions() & fs::perms::others_write) == fs::perms::none);
}

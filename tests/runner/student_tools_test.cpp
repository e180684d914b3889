// What a student has besides `check`: test cases of his own, a debugger, a pack to hand in, output for who does not
// see it, and the settings of editors.

#include <fcntl.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <thread>

#include "course.hpp"
#include "runner/debug.hpp"
#include "runner/pack.hpp"
#include "runner/versions.hpp"

using carom_test::ContainsSubstring;
using carom_test::Course;
using carom_test::kId;
using nlohmann::json;
namespace runner = carom::runner;
namespace fs = std::filesystem;

namespace {

const std::string kCases = "03.test_aabb_overlap";
const fs::path kCasesFolder =
    fs::path(CAROM_SOURCE_DIR) / "solutions/03_detection/test_aabb_overlap";

struct CasesCourse : Course {
  CasesCourse() {
    take("03_detection/aabb_overlap");
    take("03_detection/test_aabb_overlap");
  }
  fs::path file() const {
    return root() / "exercises/03_detection/test_aabb_overlap.cpp";
  }
  json check(const std::string& content, int exitCode, std::vector<std::string> more = {}) const {
    runner::writeFile(file(), content);
    std::vector<std::string> words = {"check", kCases};
    words.insert(words.end(), more.begin(), more.end());
    return inJson(words, exitCode);
  }
};

std::string worked() {
  return runner::cutAnswer(runner::readFile(kCasesFolder / "test_aabb_overlap.cpp"), "x.cpp");
}

json statusOf(const json& result, const std::string& check) {
  for (const auto& c : result["checks"]) {
    if (c["name"] == check) return c["status"];
  }
  return nullptr;
}

const std::string kTop =
    "#include <chrono>\n#include <cstdio>\n#include <cstdlib>\n#include <fstream>\n#include "
    "<string>\n#include <unistd.h>\n"
    "#include \"carom/detection/aabb_overlap.hpp\"\n#include \"support/catch.hpp\"\n"
    "using namespace carom;\n"
    "const Aabb<3> a{{0, 0, 0}, {1, 1, 1}};\n";

bool isAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return c == '\n' || (c >= 32 && c < 127); });
}

}  // namespace

TEST_CASE("test cases that catch every wrong version pass all checks, and the skeleton none") {
  const CasesCourse course;
  const json untouched = course.inJson({"check", kCases}, 1);
  CHECK(untouched["status"] == "not started");
  CHECK(untouched["points"] == 0);
  const json done = course.check(worked(), 0);
  CHECK(done["status"] == "passed");
  CHECK(done["points"] == 9);
  CHECK(course({"solution", kCases}).exitCode == 0);
  CHECK_THAT(course({"list", "3"}).output, ContainsSubstring(kCases + ": done"));
}

TEST_CASE("a version that gets through is told as a kind of mistake, and its source is not shown") {
  const CasesCourse course;
  runner::writeFile(course.file(), runner::readFile(kCasesFolder / "wrong/06_no_beams.cpp"));
  const auto done = course({"check", kCases});
  CHECK(done.exitCode == 1);
  CHECK_THAT(done.output, ContainsSubstring("A version that overlooks some overlaps has passed") &&
                              ContainsSubstring("7 of 8 checks pass") &&
                              !ContainsSubstring("corner") && !ContainsSubstring("high("));
}

TEST_CASE("a case that fails on a right version is shown with its line, and earns nothing at all") {
  const CasesCourse course;
  const json done =
      course.check(runner::readFile(kCasesFolder / "wrong/07_touching_overlaps.cpp"), 1);
  CHECK(done["points"] == 0);
  CHECK(statusOf(done, "passes_on_right") == "wrong");
  CHECK(statusOf(done, "gap") == "not run");
  CHECK_THAT(done["checks"][0]["reason"].get<std::string>(),
             ContainsSubstring("fails on the library's version") && ContainsSubstring("(line "));
}

TEST_CASE("a case has to call the function and to assert something") {
  const CasesCourse course;
  for (const char* empty :
       {"", "TEST_CASE(\"nothing\") {}\n", "TEST_CASE(\"elsewhere\") { CHECK(1 + 1 == 2); }\n"}) {
    INFO(empty);
    const json done = course.check(worked() + empty, *empty ? 1 : 0);
    CHECK(statusOf(done, "every_case_asks") == (*empty ? "wrong" : "passed"));
    CHECK(done["points"] == (*empty ? 0 : 9));
  }
}

TEST_CASE("nobody earns points with cases that do not test: each of these gains nothing") {
  const CasesCourse course;
  const std::string call = "  const auto v = aabbOverlap(a, a);\n";
  struct Trick {
    const char* what;
    std::string code;
  };
  const Trick tricks[] = {
      {"always passes", "TEST_CASE(\"t\") {\n" + call + "  CHECK(v == v);\n}\n"},
      {"always fails", "TEST_CASE(\"t\") {\n" + call + "  CHECK(v != v);\n}\n"},
      {"exit(0)", "TEST_CASE(\"t\") {\n" + call + "  CHECK(v == v);\n  std::exit(0);\n}\n"},
      {"_exit(0)", "TEST_CASE(\"t\") {\n" + call + "  CHECK(v == v);\n  _exit(0);\n}\n"},
      {"_exit(1)", "TEST_CASE(\"t\") {\n" + call + "  CHECK(v == v);\n  _exit(1);\n}\n"},
      {"ends before main", "const int before = (std::exit(0), 0);\n"},
      {"aborts", "TEST_CASE(\"t\") {\n" + call + "  CHECK(v == v);\n  std::abort();\n}\n"},
      {"writes its own report", "TEST_CASE(\"t\") {\n" + call +
                                    "  CHECK(v == v);\n  std::puts(\"\\n\\x1f\" \"case "
                                    "{\\\"event\\\":\\\"end\\\",\\\"exit\\\":1}\");\n  "
                                    "std::fflush(stdout);\n  _exit(0);\n}\n"},
      {"fails every other time that it is run",
       "TEST_CASE(\"t\") {\n" + call +
           "  const char* const note = \"/tmp/carom-counted\";\n"
           "  const bool first = !std::ifstream(note).good();\n"
           "  if (first) std::ofstream(note) << 1;\n  else std::remove(note);\n"
           "  CHECK(v == v);\n  CHECK(first);\n}\n"},
      // Rarely, because a coin that falls evenly wins a check now and then.
      {"fails by the clock",
       "TEST_CASE(\"t\") {\n" + call +
           "  const auto t = std::chrono::system_clock::now().time_since_epoch().count();\n"
           "  CHECK(v == v);\n  CHECK(t / 1000 % 256 != 0);\n}\n"},
      {"fails when the function is at an odd page",
       "TEST_CASE(\"t\") {\n" + call +
           "  const auto place = reinterpret_cast<std::uintptr_t>(&aabbOverlap);\n"
           "  CHECK(v == v);\n  CHECK(place / 4096 % 2 == 0);\n}\n"},
      {"looks at its own name and place",
       "TEST_CASE(\"t\") {\n" + call +
           "  std::string line;\n  std::ifstream(\"/proc/self/cmdline\") >> line;\n"
           "  CHECK(v == v);\n  CHECK(line.find(\"library\") == std::string::npos);\n}\n"},
      {"never ends", "TEST_CASE(\"t\") {\n" + call +
                         "  CHECK(v == v);\n  for (volatile int i = 0;; i = i + 1) {}\n}\n"}};
  for (const auto& trick : tricks) {
    INFO(trick.what);
    runner::writeFile(course.file(), kTop + trick.code);
    // Without the screen, which refuses most of these before they run.
    const auto done =
        course({"check", kCases, "--pipe", "--no-screen", "--answer-seconds", "2", "--json"});
    INFO(done.output);
    const json result = json::parse(done.output, nullptr, false);
    REQUIRE_FALSE(result.is_discarded());
    CHECK(result["points"] == 0);
    CHECK(done.exitCode != 0);
  }
  CHECK_FALSE(fs::exists("/tmp/carom-counted"));
}

TEST_CASE("the versions travel packed, and come out as they went in") {
  const std::vector<runner::TestedVersion> versions = {{"", "int f() { return 1; } // ²\n"},
                                                       {"sign", std::string(5000, 'x') + "\n"}};
  const std::string text = runner::packed(versions);
  CHECK(text.find("return") == std::string::npos);
  const CasesCourse course;
  const fs::path file =
      course.root() / "tests/graders/03_detection/test_aabb_overlap.versions.json";
  CHECK_THAT(runner::readFile(file), !ContainsSubstring("Verdict"));
  runner::writeFile(file, "[{\"check\": \"gap\", \"packed\": \"!!\"}]");
  const auto done =
      course({"check", kCases, "--file", (kCasesFolder / "wrong/06_no_beams.cpp").string()});
  CHECK(done.exitCode == 70);
  CHECK_THAT(done.output, ContainsSubstring("is damaged"));
}

TEST_CASE("debug names the failing question and stops there in the function") {
  const Course course;
  course.write(Course::wrong("01_commuted.cpp"));
  const auto printed = course({"debug", kId, "--print"});
  CHECK(printed.exitCode == 0);
  CHECK_THAT(printed.output, ContainsSubstring("Asked: hamiltonProduct(i, j)") &&
                                 ContainsSubstring("CAROM_DEBUG_QUESTION") &&
                                 ContainsSubstring("Stops at: carom::hamiltonProduct"));
  const json session = course.inJson({"debug", kId, "--print"}, 0);
  CHECK(session["check"] == "order");
  const auto other = course({"debug", kId, "--check", "no_such_check", "--print"});
  CHECK(other.exitCode == 4);
  CHECK_THAT(other.output, ContainsSubstring("has no check 'no_such_check'"));
  // For editors: a program and a file of commands, always in the same place.
  const std::string commands = runner::readFile(fs::path(CAROM_BUILD_DIR) / "debug/commands.gdb");
  CHECK_THAT(commands, ContainsSubstring("set args order") &&
                           ContainsSubstring("break carom::hamiltonProduct"));
  CHECK(fs::exists(fs::path(CAROM_BUILD_DIR) / "debug/program"));

  if (session["installed"] == true) {
    const auto run = course({"debug", kId});
    INFO(run.output);
    // Where processes may not be looked into there is nothing to see.
    if (run.output.find("ptrace") == std::string::npos) {
      CHECK_THAT(run.output, ContainsSubstring("Breakpoint 2, carom::hamiltonProduct ("));
    }
  }
}

TEST_CASE("debug without a debugger says what to install, and with nothing wrong that nothing is") {
  const Course course;
  course.write(Course::answer());
  const auto fine = course({"debug", kId});
  CHECK(fine.exitCode == 0);
  CHECK_THAT(fine.output, ContainsSubstring("nothing to debug"));
  course.write(Course::skeleton());
  CHECK_THAT(course({"debug", kId}).output, ContainsSubstring("Not started"));
  course.write("int x = ;\n");
  CHECK(course({"debug", kId}).exitCode == 2);
  course.write(Course::wrong("02_sign_of_k.cpp"));
  // A path with everything but debuggers.
  const fs::path tools = course.root() / "tools";
  fs::create_directories(tools);
  for (const char* folder : {"/usr/bin", "/bin"}) {
    for (const auto& tool : fs::directory_iterator(folder)) {
      const std::string name = tool.path().filename().string();
      std::error_code exists;
      if (name.find("gdb") == std::string::npos && name.find("lldb") == std::string::npos)
        fs::create_symlink(tool.path(), tools / name, exists);
    }
  }
  const auto none = course.with({"PATH=" + tools.string()}, {"debug", kId});
  CHECK(none.exitCode == 4);
  CHECK_THAT(none.output,
             ContainsSubstring("apt-get install gdb") && ContainsSubstring("Command: gdb"));
}

TEST_CASE("a command is printed so that a shell reads it as it is meant") {
  CHECK(runner::shellText({"gdb", "-ex", "break a::b", "it's", ""}) ==
        "gdb -ex 'break a::b' 'it'\\''s' ''");
}

TEST_CASE("pack puts the answers and what is known of them into one file, the same each time") {
  const CasesCourse course;
  course.write(Course::answer());
  const fs::path zip = course.root() / "mine.zip";
  const auto done = course({"pack", "--out", zip.string()});
  INFO(done.output);
  REQUIRE(done.exitCode == 0);
  CHECK_THAT(done.output, ContainsSubstring("exercises/01_rotation/hamilton_product.cpp") &&
                              ContainsSubstring("test_aabb_overlap.cpp") &&
                              ContainsSubstring("not started"));
  const std::string bytes = runner::readFile(zip);
  course({"pack", "--out", zip.string()});
  CHECK(runner::readFile(zip) == bytes);

  carom::grading::Command unpack;
  unpack.words = {"cmake", "-E", "tar", "xf", zip.string()};
  unpack.directory = (course.root() / "unpacked").string();
  fs::create_directories(unpack.directory);
  REQUIRE(carom::grading::run(unpack).ok());
  const json pack = json::parse(runner::readFile(course.root() / "unpacked/carom-pack.json"));
  CHECK_FALSE(pack["carom"].get<std::string>().empty());
  REQUIRE(pack["files"].size() == 3);
  for (const auto& file : pack["files"]) {
    const std::string path = file["path"];
    const std::string content = runner::readFile(course.root() / "unpacked" / path);
    CHECK(content == runner::readFile(course.root() / path));
    CHECK(file["sha256"] == runner::sha256(content));
    CHECK(file["untouched"] == (path.find("hamilton") == std::string::npos));
  }
  CHECK(runner::sha256("abc") ==
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_CASE("nothing is packed while a file is missing or has nobody's name") {
  const CasesCourse course;
  const fs::path zip = course.root() / "mine.zip";
  fs::rename(course.root() / "exercises/01_rotation/hamilton_product.cpp",
             course.root() / "exercises/01_rotation/hamilton_prodct.cpp");
  const auto done = course({"pack", "--out", zip.string()});
  CHECK(done.exitCode == 4);
  CHECK_THAT(done.output, ContainsSubstring("is missing: ./course reset 01.hamilton_product") &&
                              ContainsSubstring("did you mean hamilton_product.cpp?"));
  CHECK_FALSE(fs::exists(zip));
  // The other chapter is in order.
  CHECK(course({"pack", "3", "--out", zip.string()}).exitCode == 0);
}

TEST_CASE("plain output is ASCII, a statement a line, and each verdict stands alone") {
  const CasesCourse course;
  for (const std::string& content :
       {Course::skeleton(), Course::answer(), Course::wrong("01_commuted.cpp"),
        std::string("int x = ;\n"), std::string("int main() {}\n")}) {
    course.write(content);
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"--plain", "check", kId}, {"--plain", "watch", kId}, {"--plain", "list"}}) {
      const auto done = course(words);
      INFO(words[1] << "\n" << done.output);
      CHECK(isAscii(done.output));
      for (const auto& line : runner::splitLines(done.output)) {
        // No columns, no indentation: except the compiler's own lines.
        CHECK((line.find("   ") == std::string::npos || content == "int x = ;\n"));
        if (line.find("check ") == 0) CHECK_THAT(line, ContainsSubstring("checking"));
      }
      if (words[1] == "list") {
        for (const auto& line : runner::splitLines(done.output))
          CHECK(std::regex_match(
              line,
              std::regex("(\\d\\d\\.\\w+: [a-z ]+\\. .*minutes\\.|\\d+ of \\d+ exercises .*)")));
      }
    }
  }
  course.write(Course::wrong("01_commuted.cpp"));
  const auto verdict = course({"check", kId}).output;
  int verdicts = 0;
  for (const auto& line : runner::splitLines(verdict)) {
    verdicts += std::regex_match(
        line, std::regex("01\\.hamilton_product, check \\d of 4, (passed|wrong): .+"));
  }
  CHECK(verdicts >= 2);
}

TEST_CASE("every exercise of the course can be listed and read aloud") {
  carom::grading::Command command;
  command.words = {CAROM_RUNNER, "--root", CAROM_SOURCE_DIR, "--build", CAROM_BUILD_DIR, "list"};
  command.limits.outputKilobytes = 4096;
  const auto list = carom::grading::run(command);
  REQUIRE(list.exitCode == 0);
  CHECK(isAscii(list.output));
  for (const auto& line : runner::splitLines(list.output)) {
    const auto colon = line.find(": ");
    if (colon == std::string::npos) continue;
    command.words.back() = "show";
    command.words.push_back(line.substr(0, colon));
    const auto show = carom::grading::run(command);
    command.words.pop_back();
    INFO(show.output);
    CHECK(show.exitCode == 0);
    CHECK(isAscii(show.output));
    CHECK_THAT(show.output, !ContainsSubstring("?m") && !ContainsSubstring("(no statement)"));
  }
}

TEST_CASE("watch sees a file that another one takes the name of, whatever its time says") {
  const Course course;
  course.write(Course::wrong("01_commuted.cpp"));
  struct stat before {};
  REQUIRE(stat(course.file().c_str(), &before) == 0);
  std::thread editor([&] {
    std::this_thread::sleep_for(std::chrono::seconds(4));
    const fs::path beside = course.root() / "saved.tmp";
    std::ofstream(beside) << Course::answer();
    // As old as the file before, as a drive that keeps seconds would have it.
    const timespec times[2] = {before.st_atim, before.st_mtim};
    utimensat(AT_FDCWD, beside.c_str(), times, 0);
    fs::rename(beside, course.file());
  });
  // The keyboard is there for a while, and then it is not.
  const auto done = course.shell("sleep 9", {"--plain", "watch", kId});
  editor.join();
  INFO(done.output);
  CHECK(done.exitCode == 0);
  CHECK_THAT(done.output, ContainsSubstring("The factors have changed places") &&
                              ContainsSubstring("All 4 public checks pass"));
}

TEST_CASE("the settings of editors name what exists") {
  const fs::path root = CAROM_SOURCE_DIR;
  auto read = [&](const char* file) {
    INFO(file);
    const json all = json::parse(runner::readFile(root / file), nullptr, false);
    REQUIRE_FALSE(all.is_discarded());
    return all;
  };
  const Course course;
  const std::string help = course({"--help"}).output;
  const json tasks = read(".vscode/tasks.json");
  std::vector<std::string> labels;
  for (const auto& task : tasks["tasks"]) {
    labels.push_back(task["label"]);
    INFO(task.dump());
    CHECK(task["command"] == "./course");
    std::string verb;
    for (const auto& word : task["args"]) {
      if (verb.empty() && !word.get<std::string>().starts_with("-")) verb = word;
    }
    CHECK_THAT(help, ContainsSubstring("\n  " + verb + " "));
    CHECK(course({verb, "--help"}).exitCode == 0);
    for (const auto& word : task["args"]) {
      const std::string option = word;
      if (option.starts_with("--"))
        CHECK_THAT(help + course({verb, "--help"}).output, ContainsSubstring(option));
    }
    // The expression for a failed check fits what check prints.
    for (const auto& matcher : task["problemMatcher"]) {
      if (!matcher.is_object()) continue;
      course.write(Course::wrong("01_commuted.cpp"));
      const std::regex pattern(matcher["pattern"]["regexp"].get<std::string>());
      std::string file;
      for (const auto& line : runner::splitLines(course({"--plain", "check", kId}).output)) {
        std::smatch match;
        if (std::regex_match(line, match, pattern)) file = match[1];
      }
      CHECK(file == "exercises/01_rotation/hamilton_product.cpp");
      if (matcher.contains("background")) {
        const auto watched = course({"--plain", "watch", kId}).output;
        for (const char* end : {"beginsPattern", "endsPattern"}) {
          const std::regex bound(matcher["background"][end].get<std::string>());
          bool found = false;
          for (const auto& line : runner::splitLines(watched))
            found |= std::regex_search(line, bound);
          CHECK(found);
        }
      }
    }
  }
  const json launch = read(".vscode/launch.json");
  for (const auto& configuration : launch["configurations"]) {
    CHECK(std::find(labels.begin(), labels.end(), configuration["preLaunchTask"]) != labels.end());
    CHECK_THAT(configuration["program"].get<std::string>(), ContainsSubstring("/debug/program"));
  }
  read(".vscode/settings.json");
  const json wanted = read(".vscode/extensions.json")["recommendations"];
  const json container = read(".devcontainer/devcontainer.json");
  CHECK(container["customizations"]["vscode"]["extensions"] == wanted);
  CHECK(fs::exists(root / ".devcontainer" / container["build"]["dockerfile"].get<std::string>()));
  CHECK(fs::exists(root / ".clangd"));
}

TEST_CASE("the container takes its packages from the one list that there is") {
  const fs::path root = CAROM_SOURCE_DIR;
  const std::string file = runner::readFile(root / ".devcontainer/Dockerfile");
  const std::regex list("sed -n '([^']*)' /tmp/course");
  std::smatch match;
  REQUIRE(std::regex_search(file, match, list));
  CHECK_THAT(file, ContainsSubstring("COPY course /tmp/course") && !ContainsSubstring("://") &&
                       !ContainsSubstring("ninja"));
  carom::grading::Command sed;
  sed.words = {"sed", "-n", match[1], (root / "course").string()};
  const auto packages = runner::words(carom::grading::run(sed).output);
  for (const char* name : {"g++", "cmake", "ninja-build", "libeigen3-dev", "doxygen"})
    CHECK(std::find(packages.begin(), packages.end(), name) != packages.end());
}

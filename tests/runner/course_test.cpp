// The course as a student meets it: the program itself, on a copy of the exercises, with every way that a check can
// end. The working tree's own exercises are never read: somebody may be working on them.

#include <sys/stat.h>

#include <thread>

#include "course.hpp"

using carom_test::ContainsSubstring;
using carom_test::Course;
using carom_test::kId;
using carom_test::kSolution;
using nlohmann::json;
namespace runner = carom::runner;
namespace fs = std::filesystem;

namespace {

std::string functionWith(const std::string& body, const std::string& before = "") {
  return "#include \"carom/rotation/hamilton_product.hpp\"\n" + before +
         "namespace carom {\n"
         "Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {\n" +
         body + "\n}\n}\n";
}

// Is a text well-formed XML? Tags nest, attributes are quoted, and every & and < is written as it must be.
bool wellFormed(const std::string& text) {
  std::vector<std::string> open;
  bool seen = false;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '&') {
      bool known = false;
      for (const char* entity : {"&lt;", "&gt;", "&amp;", "&quot;"})
        known |= text.compare(i, std::string_view(entity).size(), entity) == 0;
      if (!known) return false;
    }
    if (static_cast<unsigned char>(text[i]) < 0x20 && text[i] != '\n' && text[i] != '\t')
      return false;
    if (text[i] != '<') {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    for (bool quoted = false; end < text.size() && (quoted || text[end] != '>'); ++end) {
      if (text[end] == '"') quoted = !quoted;
      if (text[end] == '<') return false;
    }
    if (end == text.size()) return false;
    const std::string tag = text.substr(i + 1, end - i - 1);
    const std::string name =
        tag.substr(tag[0] == '/', tag.find_first_of(" /?", 1) - (tag[0] == '/'));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag[0] != '?') {
      if (open.empty() && seen) return false;
      seen = true;
      if (tag.back() != '/') open.push_back(name);
    }
    i = end + 1;
  }
  return seen && open.empty();
}

}  // namespace

TEST_CASE("the skeleton is not started, which is not wrong") {
  const Course course;
  const auto done = course({"check", kId});
  CHECK(done.exitCode == 1);
  CHECK_THAT(done.output, ContainsSubstring("not started, write your answer in "
                                            "exercises/01_rotation/hamilton_product.cpp"));
  CHECK_THAT(done.output, !ContainsSubstring("wrong"));
  const json result = course.inJson({"check", kId}, 1);
  CHECK(result["status"] == "not started");
  CHECK(result["points"] == 0);
  for (const auto& check : result["checks"]) CHECK(check["status"] == "not started");
}

TEST_CASE("a wrong answer is shown with what was asked, and its misconception by name") {
  const Course course;
  course.write(Course::wrong("01_commuted.cpp"));
  const auto done = course({"check", kId});
  CHECK(done.exitCode == 1);
  for (const char* part : {"For: q = {w = 0, x = 1, y = 0, z = 0}", "You gave", "Expected",
                           "The factors have changed places", "[matched 24 of 24 probes]",
                           "./course hint 01.hamilton_product"}) {
    CHECK_THAT(done.output, ContainsSubstring(part));
  }
  const json result = course.inJson({"check", kId}, 1);
  CHECK(result["status"] == "wrong");
  CHECK(result["misconception"]["name"] == "01_commuted");
  CHECK(result["misconception"]["probes"] == 24);
}

TEST_CASE("a wrong answer that nobody has thought of gets no name") {
  const Course course;
  course.write(functionWith("return {q.w - r.w, 1, 2, 3};"));
  const json result = course.inJson({"check", kId}, 1);
  CHECK(result["status"] == "wrong");
  CHECK_FALSE(result.contains("misconception"));
}

TEST_CASE("a crash is told with the question that it happened at") {
  const Course course;
  course.write(functionWith("*reinterpret_cast<volatile int*>(8) = 1; return q;"));
  for (const bool pipe : {false, true}) {
    std::vector<std::string> words = {"check", kId};
    if (pipe) words.push_back("--pipe");
    INFO((pipe ? "through the pipe" : "self-check"));
    const auto done = course(words);
    CHECK(done.exitCode == 3);
    CHECK_THAT(done.output, ContainsSubstring(", stopped: ") && ContainsSubstring("crashed") &&
                                ContainsSubstring("hamiltonProduct(i, i)") &&
                                ContainsSubstring("q = {w = 0, x = 1, y = 0, z = 0}"));
    const json result = course.inJson(words, 3);
    CHECK(result["checks"][0]["status"] == "stopped");
    CHECK(result["checks"][0]["failure"]["given"][0][0] == "q");
  }
}

TEST_CASE("an endless loop is stopped once, not once for every check") {
  const Course course;
  course.write(functionWith("for (volatile int i = 0;; i = i + 1) {}"));
  const auto done = course({"check", kId, "--answer-seconds", "1", "--json"});
  CHECK(done.exitCode == 3);
  const json result = json::parse(done.output);
  CHECK(result["checks"][0]["status"] == "stopped");
  CHECK(result["checks"][1]["status"] == "not run");
  CHECK_THAT(result["checks"][1]["reason"].get<std::string>(), ContainsSubstring("Not run"));
}

TEST_CASE("a file that does not compile shows its first error and a plain sentence") {
  const Course course;
  course.write(functionWith("return {q.w, r.x, 0, 0}"));
  const auto done = course({"check", kId});
  CHECK(done.exitCode == 2);
  CHECK_THAT(done.output, ContainsSubstring("does not compile") &&
                              ContainsSubstring("expected ';'") &&
                              ContainsSubstring("A semicolon is missing"));
  course.write(functionWith("return conjugated(q);"));
  const json result = course.inJson({"check", kId}, 2);
  CHECK(result["status"] == "does not compile");
  CHECK_THAT(result["compiler"]["plain"].get<std::string>(),
             ContainsSubstring("This name is not known here"));
  CHECK_THAT(result["compiler"]["error"].get<std::string>(),
             ContainsSubstring("hamilton_product.cpp:4"));
}

TEST_CASE("a file that does not define the function, or defines more, is told so") {
  const Course course;
  course.write(
      "#include \"carom/rotation/hamilton_product.hpp\"\n"
      "Quaternion_ hamiltonProduct();\n");
  CHECK(course({"check", kId}).exitCode == 2);
  course.write(
      "#include \"carom/rotation/quaternion.hpp\"\nnamespace carom {\n"
      "Quaternion hamiltonProduct(const Quaternion& q) { return q; }\n}\n");
  const auto done = course({"check", kId});
  CHECK(done.exitCode == 1);
  CHECK_THAT(done.output, ContainsSubstring("It does not define carom::hamiltonProduct"));
}

TEST_CASE(
    "an exercise that does not exist is a mistake in the command, with what was perhaps meant") {
  const Course course;
  const auto done = course({"check", "hamilton"});
  CHECK(done.exitCode == 4);
  CHECK_THAT(done.output, ContainsSubstring("there is no exercise 'hamilton'; did you mean") &&
                              ContainsSubstring(kId));
  CHECK_THAT(course({"check", "01.nothing"}).output, ContainsSubstring("./course list"));
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"check", "01.nothing"},
                                             {"show", "01.nothing"},
                                             {"hint", "01.nothing"},
                                             {"solution", "01.nothing"},
                                             {"reset", "01.nothing"},
                                             {"list", "99"},
                                             {"run", "99"},
                                             {"check", kId, "--file", "/none"}}) {
    INFO(words[0] << " " << words[1]);
    const json error = course.inJson(words, 4);
    CHECK(error["exit"] == 4);
    CHECK_FALSE(error["error"].get<std::string>().empty());
  }
  CHECK(course({"no-such-verb"}).exitCode == 4);
  CHECK(course({"check", "--no-such-option"}).exitCode == 4);
  CHECK(course({"--help"}).exitCode == 0);
}

TEST_CASE("every verb that shows something answers in JSON") {
  const Course course;
  const json list = course.inJson({"list"}, 0);
  REQUIRE(list.size() == 1);
  CHECK(list[0]["id"] == kId);
  CHECK(list[0]["status"] == "not started");
  CHECK(course.inJson({"list", "1"}, 0).size() == 1);
  const json show = course.inJson({"show", kId}, 0);
  CHECK(show["checks"].size() == 4);
  CHECK_THAT(show["statement"].get<std::string>(), ContainsSubstring("product"));
  const json hint = course.inJson({"hint", kId, "2"}, 0);
  CHECK(hint["number"] == 2);
  CHECK(hint["of"] == 3);
  const json status = course.inJson({}, 0);
  CHECK(status["done"] == 0);
  CHECK(status["next"] == kId);
  const json all = course.inJson({"check", "all"}, 1);
  CHECK(all.is_array());
  const auto doctor = course({"doctor", "--json"});
  CHECK(json::parse(doctor.output)["findings"].size() > 5);
}

TEST_CASE("a report for other programs is well-formed, whatever stands in a title") {
  const Course course;
  const fs::path ini = course.root() / "solutions/01_rotation/hamilton_product/exercise.ini";
  std::string text = runner::readFile(ini);
  const std::string title = "title = i j = k, but j i = -k";
  const auto at = text.find(title);
  REQUIRE(at != std::string::npos);
  text.replace(at, title.size(), "title = <order> & \"sense\"");
  runner::writeFile(ini, text);
  const fs::path report = course.root() / "report.xml";
  for (const std::string& content :
       {Course::wrong("01_commuted.cpp"), Course::answer(), Course::skeleton()}) {
    course.write(content);
    course({"check", kId, "--junit", report.string()});
    const std::string xml = runner::readFile(report);
    INFO(xml);
    CHECK(wellFormed(xml));
    CHECK_THAT(xml, ContainsSubstring("tests=\"4\"") &&
                        ContainsSubstring("name=\"&lt;order&gt; &amp; &quot;sense&quot;\""));
  }
  CHECK_FALSE(wellFormed("<a><b></a></b>"));
  CHECK_FALSE(wellFormed("<a>&</a>"));
  CHECK_FALSE(wellFormed("<a>"));
}

TEST_CASE("a prediction is checked, named and never given away") {
  const std::string id = "01.naive_drift";
  const fs::path solution = fs::path(CAROM_SOURCE_DIR) / "solutions/01_rotation/naive_drift";
  const Course course;
  fs::copy(solution, course.root() / "solutions/01_rotation/naive_drift",
           fs::copy_options::recursive);
  const char* const prints = "tests/graders/01_rotation/naive_drift.fingerprints.json";
  fs::copy(fs::path(CAROM_SOURCE_DIR) / prints, course.root() / prints);
  const fs::path file = course.root() / "exercises/01_rotation/naive_drift.txt";
  const std::string whole = runner::readFile(solution / "naive_drift.txt");
  const std::string answer = runner::cutAnswer(whole, "naive_drift.txt");

  runner::writeFile(file, runner::cutSkeleton(whole, "naive_drift.txt"));
  CHECK(course.inJson({"check", id}, 1)["status"] == "not started");
  runner::writeFile(file, answer);
  CHECK(course.inJson({"check", id}, 0)["points"] == 3);
  CHECK(course({"solution", id}).exitCode == 0);

  runner::writeFile(file, runner::readFile(solution / "wrong/01_full_angle.txt"));
  const auto wrong = course({"check", id});
  CHECK(wrong.exitCode == 1);
  CHECK_THAT(wrong.output, ContainsSubstring("one_step = 1.64") &&
                               ContainsSubstring("a smaller number: yours is too large") &&
                               ContainsSubstring("[matched 4 of 4 probes]") &&
                               !ContainsSubstring("1.19"));

  struct Slip {
    const char* from;
    const char* to;
    const char* says;
  };
  for (const Slip& slip :
       {Slip{"1.193", "one", "line 5: 'one' is not a number"},
        Slip{"1.193", "nan", "line 5: 'nan' is not a number"},
        Slip{"1.193", "1.193 m", "'m' follows the number, but this one has no unit"},
        Slip{"4.71e-5 s", "4.71e-5", "the number needs its unit, s"},
        Slip{"4.71e-5 s", "0.0471 ms", "the unit is 'ms', but s is asked for"},
        Slip{"one_step", "onestep", "there is no line 'one_step = ...'"}}) {
    INFO(slip.to);
    std::string text = answer;
    const auto at = text.find(slip.from, text.find("\n\n"));
    REQUIRE(at != std::string::npos);
    text.replace(at, std::string(slip.from).size(), slip.to);
    runner::writeFile(file, text);
    const auto done = course({"check", id});
    CHECK(done.exitCode == 1);
    CHECK_THAT(done.output, ContainsSubstring(slip.says));
  }
  runner::writeFile(file, std::string(1 << 20, '\0') + "one_step = ");
  CHECK(course({"check", id}).exitCode == 1);
}

TEST_CASE("hints come one after the other and the last one stays") {
  const Course course;
  for (const char* beginning : {"Hint 1 of 3", "Hint 2 of 3", "Hint 3 of 3", "Hint 3 of 3"}) {
    CHECK_THAT(course({"hint", kId}).output, ContainsSubstring(beginning));
  }
  CHECK_THAT(course({"hint", kId, "1"}).output, ContainsSubstring("Hint 1 of 3"));
  const auto tooFar = course({"hint", kId, "4"});
  CHECK(tooFar.exitCode == 4);
  CHECK_THAT(tooFar.output, ContainsSubstring("has hints 1 to 3"));
}

TEST_CASE("the solution is shown after a pass, or to who gives up") {
  const Course course;
  const auto early = course({"solution", kId});
  CHECK(early.exitCode == 1);
  CHECK_THAT(early.output, !ContainsSubstring("q.w * r.w"));
  const auto givenUp = course({"solution", kId, "--give-up"});
  CHECK(givenUp.exitCode == 0);
  CHECK_THAT(givenUp.output, ContainsSubstring("q.w * r.w") && !ContainsSubstring("//#"));

  course.write(runner::readFile(kSolution / "right/01_vector_form.cpp"));
  const auto passed = course({"check", kId});
  CHECK(passed.exitCode == 0);
  CHECK_THAT(passed.output, ContainsSubstring("All 4 public checks pass"));
  CHECK(course({"solution", kId}).exitCode == 0);
  CHECK(course.inJson({"list"}, 0)[0]["status"] == "passed");
  CHECK(course.inJson({}, 0)["done"] == 1);
  // An edit after the pass is seen.
  course.write(Course::wrong("02_sign_of_k.cpp"));
  CHECK(course.inJson({"list"}, 0)[0]["status"] == "not run");
  CHECK(course({"solution", kId}).exitCode == 1);
}

TEST_CASE("checking another file says nothing about the exercise") {
  const Course course;
  CHECK(course({"check", kId, "--file", (kSolution / "right/02_matrix.cpp").string()}).exitCode ==
        0);
  CHECK(course.inJson({"list"}, 0)[0]["status"] == "not started");
}

TEST_CASE("reset puts the skeleton back and keeps what was there") {
  const Course course;
  course.write("// my work\n");
  const auto done = course({"reset", kId});
  CHECK(done.exitCode == 0);
  CHECK(runner::readFile(course.file()) == Course::skeleton());
  const fs::path backup = course.root() / ".carom/backup";
  REQUIRE(std::distance(fs::directory_iterator(backup), {}) == 1);
  const fs::path copy = fs::directory_iterator(backup)->path();
  CHECK(runner::readFile(copy) == "// my work\n");
  CHECK_THAT(done.output, ContainsSubstring(copy.filename().string()));
  // A second reset has nothing to keep; two in one second keep two copies.
  CHECK_THAT(course({"reset", kId}).output, !ContainsSubstring("kept as"));
  for (const char* content : {"// a\n", "// b\n", "// c\n"}) {
    course.write(content);
    course({"reset", kId});
  }
  CHECK(std::distance(fs::directory_iterator(backup), {}) == 4);
  fs::remove(course.file());
  CHECK(course({"reset", kId}).exitCode == 0);
  CHECK(runner::readFile(course.file()) == Course::skeleton());
}

TEST_CASE("watch checks once and ends when there is nobody at the keyboard") {
  const Course course;
  course.write(Course::wrong("03_component_wise.cpp"));
  const auto done = course({"watch", kId});
  CHECK_FALSE(done.timedOut);
  CHECK(done.exitCode == 1);
  CHECK_THAT(done.output, ContainsSubstring("checking 01.hamilton_product ...") &&
                              ContainsSubstring("multiplied one by one") &&
                              ContainsSubstring("q to quit"));
  // Plain where there is no terminal: no colour, no cursor movement.
  CHECK_THAT(done.output, !ContainsSubstring("\033"));
}

TEST_CASE("watch with no file to watch says how to get it back") {
  const Course course;
  fs::remove(course.file());
  const auto done = course({"watch", kId});
  CHECK(done.exitCode == 4);
  CHECK_THAT(done.output, ContainsSubstring("./course reset 01.hamilton_product brings it back"));
}

TEST_CASE("damaged progress is put aside and the course goes on") {
  const Course course;
  for (const char* damaged : {"{\"01.hamil", "{\"01.hamilton_product\": [1]}", ""}) {
    INFO(damaged);
    runner::writeFile(course.root() / ".carom/state.json", damaged);
    CHECK(course.inJson({"list"}, 0)[0]["status"] == "not started");
    CHECK(course({"check", kId}).exitCode == 1);
    CHECK_FALSE(json::parse(runner::readFile(course.root() / ".carom/state.json"), nullptr, false)
                    .is_discarded());
  }
}

TEST_CASE("two checks at once do not disturb each other") {
  const Course course;
  course.write(Course::answer());
  int exitCodes[2] = {-1, -1};
  std::thread other([&] { exitCodes[0] = course({"check", kId, "--pipe"}).exitCode; });
  exitCodes[1] = course({"check", kId}).exitCode;
  other.join();
  CHECK(exitCodes[0] == 0);
  CHECK(exitCodes[1] == 0);
}

TEST_CASE("a build that is not there is said to be so") {
  carom::grading::Command command;
  command.words = {CAROM_RUNNER, "--root", CAROM_SOURCE_DIR, "--build", "/no/such/build", "list"};
  const auto done = carom::grading::run(command);
  CHECK(done.exitCode == 70);
  CHECK_THAT(done.output, ContainsSubstring("./course start"));
}

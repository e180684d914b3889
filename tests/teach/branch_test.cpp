// Branches for a course: is what students get free of answers, does the proof find one that is left, and stays what the
// teacher has as it was?

#include "runner/branch.hpp"

#include <unistd.h>

#include <algorithm>

#include "grading/process.hpp"
#include "runner/missing.hpp"
#include "runner/skeleton.hpp"
#include "support/catch.hpp"

using namespace carom::runner;
namespace grading = carom::grading;
using carom_test::ContainsSubstring;

namespace {

struct Folder {
  fs::path path;
  explicit Folder(const std::string& name)
      : path(fs::path(CAROM_BUILD_DIR) / "work" /
             ("branch-" + name + "-" + std::to_string(getpid()))) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

// An exercise in a project of one function, whose skeleton asks for three lines.
struct SmallProject {
  Folder folder{"small"};
  Exercise e;
  SmallProject() {
    e.id = "01.spin";
    e.chapter = "01_rotation";
    e.name = "spin";
    e.kind = "implement";
    e.extension = ".cpp";
    e.home = "lib/carom/rotation";
    write("solutions/01_rotation/spin/spin.cpp",
          "Real spin(Real rate, Real time) {\n"
          "  requireFinite(rate, \"rate\");\n"
          "  //# solution\n"
          "  Real angle = rate * time;  // turned so far\n"
          "  for (int i = 0; i < 3; ++i) {\n"
          "    angle -= kTurn * std::floor(angle / kTurn);\n"
          "  }\n"
          "  return angle;\n"
          "  //# stub\n"
          "  //#| return todo<Real>(\"spin\");\n"
          "  //# end\n"
          "}\n");
    write("solutions/01_rotation/spin/right/01_other.cpp",
          "Real spin(Real rate, Real time) {\n  return std::remainder(rate * time, kTurn);\n}\n");
    write("lib/carom/rotation/spin.cpp",
          "Real spin(Real rate, Real time) {\n  return wrapped(product(rate, time));\n}\n");
  }
  void write(const std::string& path, const std::string& content) const {
    writeFile(folder.path / path, content);
  }
  SecretLines secrets(const std::vector<SourceText>& texts = {}) const {
    return {folder.path, {&e}, texts};
  }
};

std::vector<std::string> textsOf(const std::vector<Leak>& leaks) {
  std::vector<std::string> all;
  for (const auto& leak : leaks) all.push_back(leak.text);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("a line of the answer is found wherever it stands, and however it is laid out") {
  const SmallProject project;
  const auto secrets = project.secrets();
  CHECK(secrets.problems().empty());
  const auto leaks =
      secrets.leaksIn("page.md",
                      "One can write\n"
                      "> angle  -= kTurn *\n>   nothing\n"
                      "- `angle -= kTurn * std::floor( angle / kTurn );` and so on\n");
  REQUIRE(leaks.size() == 1);
  CHECK(leaks[0].exercise == "01.spin");
  CHECK(leaks[0].where == "page.md");
  CHECK(leaks[0].line == 4);
  // Broken over lines, behind a comment, in another right answer and in the library's version.
  CHECK(secrets.leaksIn("a", "angle -= kTurn *\n    std::floor(angle /\n  kTurn);").size() == 1);
  CHECK(secrets.leaksIn("a", "x; Real angle = rate * time; // so").size() == 1);
  CHECK(secrets.leaksIn("a", "return std::remainder(rate * time, kTurn);").size() == 1);
  CHECK(secrets.leaksIn("a", "return wrapped(product(rate, time));").size() == 1);
  // In a value of JSON, as in a file of fingerprints.
  CHECK(secrets.leaksIn("a.json", "{\"01\": [\"angle -= kTurn * std::floor(angle / kTurn);\"]}")
            .size() == 1);
}

TEST_CASE("what the skeleton gives, and what says nothing, is no leak") {
  const SmallProject project;
  const auto secrets = project.secrets();
  CHECK(secrets.leaksIn("a", "Real spin(Real rate, Real time) { requireFinite(rate, \"rate\");")
            .empty());
  CHECK(secrets.leaksIn("a", "for (int i = 0; i < 3; ++i) {\n return angle;\n}").empty());
  CHECK(secrets.leaksIn("a", "angle -= kTurn * std::floor(turned / kTurn);").empty());
}

TEST_CASE("a page of the site is read as its reader sees it") {
  const SmallProject project;
  const auto secrets = project.secrets();
  const std::string page =
      "<div class=\"line\"><a id=\"l00012\"></a><span class=\"lineno\">   12</span>&#160; angle -= "
      "kTurn * <a href=\"x.html\">std::floor</a>(angle / kTurn);</div>";
  CHECK(textsOf(secrets.leaksInSite("html/a.html", page)) ==
        std::vector<std::string>{"angle-=kTurn*std::floor(angle/kTurn);"});
  CHECK(textOfHtml("a &lt; b &amp;&amp; <b>c</b> &gt; d &unknown; e") ==
        "a < b && c > d &unknown; e");
}

TEST_CASE("common lines are those of three files of the library; others are allowed one by one") {
  const SmallProject project;
  const std::string line = "Real angle = rate * time;\n";
  const std::vector<SourceText> two = {{"lib/a.cpp", line}, {"lib/b.cpp", line}};
  CHECK(project.secrets(two).leaksIn("page.md", line).size() == 1);
  std::vector<SourceText> three = two;
  three.push_back({"lib/c.cpp", "  Real  angle = rate * time;"});
  CHECK(project.secrets(three).leaksIn("page.md", line).empty());

  project.write("solutions/ordinary_lines.tsv",
                "# file, line, reason\nlib/a.cpp\tReal angle = rate * time;\tan angle\n");
  const auto allowed = project.secrets();
  CHECK(allowed.leaksIn("lib/a.cpp", line).empty());
  CHECK(allowed.leaksIn("page.md", line).size() == 1);

  project.write("solutions/ordinary_lines.tsv", "lib/a.cpp\tReal angle = rate * time;\t\n");
  REQUIRE(project.secrets().problems().size() == 1);
  CHECK_THAT(project.secrets().problems()[0], ContainsSubstring("ordinary_lines.tsv:1"));
}

TEST_CASE("only the last hint of the exercise itself may hold a line of its answer") {
  const SmallProject project;
  const auto secrets = project.secrets();
  const std::string line = "text = angle -= kTurn * std::floor(angle / kTurn);\n";
  const std::string path = "exercises/01_rotation/given/spin/exercise.ini";
  const std::string facts = "# facts\nid = 01.spin\n[hint.1]\n";
  CHECK(secrets.leaksIn(path, facts + "text = Think.\n[hint.2]\n" + line).empty());
  CHECK(secrets.leaksIn(path, facts + line + "[hint.2]\ntext = Think.\n").size() == 1);
  CHECK(secrets.leaksIn(path, "id = 01.other\n[hint.1]\ntext = x\n[hint.2]\n" + line).size() == 1);
}

TEST_CASE("hidden checks go with their misunderstandings and with what only they use") {
  const std::string ini =
      "id = 01.spin\npoints = 5\n\n[check.turns]\ntitle = it turns\npoints = 2\nwrong = 01_slip\n\n"
      "[check.stops]\ntitle = it stops\npoints = 3\nwrong = 02_late\n\n"
      "[wrong.01_slip]\nsays = a\ncheck = turns\n\n[wrong.02_late]\nsays = b\ncheck = stops\n\n"
      "[hint.1]\ntext = x\n";
  const std::string left = withoutChecks(ini, {"stops"});
  CHECK_THAT(left, ContainsSubstring("points = 2\n\n[check.turns]"));
  CHECK(left.find("stops") == std::string::npos);
  CHECK(left.find("02_late") == std::string::npos);
  CHECK_THAT(left, ContainsSubstring("[wrong.01_slip]"));
  CHECK_THAT(left, ContainsSubstring("[hint.1]"));
  CHECK(withoutChecks(ini, {}) == ini);

  const std::string prints =
      withoutFingerprints("{\"01_slip\": [[1, 2]], \"02_late\": [[3]]}", left);
  CHECK_THAT(prints, ContainsSubstring("01_slip"));
  CHECK(prints.find("02_late") == std::string::npos);

  const std::string grader =
      "// Grader.\n\n#include \"x.hpp\"\n\nnamespace {\n\nReal shared(Real x) {\n  return x;\n}\n\n"
      "// Only for what is hidden.\nReal deep(Real x) {\n  const Real y = x;\n\n  return "
      "shared(y);\n}"
      "\n\nReal deeper(Real x) {\n  return deep(deep(x));\n}\n\n}  // namespace\n\n"
      "TEST_CASE(\"turns\") {\n  CHECK(shared(1) == 1);\n}\n\n"
      "// Why it stops.\nTEST_CASE(\"stops\") {\n  CHECK(deeper(2) == 2);\n\n  CHECK(true);\n}\n\n"
      "TEST_CASE(\"probes\") {\n  probe(shared(3));\n}\n";
  const std::string cut = withoutTestCases(grader, {"stops"}, "spin_test.cpp");
  CHECK(cut.find("stops") == std::string::npos);
  CHECK(cut.find("deep") == std::string::npos);
  CHECK(cut.find("hidden") == std::string::npos);
  CHECK_THAT(cut, ContainsSubstring("Real shared(Real x) {\n  return x;\n}\n\n}  // namespace\n\n"
                                    "TEST_CASE(\"turns\") {"));
  CHECK_THAT(cut, ContainsSubstring("TEST_CASE(\"probes\") {\n  probe(shared(3));\n}\n"));
  CHECK_THROWS_AS(withoutTestCases(grader, {"flies"}, "spin_test.cpp"), Failure);
}

TEST_CASE("a function that is not written is told from what a program prints") {
  CHECK(missingFunction("  what():  eulerToMatrix is not written yet\n") == "eulerToMatrix");
  CHECK(missingFunction("due to unexpected exception with message:\n  not started: turnBy is not\n"
                        "  written yet") == "turnBy");
  CHECK(missingFunction("all is well").empty());
}

// From here on with the project itself: a copy of what is committed, so that nobody's work is touched.
namespace {

struct Answer {
  int exitCode = 0;
  std::string output;
};

Answer shell(const std::string& command) {
  grading::Command c;
  c.words = {"sh", "-c", command};
  c.limits = {.wallSeconds = 200, .cpuSeconds = 0, .outputKilobytes = 16 << 10};
  const auto done = grading::run(c);
  return {done.exitCode, done.output};
}

struct Copy {
  Folder folder{"copy"};
  fs::path root = folder.path / "project";
  Copy() {
    const auto done = shell(
        "git clone -q '" CAROM_SOURCE_DIR "' '" + root.string() + "' && cd '" + root.string() +
        "' && git config user.name Teacher && git config user.email t@example.org");
    INFO(done.output);
    REQUIRE(done.exitCode == 0);
  }
  Answer in(const std::string& command) const {
    return shell("cd '" + root.string() + "' && " + command);
  }
  std::string git(const std::string& command) const {
    const auto done = in("git " + command);
    INFO("git " << command << "\n" << done.output);
    REQUIRE(done.exitCode == 0);
    return trimmed(done.output);
  }
  bool has(const std::string& file) const {
    return in("git cat-file -e " + file + " 2>/dev/null").exitCode == 0;
  }
  Answer cut(const std::string& words) const {
    return in("'" CAROM_RUNNER "' --root . --build '" CAROM_BUILD_DIR "' teach branch --no-build " +
              words);
  }
  void write(const std::string& path, const std::string& content) const {
    writeFile(root / path, content);
  }
  std::string state() const {
    return git("rev-parse HEAD") + git("branch --show-current") + git("status --porcelain") +
           git("ls-files -s | git hash-object --stdin");
  }
};

bool isRepository() {
  return fs::exists(fs::path(CAROM_SOURCE_DIR) / ".git");
}

}  // namespace

TEST_CASE("branches of two weeks: no answers, no history, diffs that are the lesson") {
  if (!isRepository()) return;
  const Copy copy;
  copy.write("autumn.ini",
             "[course]\ntitle = Autumn\nwithout = 01.slerp\n[chapter 00]\ndue = 2026-11-20\n"
             "[exercise 01.hamilton_product]\nhidden = norm order\n");
  // Work that is not committed is neither touched nor cut.
  const std::string readme = readFile(copy.root / "README.md");
  copy.write("README.md", readme + "unfinished\n");
  const std::string before = copy.state();

  const auto first = copy.cut("--upto 1 --course autumn.ini --today 2026-11-20");
  INFO(first.output);
  REQUIRE(first.exitCode == 0);
  CHECK_THAT(first.output, ContainsSubstring("README.md"));
  CHECK(copy.state() == before);
  CHECK(readFile(copy.root / "README.md") == readme + "unfinished\n");

  CHECK(copy.git("rev-list --count student") == "1");
  CHECK(copy.git("show student:README.md").find("unfinished") == std::string::npos);
  for (const char* gone :
       {"solutions", "tests/unit", "tests/attacks", "tests/graders/02_mass", "chapters/02_mass",
        "docs/teachers.md", "autumn.ini", "exercises/02_mass/signed_volume.cpp",
        "lib/carom/rotation/hamilton_product.cpp", "lib/carom/mass/signed_volume.cpp",
        "chapters/01_rotation/turning_errors.cpp", "chapters/00_start/bounce_back.cpp",
        "exercises/01_rotation/slerp.cpp", "exercises/01_rotation/given/slerp"}) {
    INFO(gone);
    CHECK_FALSE(copy.has(std::string("student:") + gone));
  }
  for (const char* there :
       {"exercises/01_rotation/hamilton_product.cpp", "chapters/01_rotation/page.md",
        "exercises/01_rotation/given/hamilton_product/skeleton.cpp",
        "tests/graders/01_rotation/hamilton_product.fingerprints.json",
        "lib/carom/rotation/hamilton_product.hpp", "lib/carom/rotation/slerp.cpp",
        "exercises/02_mass/given/signed_volume/skeleton.cpp", "course"}) {
    INFO(there);
    CHECK(copy.has(std::string("student:") + there));
  }
  const std::string page = copy.git("show student:chapters/01_rotation/page.md");
  CHECK(page.find("\\answer rotation/hamilton_product.cpp") == std::string::npos);
  CHECK_THAT(page, ContainsSubstring("kept back: you write it in exercise \\ref "
                                     "exercise_01_hamilton_product"));
  CHECK(copy.git("show student:docs/index.md").find("page teachers") == std::string::npos);

  // What is hidden has no test case, no section and no misunderstanding.
  const std::string grader =
      copy.git("show student:tests/graders/01_rotation/hamilton_product_test.cpp");
  CHECK(grader.find("TEST_CASE(\"norm\")") == std::string::npos);
  CHECK(grader.find("TEST_CASE(\"order\")") == std::string::npos);
  CHECK_THAT(grader, ContainsSubstring("TEST_CASE(\"units\")"));
  const std::string facts =
      copy.git("show student:exercises/01_rotation/given/hamilton_product/exercise.ini");
  CHECK(facts.find("01_commuted") == std::string::npos);
  CHECK_THAT(facts, ContainsSubstring("\npoints = 2\n"));
  CHECK(copy.git("show student:tests/graders/01_rotation/hamilton_product.fingerprints.json")
            .find("01_commuted") == std::string::npos);

  // The difference between the tags is the answers, without a mark, and nothing else.
  std::vector<std::string> problems;
  auto exercises = readExercises(copy.root, problems);
  std::string expected;
  for (const auto& e : exercises) {
    if (e.chapter != "01_rotation" || e.id == "01.slerp") continue;
    expected += e.studentFile().string() + "\n";
    CHECK(copy.git("show ch01-solved:" + e.studentFile().string()) ==
          trimmed(cutAnswer(readFile(e.folder / e.fileName()), e.fileName())));
    CHECK(copy.git("show ch01-start:" + e.studentFile().string()) ==
          copy.git("show student:" + e.studentFile().string()));
  }
  auto lines = splitLines(expected);
  std::sort(lines.begin(), lines.end());
  CHECK(splitLines(copy.git("diff --name-only ch01-start ch01-solved")) == lines);
  CHECK(copy.git("rev-parse ch00-solved") == copy.git("rev-parse ch01-start"));
  CHECK(copy.git("rev-parse ch01-solved") == copy.git("rev-parse solved"));
  CHECK(copy.git("rev-list --count solved") == "3");
  CHECK(copy.git("rev-parse ch00-start^{tree}") == copy.git("rev-parse student^{tree}"));

  // The same again is nothing new.
  const std::string refs = copy.git("for-each-ref refs/heads refs/tags");
  const auto again = copy.cut("--upto 1 --course autumn.ini --today 2026-11-20");
  CHECK(again.exitCode == 0);
  CHECK_THAT(again.output, ContainsSubstring("nothing is new"));
  CHECK(copy.git("for-each-ref refs/heads refs/tags") == refs);

  // The next week: one commit more, with a chapter more, and the answers that are due.
  const std::string week1 = copy.git("rev-parse student");
  const auto second = copy.cut("--upto 2 --course autumn.ini --today 2026-11-21");
  INFO(second.output);
  REQUIRE(second.exitCode == 0);
  CHECK(copy.git("rev-parse student~1") == week1);
  CHECK(copy.git("rev-list --count student") == "2");
  CHECK(copy.has("student:exercises/02_mass/signed_volume.cpp"));
  CHECK_FALSE(copy.has("student:lib/carom/mass/signed_volume.cpp"));
  CHECK(copy.has("student:chapters/00_start/bounce_back.cpp"));
  CHECK(copy.has("student:exercises/00_start/given/bounce_back/why.md"));
  CHECK(copy.has("student:exercises/00_start/given/bounce_back/bounce_back.cpp"));
  CHECK_FALSE(copy.has("student:exercises/00_start/given/bounce_back/skeleton.cpp"));
  CHECK_FALSE(copy.has("student:exercises/00_start/given/bounce_back/wrong"));
  CHECK_THAT(second.output, ContainsSubstring("1 with their answers"));

  // Back to a day when it was not due: the history has shown it, and the proof says so.
  const auto back = copy.cut("--upto 2 --course autumn.ini --today 2026-11-20");
  CHECK(back.exitCode == 1);
  CHECK_THAT(back.output, ContainsSubstring("00.bounce_back"));
}

TEST_CASE("an answer that is left stops everything, wherever it is planted") {
  if (!isRepository()) return;
  const Copy copy;
  const std::string line = "  const Real planted = q.w * r.w - q.x * r.x;\n";
  const fs::path solution = copy.root / "solutions/01_rotation/hamilton_product";
  std::string answer = readFile(solution / "hamilton_product.cpp");
  const auto at = answer.find("//# solution\n");
  REQUIRE(at != std::string::npos);
  answer.insert(at + std::string("//# solution\n").size(), line);
  copy.write("solutions/01_rotation/hamilton_product/hamilton_product.cpp", answer);
  const auto append = [&](const std::string& path, const std::string& text) {
    copy.write(path, readFile(copy.root / path) + text);
  };
  append("chapters/01_rotation/page.md", "\nOne writes `" + trimmed(line) + "` there.\n");
  append("tests/graders/01_rotation/hamilton_product_test.cpp", "\n/*\n" + line + "*/\n");
  append("docs/glossary.md", "\n    const Real planted =\n        q.w * r.w - q.x * r.x;\n");
  append("lib/carom/core/real.hpp", "// " + line);
  copy.write("tests/graders/01_rotation/hamilton_product.fingerprints.json",
             "{\"01_commuted\": [[1]], \"note\": \"" + trimmed(line) + "\"}\n");
  // A whole answer under another name.
  copy.write("docs/notes.txt", readFile(solution / "wrong/01_commuted.cpp"));
  copy.git("commit -q -am planted");
  copy.git("add docs/notes.txt");
  copy.git("commit -q -m planted");
  const std::string before = copy.git("for-each-ref") + copy.state();

  const auto done = copy.cut("--upto 1");
  INFO(done.output);
  CHECK(done.exitCode == 1);
  for (const char* file :
       {"chapters/01_rotation/page.md", "tests/graders/01_rotation/hamilton_product_test.cpp",
        "docs/glossary.md", "lib/carom/core/real.hpp",
        "tests/graders/01_rotation/hamilton_product.fingerprints.json", "docs/notes.txt"}) {
    CHECK_THAT(done.output, ContainsSubstring(std::string("01.hamilton_product: ") + file));
  }
  CHECK_THAT(done.output, ContainsSubstring("No branch was written"));
  CHECK(copy.git("for-each-ref") + copy.state() == before);
}

TEST_CASE("branches of others, a branch in use and a secret in the history are refused") {
  if (!isRepository()) return;
  const Copy copy;
  copy.git("branch student");
  const auto foreign = copy.cut("--upto 0");
  CHECK(foreign.exitCode == 4);
  CHECK_THAT(foreign.output, ContainsSubstring("was not written by teach branch"));

  const auto other = copy.cut("--upto 0 --student class --solved 'a b'");
  CHECK(other.exitCode == 4);
  CHECK_THAT(other.output, ContainsSubstring("'a b' cannot be the name of a branch"));

  REQUIRE(copy.cut("--upto 0 --student class --solved answers").exitCode == 0);
  copy.git("checkout -q class");
  // The branch for students has no answers to cut from, and is not moved under their teacher.
  CHECK(copy.cut("--upto 0 --student class --solved answers").exitCode == 4);
  copy.git("checkout -q -");

  copy.write("seed.secret", "secret");
  copy.write("autumn.ini", "[course]\ntitle = Autumn\nsecret = seed.secret\n");
  copy.git("add -f seed.secret autumn.ini");
  copy.git("commit -q -m secret");
  const auto secret = copy.cut("--upto 0 --student class --solved answers --course autumn.ini");
  CHECK(secret.exitCode == 4);
  CHECK_THAT(secret.output, ContainsSubstring("seed.secret is committed"));

  CHECK(copy.cut("--today tomorrow").exitCode == 4);
  CHECK(copy.cut("--upto 77").exitCode == 4);
}

TEST_CASE("no line of an answer is left anywhere in the whole course") {
  if (!isRepository()) return;
  const Copy copy;
  const auto done = copy.cut("--out '" + (copy.folder.path / "published.git").string() + "'");
  INFO(done.output);
  CHECK(done.exitCode == 0);
  const std::string out = (copy.folder.path / "published.git").string();
  CHECK(shell("git -C '" + out + "' rev-list --count student").output == "1\n");
  CHECK_FALSE(copy.has("refs/heads/student"));
  // A clone of the students' branch has none of the objects of the other.
  const auto clone = shell("cd '" + copy.folder.path.string() +
                           "' && git clone -q --no-local --single-branch --no-tags -b student "
                           "published.git class && git -C class rev-list --objects --all | wc -l");
  INFO(clone.output);
  CHECK(clone.exitCode == 0);
  CHECK(shell("git -C '" + (copy.folder.path / "class").string() + "' cat-file -e $(git -C '" +
              out + "' rev-parse solved)")
            .exitCode != 0);
}

// A made-up class, graded from what is handed in to what is read: right and wrong answers,
// accidents, and attacks.

#include <unistd.h>

#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "grading/process.hpp"
#include "runner/failure.hpp"
#include "runner/grade_class.hpp"
#include "runner/merge.hpp"
#include "runner/records.hpp"
#include "runner/skeleton.hpp"
#include "teach/archives.hpp"
#include "teach/run_as.hpp"
#include "teach/sample.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;
using carom_test::pack;
using carom_test::Pack;
using nlohmann::json;

namespace {

const fs::path kSource = CAROM_SOURCE_DIR;
const fs::path kSolutions = kSource / "solutions/01_rotation";
const fs::path kAttacks = kSource / "tests/attacks/submissions";
const std::string kTop = "exercises/01_rotation/";

const Project& project() {
  static const Project open = openProject(kSource, CAROM_BUILD_DIR);
  return open;
}

std::string answer(const std::string& name, const std::string& extension = ".cpp") {
  const std::string file = name + extension;
  return cutAnswer(readFile(kSolutions / name / file), file);
}

std::string skeleton(const std::string& name, const std::string& extension = ".cpp") {
  const std::string file = name + extension;
  return cutSkeleton(readFile(kSolutions / name / file), file);
}

std::string wrong(const std::string& name, const std::string& which) {
  return readFile(kSolutions / name / "wrong" / which);
}

std::string product(const std::string& body) {
  return "#include \"carom/rotation/hamilton_product.hpp\"\n#include <cstdint>\nnamespace carom {\n"
         "Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {\n" +
         body + "\n}\n}\n";
}

void git(const fs::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), "git");
  carom_test::runAs({"cem", "2026-12-03T12:00:00Z"}, words, folder);
}

// The class and its course, made once for all tests, and removed at the end.
class School {
 public:
  School() {
    root_ = fs::path(CAROM_BUILD_DIR) / "work" / ("schöol " + std::to_string(getpid()));
    fs::remove_all(root_);
    writeFile(root_ / "seed.secret", "not to be guessed\n");
    writeFile(root_ / "course.ini",
              "[course]\n"
              "title = Collisions <autumn>\n"
              "chapters = 01\n"
              "without = 01.euler_to_matrix 01.matrix_to_euler 01.axis_angle_to_matrix "
              "01.axis_angle_to_quaternion 01.order_of_turns 01.renormalize "
              "01.quaternion_exponential 01.integrate_orientation 01.angle_between "
              "01.turning_errors 01.slerp\n"
              "secret = seed.secret\n"
              "[exercise 01.hamilton_product]\n"
              "due = 2026-12-01\n"
              "points = 8\n"
              "hidden = norm\n"
              "topic = properties of the product\n");

    // ann: everything right, in a zip as GitHub makes it
    pack(at("ann.zip"), Pack::zip,
         {{"carom-main/" + kTop + "hamilton_product.cpp", answer("hamilton_product")},
          {"carom-main/" + kTop + "rotate_point.cpp", answer("rotate_point")},
          {"carom-main/" + kTop + "naive_drift.txt", answer("naive_drift", ".txt")},
          {"carom-main/README.md", "mine"}});
    // ben: what was given out
    hand("ben", "hamilton_product.cpp", skeleton("hamilton_product"));
    hand("ben", "rotate_point.cpp", skeleton("rotate_point"));
    hand("ben", "naive_drift.txt", skeleton("naive_drift", ".txt"));
    // cem: known misunderstandings, in a repository, after the last day
    hand("cem", "hamilton_product.cpp", wrong("hamilton_product", "01_commuted.cpp"));
    hand("cem", "rotate_point.cpp", wrong("rotate_point", "03_nothing_normalised.cpp"));
    hand("cem", "naive_drift.txt", wrong("naive_drift", "01_full_angle.txt"));
    git(at("cem"), {"init", "-q", "-b", "main"});
    git(at("cem"), {"add", "-A"});
    git(at("cem"), {"commit", "-q", "-m", "done"});
    // dee: the same by another way
    pack(at("dee.tar.gz"), Pack::tarGz,
         {{kTop + "hamilton_product.cpp",
           readFile(kSolutions / "hamilton_product/right/02_matrix.cpp")},
          {kTop + "rotate_point.cpp",
           readFile(kSolutions / "rotate_point/right/02_cross_products.cpp")}});
    // eli: a slip of the pen, and markup in what the compiler will say
    hand("eli", "hamilton_product.cpp", product("  return q * <b>\"&r;"));
    // fay: never ends
    hand("fay", "hamilton_product.cpp", readFile(kAttacks / "endless_loop.cpp"));
    // gus: paths that lead out
    pack(at("gus.tar"), Pack::tar,
         {{kTop + "hamilton_product.cpp", answer("hamilton_product")}, {"../../gus", "x"}});
    // hal: a link to somebody else's file, and one answer of his own
    hand("hal", "rotate_point.cpp", answer("rotate_point"));
    fs::create_symlink(kSolutions / "hamilton_product/right/02_matrix.cpp",
                       at("hal") / (kTop + "hamilton_product.cpp"));
    // ivy: ends the program before it is asked
    hand("ivy", "hamilton_product.cpp", readFile(kAttacks / "exit_in_initialiser.cpp"));
    // a name that a spreadsheet would run
    hand("=1+jo|<i>", "naive_drift.txt", answer("naive_drift", ".txt"));
    // kim: twice
    hand("kim", "hamilton_product.cpp", answer("hamilton_product"));
    pack(at("kim.zip"), Pack::zip, {{kTop + "hamilton_product.cpp", answer("hamilton_product")}});
    // lou: other numbers each time, all wrong
    hand("lou", "hamilton_product.cpp",
         product("  int here = 0;\n"
                 "  const auto place = reinterpret_cast<std::uintptr_t>(&here);\n"
                 "  return {double(place % 1000003) + 0.5, q.x, r.y, 0};"));
  }
  ~School() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }

  fs::path at(const std::string& name) const {
    fs::create_directories(root_ / "class");
    return root_ / "class" / name;
  }
  fs::path out(const std::string& name) const {
    return root_ / name;
  }
  Course course() const {
    return readCourse(root_ / "course.ini", project());
  }
  GradeOptions options(const std::string& out, int jobs = 2) const {
    GradeOptions o;
    o.from = {root_ / "class"};
    o.out = root_ / out;
    o.jobs = jobs;
    o.today = "2026-12-05";
    // The sandbox has tests of its own; here grades must come out on every machine.
    o.trust = true;
    return o;
  }

 private:
  void hand(const std::string& student, const std::string& file, const std::string& content) const {
    writeFile(at(student) / (kTop + file), content);
  }
  fs::path root_;
};

// The whole class, graded once for all tests.
const School& school() {
  static const School made;
  static const int graded = gradeClass(project(), made.course(), made.options("one"));
  REQUIRE(graded == 0);
  return made;
}

std::map<std::string, std::string> filesBelow(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& file : fs::recursive_directory_iterator(folder)) {
    if (file.is_regular_file())
      all[fs::relative(file.path(), folder).string()] = readFile(file.path());
  }
  return all;
}

// Rows of a CSV file by the first cell, cells by their heading.
std::map<std::string, std::map<std::string, std::string>> rows(const fs::path& file) {
  std::vector<std::vector<std::string>> table;
  for (const auto& line : splitLines(readFile(file))) {
    auto& cells = table.emplace_back(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
        cells.back() += line[++i];
      else if (line[i] == '"')
        quoted = !quoted;
      else if (line[i] == ',' && !quoted)
        cells.emplace_back();
      else
        cells.back() += line[i];
    }
  }
  std::map<std::string, std::map<std::string, std::string>> all;
  for (std::size_t r = 1; r < table.size(); ++r) {
    REQUIRE(table[r].size() == table[0].size());
    for (std::size_t c = 0; c < table[r].size(); ++c) all[table[r][0]][table[0][c]] = table[r][c];
  }
  return all;
}

boost::property_tree::ptree xml(const fs::path& file) {
  std::istringstream in(readFile(file));
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  return tree;
}

json parsed(const fs::path& file) {
  INFO(file.string());
  json value = json::parse(readFile(file), nullptr, false);
  REQUIRE(value.is_object());
  return value;
}

const std::string kProduct = "01.hamilton_product";
const std::string kPoint = "01.rotate_point";
const std::string kDrift = "01.naive_drift";

}  // namespace

TEST_CASE("each of the class gets the points of what holds, and nothing for tricks") {
  const auto grades = rows(school().out("one") / "grades.csv");
  CHECK(grades.size() == 12);
  struct Expected {
    const char* student;
    const char* points;
    const char* state;
    const char* product;
    const char* point;
    const char* drift;
  };
  for (const auto& e : {Expected{"ann", "15", "graded", "8", "4", "3"},
                        {"ben", "0", "graded", "0", "0", "0"},
                        {"cem", "7", "graded", "4", "3", "0"},
                        {"dee", "12", "graded", "8", "4", "0"},
                        {"eli", "0", "graded", "0", "0", "0"},
                        {"fay", "0", "graded", "0", "0", "0"},
                        {"gus", "", "not taken", "", "", ""},
                        {"hal", "4", "graded", "0", "4", "0"},
                        {"ivy", "0", "graded", "0", "0", "0"},
                        {"_1_jo__i_", "3", "graded", "0", "0", "3"},
                        {"kim", "", "not taken", "", "", ""},
                        {"lou", "0", "graded", "0", "0", "0"}}) {
    INFO(e.student);
    REQUIRE(grades.count(e.student) == 1);
    const auto& row = grades.at(e.student);
    CHECK(row.at("points") == e.points);
    CHECK(row.at("of") == "15");
    CHECK(row.at("state") == e.state);
    CHECK(row.at(kProduct) == e.product);
    CHECK(row.at(kPoint) == e.point);
    CHECK(row.at(kDrift) == e.drift);
  }
  CHECK_THAT(grades.at("cem").at("misunderstood"),
             ContainsSubstring("01.hamilton_product/01_commuted") &&
                 ContainsSubstring("01.rotate_point/03_nothing_normalised") &&
                 ContainsSubstring("01.naive_drift/01_full_angle"));
  CHECK_THAT(grades.at("cem").at("remarks"), ContainsSubstring("last commit is dated 2026-12-03"));
  CHECK_THAT(grades.at("gus").at("remarks"), ContainsSubstring("leads out of its folder"));
  CHECK_THAT(grades.at("hal").at("remarks"), ContainsSubstring("is a link"));
  CHECK_THAT(grades.at("ivy").at("remarks"), ContainsSubstring("It calls exit"));
  CHECK_THAT(grades.at("kim").at("remarks"), ContainsSubstring("more than one submission"));
  CHECK(grades.at("ann").at("remarks").empty());
}

TEST_CASE(
    "the feedback tells one failure in full, names the misunderstanding, and keeps hidden what "
    "is") {
  const fs::path out = school().out("one");
  const std::string cem = readFile(out / "cem/feedback.md");
  CHECK_THAT(cem, ContainsSubstring("Expected ") && ContainsSubstring("You gave ") &&
                      ContainsSubstring("Rotations do not commute"));
  const std::string ben = readFile(out / "ben/feedback.md");
  CHECK_THAT(ben, ContainsSubstring("as it was given out"));
  CHECK_THAT(readFile(out / "eli/feedback.md"), ContainsSubstring("does not compile"));
  CHECK_THAT(readFile(out / "fay/feedback.md"), ContainsSubstring("did not end in time"));
  CHECK_THAT(readFile(out / "gus/feedback.md"), ContainsSubstring("hand it in again"));
  // The title of the hidden check, and what it asks, stand in the teacher's page and nowhere else.
  const std::string secret = "the length of a product is the product of the lengths";
  CHECK_THAT(readFile(out / "class.html"), ContainsSubstring(secret));
  for (const auto& [name, content] : filesBelow(out)) {
    if (name.starts_with("records/") || name == "class.html") continue;
    INFO(name);
    CHECK(content.find(secret) == content.npos);
  }
  CHECK_THAT(cem, ContainsSubstring("properties of the product"));
  CHECK_THAT(cem, ContainsSubstring("1 of 1 hidden checks hold"));
}

TEST_CASE("platforms can read what is written for them") {
  const fs::path out = school().out("one");
  for (const auto& [student, row] : rows(out / "grades.csv")) {
    INFO(student);
    const fs::path folder = out / student;
    const auto tree = xml(folder / "junit.xml");
    CHECK(tree.get_child("testsuites").size() > 0);

    const json gradescope = parsed(folder / "results.json");
    double sum = 0;
    for (const auto& test : gradescope.at("tests")) {
      sum += test.at("score").get<double>();
      CHECK(test.at("score") <= test.at("max_score"));
      CHECK((test.at("status") == "passed" || test.at("status") == "failed"));
      CHECK((test.at("visibility") == "visible" || test.at("visibility") == "after_published"));
      CHECK(test.at("output").is_string());
    }
    CHECK(gradescope.at("stdout_visibility") == "hidden");
    if (row.at("state") == "graded") {
      CHECK(sum == gradescope.at("score").get<double>());
      CHECK(std::to_string(static_cast<int>(sum)) == row.at("points"));
    }
    const json classroom = parsed(folder / "classroom.json");
    CHECK(classroom.at("version") == 1);
    CHECK(classroom.at("max_score") == 15);
    double earned = 0;
    for (const auto& test : classroom.at("tests")) earned += test.at("score").get<double>();
    if (row.at("state") == "graded") CHECK(earned == sum);
    CHECK(classroom.at("status") == (student == "ann"                 ? "pass"
                                     : row.at("state") == "not taken" ? "error"
                                                                      : "fail"));
  }
  int suites = 0;
  int errors = 0;
  const auto all = xml(out / "junit.xml");
  for (const auto& [tag, suite] : all.get_child("testsuites")) {
    if (tag != "testsuite") continue;
    ++suites;
    errors += suite.get<int>("<xmlattr>.errors");
  }
  CHECK(suites == 10 * 3 + 2);
  CHECK(errors == 2);
  const std::string page = readFile(out / "class.html");
  CHECK_THAT(page, ContainsSubstring("Collisions &lt;autumn&gt;") &&
                       ContainsSubstring("Rotations do not commute"));
  for (const char* never : {"<script", "http://", "https://", "src=", "<i>", "<b>"})
    CHECK(page.find(never) == page.npos);
}

TEST_CASE(
    "the same class gives the same bytes, whatever the number of jobs, and no traces of the "
    "machine") {
  const auto one = filesBelow(school().out("one"));
  REQUIRE(gradeClass(project(), school().course(), school().options("two", 1)) == 0);
  const auto two = filesBelow(school().out("two"));
  CHECK(one.size() == two.size());
  for (const auto& [name, content] : one) {
    INFO(name);
    REQUIRE(two.count(name) == 1);
    CHECK(two.at(name) == content);
    if (name.starts_with("records/files/")) continue;
    CHECK(content.find(kSource.string()) == content.npos);
    CHECK(content.find(fs::path(CAROM_BUILD_DIR).string()) == content.npos);
  }
}

TEST_CASE("a student or a check is graded anew from what was kept, and nothing else changes") {
  const fs::path out = school().out("two");
  const auto before = filesBelow(school().out("one"));
  fs::remove_all(out);
  fs::copy(school().out("one"), out, fs::copy_options::recursive);
  // Somebody changed the record of a check: grading it anew finds the truth, from the files that
  // were kept.
  json record = parsed(recordFile(out, "cem"));
  for (auto& check : record["exercises"][kProduct]["checks"]) {
    if (check["name"] == "order") check = {{"name", "order"}, {"status", "passed"}};
  }
  writeRecord(recordFile(out, "cem"), record);
  auto options = school().options("two");
  options.from.clear();
  options.only = "cem";
  options.check = kProduct + "/order";
  REQUIRE(regradeClass(project(), school().course(), options) == 0);
  CHECK(filesBelow(out) == before);
  options.check = kProduct + "/no_such_check";
  CHECK_THAT(carom_test::failureOf([&] { regradeClass(project(), school().course(), options); }),
             ContainsSubstring("has no check 'no_such_check'"));
  options.check.clear();
  options.only = "nobody";
  CHECK_THAT(carom_test::failureOf([&] { regradeClass(project(), school().course(), options); }),
             ContainsSubstring("no submission of 'nobody'"));
}

TEST_CASE("what was graded before is not graded again, and a better answer is") {
  const fs::path out = school().out("three");
  fs::remove_all(out);
  fs::copy(school().out("one"), out, fs::copy_options::recursive);
  json record = parsed(recordFile(out, "ann"));
  record["exercises"][kProduct]["notes"] = {"kept from before"};
  writeRecord(recordFile(out, "ann"), record);
  const fs::path class2 = school().out("class2");
  fs::remove_all(class2);
  writeFile(class2 / "eli/hamilton_product.cpp", answer("hamilton_product"));
  fs::copy(school().at("ann.zip"), class2 / "ann.zip");
  auto options = school().options("three");
  options.from = {class2};
  REQUIRE(gradeClass(project(), school().course(), options) == 0);
  CHECK(parsed(recordFile(out, "ann"))["exercises"][kProduct]["notes"] == json{"kept from before"});
  const auto grades = rows(out / "grades.csv");
  CHECK(grades.size() == 12);
  CHECK(grades.at("eli").at(kProduct) == "8");
  CHECK(grades.at("cem").at("points") == "7");
}

TEST_CASE("a run that was interrupted goes on where it was") {
  const fs::path out = school().out("four");
  fs::remove_all(out);
  const json done = parsed(recordFile(school().out("one"), "ann"))["exercises"][kProduct];
  json known = done;
  known["notes"] = {"from the journal"};
  // The last line is one that was being written.
  writeFile(out / "records/journal",
            json{{"student", "ann"}, {"exercise", kProduct}, {"result", known}}.dump() +
                "\n{\"student\": \"ann\", \"exer");
  auto options = school().options("four");
  options.from = {school().at("ann.zip")};
  REQUIRE(gradeClass(project(), school().course(), options) == 0);
  CHECK(parsed(recordFile(out, "ann"))["exercises"][kProduct]["notes"] == json{"from the journal"});
  CHECK_FALSE(fs::exists(out / "records/journal"));
  CHECK(rows(out / "grades.csv").at("ann").at("points") == "15");
}

TEST_CASE("grades made one by one join to the same, and differing ones do not") {
  const fs::path parts = school().out("parts");
  fs::remove_all(parts);
  for (const char* student : {"ann", "cem", "eli"}) {
    auto options = school().options("parts/" + std::string(student));
    options.from = {school().at(student == std::string("ann") ? "ann.zip" : student)};
    options.student = student;
    REQUIRE(gradeClass(project(), school().course(), options) == 0);
  }
  const fs::path joined = school().out("joined");
  REQUIRE(mergeReports({parts}, joined) == 0);
  const auto all = filesBelow(joined);
  const auto one = filesBelow(school().out("one"));
  for (const auto& [name, content] : all) {
    if (name == "grades.csv" || name == "class.html" || name == "junit.xml") continue;
    INFO(name);
    REQUIRE(one.count(name) == 1);
    CHECK(one.at(name) == content);
  }
  const auto grades = rows(joined / "grades.csv");
  CHECK(grades.size() == 3);
  CHECK(grades.at("cem") == rows(school().out("one") / "grades.csv").at("cem"));

  json record = parsed(recordFile(parts / "ann", "ann"));
  record["exercises"][kProduct]["status"] = "wrong";
  writeRecord(recordFile(parts / "ann", "ann"), record);
  CHECK_THAT(carom_test::failureOf([&] { mergeReports({parts}, joined); }),
             ContainsSubstring("graded twice, with different results") && ContainsSubstring("ann"));
  json course = parsed(parts / "eli/records/class.json");
  course["version"] = "another";
  writeRecord(parts / "eli/records/class.json", course);
  CHECK_THAT(carom_test::failureOf([&] {
               mergeReports({parts / "cem", parts / "eli"}, joined);
             }),
             ContainsSubstring("different versions"));
  CHECK_THAT(carom_test::failureOf([&] { mergeReports({school().at("ben")}, joined); }),
             ContainsSubstring("holds no records"));
}

TEST_CASE("when the grader itself is broken nobody gets a grade, and the exit code says so") {
  Project broken = project();
  broken.manifest["compiler"] = "/bin/false";
  auto options = school().options("broken");
  options.from = {school().at("ann.zip"), school().at("ben")};
  CHECK(gradeClass(broken, school().course(), options) == Exit::ourFault);
  const auto grades = rows(options.out / "grades.csv");
  for (const char* student : {"ann", "ben"}) {
    CHECK(grades.at(student).at("points").empty());
    CHECK(grades.at(student).at("state") == "not graded");
    CHECK(grades.at(student).at(kProduct) == "not graded");
    CHECK_THAT(grades.at(student).at("remarks"), ContainsSubstring("our fault"));
  }
  CHECK_THAT(readFile(options.out / "ann/feedback.md"), ContainsSubstring("fault of ours"));
  // What was our fault is graded when the grader works again.
  REQUIRE(gradeClass(project(), school().course(), options) == 0);
  CHECK(rows(options.out / "grades.csv").at("ann").at("points") == "15");
}

TEST_CASE("the program itself grades a single submission") {
  carom::grading::Command command;
  const fs::path out = school().out("single");
  command.words = {CAROM_RUNNER,
                   "--root",
                   kSource.string(),
                   "--build",
                   CAROM_BUILD_DIR,
                   "teach",
                   "grade",
                   school().at("ann.zip").string(),
                   "--student",
                   "Ann Example",
                   "--course",
                   (school().out("course.ini")).string(),
                   "--check",
                   kDrift,
                   "--trust-submissions",
                   "--out",
                   out.string()};
  command.limits = {.wallSeconds = 300, .cpuSeconds = 0, .outputKilobytes = 4096};
  const auto done = carom::grading::run(command);
  INFO(done.output);
  CHECK(done.exitCode == 0);
  const auto row = rows(out / "grades.csv").at("Ann Example");
  CHECK(row.at("points") == "3");
  CHECK(row.at("of") == "3");
}

TEST_CASE("the grader gives right versions everything, skeletons nothing, and names wrong ones") {
  // The rest of the exercises: see sample_class.cpp.
  std::vector<const Exercise*> which;
  for (const auto* id : {&kProduct, &kPoint, &kDrift}) which.push_back(&project().find(*id));
  const fs::path folder = school().out("versions");
  carom_test::writeVersions(which, folder);
  auto options = school().options("versions-graded");
  options.from = {folder};
  REQUIRE(gradeClass(project(), school().course(), options) == 0);
  const auto verdict = carom_test::judge(which, readRecords(options.out));
  for (const auto& problem : verdict.problems) {
    INFO(problem);
    CHECK(false);
  }
  CHECK(verdict.right == 3 + 2 + 2 + 1);
  CHECK(verdict.skeletons == 3);
  CHECK(verdict.wrong == 3 + 5 + 3);
}

namespace {

// The course's program as the templates call it.
fs::path courseProgram() {
  const fs::path program = school().out("course program");
  writeFile(program, "#!/bin/sh\nexec '" + std::string(CAROM_RUNNER) + "' --root '" +
                         kSource.string() + "' --build '" + CAROM_BUILD_DIR + "' \"$@\"\n");
  fs::permissions(program, fs::perms::owner_all);
  return program;
}

carom::grading::Finished script(const std::vector<std::string>& words,
                                std::vector<std::string> environment) {
  carom::grading::Command command;
  command.words = words;
  environment.push_back("CAROM_COURSE=" + courseProgram().string());
  command.environment = environment;
  command.limits = {.wallSeconds = 300, .cpuSeconds = 0, .outputKilobytes = 4096};
  return carom::grading::run(command);
}

const fs::path kTemplates = kSource / "docs/teaching/templates";

}  // namespace

TEST_CASE("the autograder for Gradescope writes what Gradescope reads") {
  const fs::path root = school().out("autograder");
  const fs::path course = root / "source/carom";
  fs::create_directories(course / "docs/teaching");
  fs::create_directory_symlink(kTemplates, course / "docs/teaching/templates");
  fs::copy(school().out("course.ini"), course / "course.ini");
  writeFile(root / "submission/rotate_point.cpp", answer("rotate_point"));
  writeFile(root / "submission_metadata.json",
            "{\"id\": 7, \"users\": [{\"id\": 1, \"email\": \"ann@example.org\",\n"
            "\"name\": \"Ann\"}], \"assignment\": {\"title\": \"x\"}}");
  const auto done = script(
      {"bash", (kTemplates / "gradescope/run_autograder").string()},
      {"AUTOGRADER=" + root.string(), "COURSE_FILE=course.ini", "COURSE_SECRET=not to be guessed"});
  INFO(done.output);
  REQUIRE(done.exitCode == 0);
  const json results = parsed(root / "results/results.json");
  CHECK(results.at("score") == 4);
  CHECK(readFile(course / "seed.secret") == "not to be guessed\n");
  // What cannot be graded leaves no results behind.
  fs::remove(root / "results/results.json");
  const auto failed = script({"bash", (kTemplates / "gradescope/run_autograder").string()},
                             {"AUTOGRADER=" + root.string(), "COURSE_FILE=none.ini"});
  CHECK(failed.exitCode == 1);
  CHECK_FALSE(fs::exists(root / "results/results.json"));
}

TEST_CASE("jobs share a class, and their reports join") {
  const fs::path handed = school().out("shared");
  for (const char* student : {"ada", "bo", "col"})
    writeFile(handed / student / "naive_drift.txt", answer("naive_drift", ".txt"));
  const fs::path parts = school().out("shares");
  for (const char* index : {"1", "2"}) {
    const auto done =
        script({"sh", (kTemplates / "grade_share.sh").string(), school().out("").string(),
                handed.string(), parts.string(), index, "2"},
               {"COURSE_FILE=course.ini", "CAROM_TRUST=yes"});
    INFO(done.output);
    REQUIRE(done.exitCode == 0);
  }
  REQUIRE(mergeReports({parts}, school().out("shares-joined")) == 0);
  const auto grades = rows(school().out("shares-joined") / "grades.csv");
  CHECK(grades.size() == 3);
  for (const auto& [student, row] : grades) CHECK(row.at(kDrift) == "3");
}

TEST_CASE("the templates' scripts parse, and name only scripts that exist") {
  int files = 0;
  for (const auto& file : fs::recursive_directory_iterator(kTemplates)) {
    if (!file.is_regular_file()) continue;
    ++files;
    const std::string content = readFile(file.path());
    INFO(file.path().string());
    // YAML knows no tabs.
    if (file.path().extension() == ".yml") CHECK(content.find('\t') == content.npos);
    if (content.starts_with("#!"))
      CHECK(script({"bash", "-n", file.path().string()}, {}).exitCode == 0);
    const std::string folder = "docs/teaching/templates/";
    for (auto at = content.find(folder); at != content.npos; at = content.find(folder, at + 1)) {
      const auto end = content.find_first_of(" \"\n", at);
      CHECK(fs::exists(kSource / content.substr(at, end - at)));
    }
  }
  CHECK(files == 8);
}

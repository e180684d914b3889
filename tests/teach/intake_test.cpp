// What students hand in, and what an enemy does: every file that is taken, and every sentence that
// says why not.

#include "runner/intake.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include "runner/failure.hpp"
#include "teach/archives.hpp"
#include "teach/run_as.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;
using carom_test::pack;
using carom_test::Pack;
using carom_test::Packed;

namespace {

const std::string kAnswer = "double product() { return 1; }\n";
const std::string kPath = "exercises/01_rotation/hamilton_product.cpp";

Exercise exercise(const char* chapter, const char* name, const char* extension = ".cpp") {
  Exercise e;
  e.id = std::string(chapter).substr(0, 2) + "." + name;
  e.chapter = chapter;
  e.name = name;
  e.extension = extension;
  return e;
}

const Exercise kProduct = exercise("01_rotation", "hamilton_product");
const Exercise kSlerp = exercise("01_rotation", "slerp");
const Exercise kDrift = exercise("01_rotation", "naive_drift", ".txt");
const std::vector<const Exercise*> kAll = {&kProduct, &kSlerp, &kDrift};

// A folder for one test, with a blank and an accent in its name.
class Folder {
 public:
  Folder() {
    path_ = fs::path(CAROM_BUILD_DIR) / "work" / ("intäke " + std::to_string(getpid()));
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path operator/(const std::string& name) const {
    return path_ / name;
  }
  const fs::path& path() const {
    return path_;
  }

 private:
  fs::path path_;
};

Submission only(const fs::path& source) {
  const auto intake = takeIn(kAll, {source}, "ann");
  REQUIRE(intake.submissions.size() == 1);
  CHECK(intake.submissions[0].student == "ann");
  return intake.submissions[0];
}

// The answer is taken, and nothing else.
void checkTaken(const Submission& s) {
  INFO(s.refusedWhole);
  CHECK(s.refusedWhole.empty());
  CHECK(s.refused.empty());
  REQUIRE(s.files.size() == 1);
  CHECK(s.files.at("01.hamilton_product") == kAnswer);
}

void checkRefused(const Submission& s, const char* why) {
  CHECK(s.files.empty());
  CHECK_THAT(s.refusedWhole, ContainsSubstring(why));
}

void run(const std::vector<std::string>& words, const fs::path& folder) {
  carom_test::runAs({"ann", "2026-11-30T12:00:00Z"}, words, folder);
}

void makeRepository(const fs::path& folder) {
  writeFile(folder / kPath, kAnswer);
  run({"git", "init", "-q", "-b", "main"}, folder);
  run({"git", "add", "-A"}, folder);
  run({"git", "commit", "-q", "-m", "answer"}, folder);
}

}  // namespace

TEST_CASE("a folder is taken as the course has it, below top folders, and flat") {
  const Folder folder;
  for (const char* path :
       {"exercises/01_rotation/hamilton_product.cpp",
        "carom-main/exercises/01_rotation/hamilton_product.cpp",
        "a/b/exercises/01_rotation/hamilton_product.cpp", "01_rotation/hamilton_product.cpp",
        "hamilton_product.cpp", "upload/hamilton_product.cpp"}) {
    INFO(path);
    writeFile(folder / "s" / path, kAnswer);
    writeFile(folder / "s" / "exercises/01_rotation/notes.txt", "mine");
    checkTaken(only(folder / "s"));
    fs::remove_all(folder / "s");
  }
}

TEST_CASE("of a whole copy of the course only the exercises are taken") {
  const Folder folder;
  writeFile(folder / kPath, kAnswer);
  writeFile(folder / "chapters/01_rotation/hamilton_product.cpp", "the chapter's");
  writeFile(folder / "lib/carom/rotation/hamilton_product.cpp", "the library's");
  writeFile(folder / "solutions/01_rotation/hamilton_product/hamilton_product.cpp", "the answer");
  checkTaken(only(folder.path()));
}

TEST_CASE("every kind of archive gives the same") {
  const Folder folder;
  for (const auto& [name, how] : {std::pair{"s.zip", Pack::zip},
                                  {"s.tar", Pack::tar},
                                  {"s.tar.gz", Pack::tarGz},
                                  {"s.tgz", Pack::tarGz},
                                  {"s.tar.xz", Pack::tarXz},
                                  {"S.ZIP", Pack::zip}}) {
    INFO(name);
    pack(folder / name, how,
         {{"carom-main/", "", AE_IFDIR},
          {"./carom-main/" + kPath, kAnswer},
          {"carom-main/x", "x"},
          {"__MACOSX/carom-main/._x", "x"}});
    checkTaken(only(folder / name));
  }
}

TEST_CASE("a student's folder with one archive in it is that archive") {
  const Folder folder;
  fs::create_directories(folder / "s");
  pack(folder / "s" / "work.zip", Pack::zip, {{kPath, kAnswer}});
  checkTaken(only(folder / "s"));
  pack(folder / "s" / "work2.zip", Pack::zip, {{kPath, kAnswer}});
  checkRefused(only(folder / "s"), "holds 2 archives");
}

TEST_CASE("names in archives that lead elsewhere are refused") {
  const Folder folder;
  for (const auto& [path, why] : {std::pair{"../" + kPath, "leads out"},
                                  {"exercises/../../../etc/passwd", "leads out"},
                                  {"/" + kPath, "absolute path"},
                                  {"C:/" + kPath, "absolute path"},
                                  {std::string("exercises/01_rotation/a\nb"), "control characters"},
                                  {std::string("exercises/\x1b[2J"), "control characters"}}) {
    for (const Pack how : {Pack::tar, Pack::zip}) {
      INFO(path);
      pack(folder / (how == Pack::tar ? "s.tar" : "s.zip"), how, {{kPath, kAnswer}, {path, "x"}});
      checkRefused(only(folder / (how == Pack::tar ? "s.tar" : "s.zip")), why);
    }
  }
}

TEST_CASE("backslashes are refused, but for a zip from Windows, where they are slashes") {
  const Folder folder;
  const std::string path = "exercises\\01_rotation\\hamilton_product.cpp";
  pack(folder / "s.tar", Pack::tar, {{path, kAnswer}});
  checkRefused(only(folder / "s.tar"), "backslash");
  pack(folder / "s.zip", Pack::zip, {{path, kAnswer}});
  checkTaken(only(folder / "s.zip"));
}

TEST_CASE("links and devices are never followed, wherever they come from") {
  const Folder folder;
  const Packed links[] = {{kPath, "", AE_IFLNK, "/etc/passwd"},
                          {kPath, "", AE_IFREG, "", "exercises/01_rotation/slerp.cpp"},
                          {kPath, "", AE_IFIFO},
                          {kPath, "", AE_IFCHR}};
  for (const auto& link : links) {
    pack(folder / "s.tar", Pack::tar, {{"exercises/01_rotation/slerp.cpp", kAnswer}, link});
    const auto s = only(folder / "s.tar");
    CHECK(s.refusedWhole.empty());
    CHECK(s.files.count("01.slerp") == 1);
    CHECK(s.files.count("01.hamilton_product") == 0);
    CHECK_THAT(s.refused.at("01.hamilton_product"), ContainsSubstring("not a file"));
  }
  // A link that is nobody's exercise is nobody's trouble: the course itself makes one.
  pack(folder / "s.zip", Pack::zip,
       {{kPath, kAnswer}, {"compile_commands.json", "", AE_IFLNK, "build/compile_commands.json"}});
  checkTaken(only(folder / "s.zip"));

  fs::create_directories(folder / "s/exercises/01_rotation");
  fs::create_symlink("/etc/passwd", folder / "s" / kPath);
  REQUIRE(mkfifo((folder / "s/exercises/01_rotation/slerp.cpp").c_str(), 0600) == 0);
  auto s = only(folder / "s");
  CHECK(s.files.empty());
  CHECK_THAT(s.refused.at("01.hamilton_product"), ContainsSubstring("is a link"));
  CHECK_THAT(s.refused.at("01.slerp"), ContainsSubstring("is not a file"));

  fs::remove_all(folder / "s");
  writeFile(folder / "elsewhere/hamilton_product.cpp", kAnswer);
  fs::create_directories(folder / "s/exercises");
  fs::create_directory_symlink(folder / "elsewhere", folder / "s/exercises/01_rotation");
  s = only(folder / "s");
  CHECK(s.files.empty());
  REQUIRE(s.notes.size() == 1);
  CHECK_THAT(s.notes[0], ContainsSubstring("is a link and is not followed"));
}

TEST_CASE("what is too large, cut off, locked or no archive is said to be so") {
  const Folder folder;
  const std::string large(300 << 10, 'x');
  pack(folder / "s.zip", Pack::zip, {{kPath, large}});
  auto s = only(folder / "s.zip");
  CHECK_THAT(s.refused.at("01.hamilton_product"), ContainsSubstring("larger than 256 kB"));
  writeFile(folder / "s" / kPath, large);
  s = only(folder / "s");
  CHECK_THAT(s.refused.at("01.hamilton_product"), ContainsSubstring("larger than 256 kB"));
  writeFile(folder / "s" / kPath, kAnswer + std::string(1, '\0'));
  s = only(folder / "s");
  CHECK_THAT(s.refused.at("01.hamilton_product"), ContainsSubstring("zero byte"));

  // A bomb: 70 MB of zeros in some kB, where no exercise is.
  pack(folder / "bomb.tar.gz", Pack::tarGz, {{kPath, kAnswer}, {"x", std::string(70 << 20, '\0')}});
  CHECK(fs::file_size(folder / "bomb.tar.gz") < 200000);
  checkRefused(only(folder / "bomb.tar.gz"), "unpacks to more than 64 MB");
  pack(folder / "bomb.zip", Pack::zip, {{kPath, kAnswer}, {"x", std::string(70 << 20, '\0')}});
  checkRefused(only(folder / "bomb.zip"), "unpacks to more than 64 MB");

  std::vector<Packed> many;
  for (int i = 0; i < 30; ++i) many.push_back({"f" + std::to_string(i), "x"});
  pack(folder / "many.tar", Pack::tar, many);
  const auto few = takeIn(kAll, {folder / "many.tar"}, "ann", {.entries = 20});
  checkRefused(few.submissions.at(0), "more than 20 files");

  std::string noise;
  for (unsigned i = 0; i < 20000; ++i) noise += static_cast<char>((i * 2654435761u) >> 24);
  for (const auto& [name, how] : {std::pair{"s.zip", Pack::zip},
                                  {"s.tar", Pack::tar},
                                  {"s.tar.gz", Pack::tarGz},
                                  {"s.tar.xz", Pack::tarXz}}) {
    INFO(name);
    pack(folder / name, how, {{kPath, noise}});
    const std::string whole = readFile(folder / name);
    for (const std::size_t part : {whole.size() / 2, std::size_t(200)}) {
      writeFile(folder / name, whole.substr(0, part));
      checkRefused(only(folder / name), "");
      CHECK_FALSE(only(folder / name).refusedWhole.empty());
    }
  }
  pack(folder / "locked.zip", Pack::zipEncrypted, {{kPath, kAnswer}});
  checkRefused(only(folder / "locked.zip"), "encrypted");
  writeFile(folder / "text.zip", "this is no archive");
  checkRefused(only(folder / "text.zip"), "damaged, or not the archive");
  writeFile(folder / "empty.zip", "");
  checkRefused(only(folder / "empty.zip"), "");
  CHECK_FALSE(only(folder / "empty.zip").refusedWhole.empty());
  writeFile(folder / "s.rar", "Rar!");
  checkRefused(only(folder / "s.rar"), "archives of this kind are not read");
}

TEST_CASE("a file that is there twice is not guessed") {
  const Folder folder;
  pack(folder / "s.tar", Pack::tar, {{kPath, kAnswer}, {kPath, "another"}});
  checkRefused(only(folder / "s.tar"), "twice");
  pack(folder / "s.zip", Pack::zip, {{kPath, kAnswer}, {"./" + kPath, "another"}});
  checkRefused(only(folder / "s.zip"), "twice");
  writeFile(folder / "s/old" / kPath, kAnswer);
  writeFile(folder / "s/new" / kPath, "another");
  writeFile(folder / "s/new/exercises/01_rotation/slerp.cpp", "slerp");
  const auto s = only(folder / "s");
  CHECK(s.files.size() == 1);
  CHECK_THAT(s.refused.at("01.hamilton_product"), ContainsSubstring("handed in twice"));
}

TEST_CASE("a git repository is taken as it was committed") {
  const Folder folder;
  makeRepository(folder / "s");
  writeFile(folder / "s" / kPath, "not committed");
  auto s = only(folder / "s");
  checkTaken(s);
  CHECK(s.date == "2026-11-30");
  run({"git", "clone", "-q", "--bare", (folder / "s").string(), (folder / "bare.git").string()},
      folder.path());
  checkTaken(only(folder / "bare.git"));
  run({"git", "gc", "-q"}, folder / "s");
  checkTaken(only(folder / "s"));
  run({"git", "bundle", "create", "-q", (folder / "s.bundle").string(), "HEAD", "main"},
      folder / "s");
  checkTaken(only(folder / "s.bundle"));
  const std::string bundle = readFile(folder / "s.bundle");
  writeFile(folder / "s.bundle", bundle.substr(0, bundle.size() / 2));
  checkRefused(only(folder / "s.bundle"), "damaged");
}

TEST_CASE("a git repository runs nothing and reads nothing that is not its own") {
  const Folder folder;
  makeRepository(folder / "s");
  const std::string touch = "touch '" + (folder / "run").string() + "'; cat";
  for (const char* key :
       {"core.fsmonitor", "core.pager", "core.sshCommand", "diff.mine.textconv",
        "filter.mine.smudge", "filter.mine.clean", "core.hooksPath", "core.gitProxy"})
    run({"git", "config", key, touch}, folder / "s");
  writeFile(folder / "s/.gitattributes", "* diff=mine filter=mine\n");
  writeFile(folder / "s/.git/info/attributes", "* diff=mine filter=mine\n");
  checkTaken(only(folder / "s"));
  CHECK_FALSE(fs::exists(folder / "run"));

  writeFile(folder / "s/.git/objects/info/alternates", "/somewhere/objects\n");
  checkRefused(only(folder / "s"), "borrows objects");
  fs::remove(folder / "s/.git/objects/info/alternates");
  fs::create_symlink("/etc/passwd", folder / "s/.git/refs/heads/link");
  checkRefused(only(folder / "s"), "holds links");
  fs::remove(folder / "s/.git/refs/heads/link");
  writeFile(folder / "s/.git/HEAD", "ref: refs/heads/../../../../secret\n");
  checkRefused(only(folder / "s"), "names no branch");
  writeFile(folder / "s/.git/HEAD", "ref: refs/heads/none\n");
  checkRefused(only(folder / "s"), "holds no commit");
  fs::rename(folder / "s/.git", folder / "git");
  writeFile(folder / "s/.git", "gitdir: ../git\n");
  checkRefused(only(folder / "s"), "leads elsewhere");
}

TEST_CASE("links in a git repository are not followed") {
  const Folder folder;
  fs::create_directories(folder / "s/exercises/01_rotation");
  fs::create_symlink("/etc/passwd", folder / "s" / kPath);
  run({"git", "init", "-q", "-b", "main"}, folder / "s");
  run({"git", "add", "-A"}, folder / "s");
  run({"git", "commit", "-q", "-m", "link"}, folder / "s");
  const auto s = only(folder / "s");
  CHECK(s.files.empty());
  CHECK_THAT(s.refused.at("01.hamilton_product"), ContainsSubstring("is a link"));
}

TEST_CASE("a class is a folder of folders and archives, each a student's") {
  const Folder folder;
  writeFile(folder / "class/bob/hamilton_product.cpp", kAnswer);
  pack(folder / "class/ann.zip", Pack::zip, {{kPath, kAnswer}});
  writeFile(folder / "class/Cy Dée_123_assignsubmission_file_/hamilton_product.cpp", kAnswer);
  writeFile(folder / "class/readme.pdf", "x");
  writeFile(folder / "class/.DS_Store", "x");
  writeFile(folder / "class/dora.rar", "x");
  fs::create_symlink("/etc", folder / "class/eve");
  const auto intake = takeIn(kAll, {folder / "class"}, "");
  std::vector<std::string> names;
  for (const auto& s : intake.submissions) names.push_back(s.student);
  CHECK(names == std::vector<std::string>{"ann", "bob", "Cy Dée_123", "dora", "eve"});
  checkTaken(intake.submissions[0]);
  checkTaken(intake.submissions[1]);
  checkTaken(intake.submissions[2]);
  checkRefused(intake.submissions[3], "not read");
  checkRefused(intake.submissions[4], "it is a link");
  REQUIRE(intake.notes.size() == 1);
  CHECK_THAT(intake.notes[0], ContainsSubstring("readme.pdf"));
  CHECK_THAT(carom_test::failureOf([&] { takeIn(kAll, {folder / "nowhere"}, ""); }),
             ContainsSubstring("there is no"));
}

TEST_CASE("two submissions with one name are a question, not a grade") {
  const Folder folder;
  writeFile(folder / "class/ann/hamilton_product.cpp", kAnswer);
  pack(folder / "class/Ann.zip", Pack::zip, {{kPath, kAnswer}});
  writeFile(folder / "class/bob/hamilton_product.cpp", kAnswer);
  const auto intake = takeIn(kAll, {folder / "class"}, "");
  REQUIRE(intake.submissions.size() == 2);
  checkRefused(intake.submissions[0], "more than one submission with this name");
  checkTaken(intake.submissions[1]);
}

TEST_CASE("names of students do no harm in folders, tables and pages") {
  CHECK(safeName("Ann Example") == "Ann Example");
  CHECK(safeName("Zoë Łukasz 李") == "Zoë Łukasz 李");
  CHECK(safeName("=cmd|' /C calc'!A0") == "_cmd_' _C calc'_A0");
  CHECK(safeName("+1") == "_1");
  CHECK(safeName("-rf") == "_-rf");
  CHECK(safeName("@sum") == "_@sum");
  CHECK(safeName("../../etc") == "_.._.._etc");
  CHECK(safeName("..") == "_");
  CHECK(safeName(".hidden") == "_.hidden");
  CHECK(safeName("<script>") == "_script_");
  CHECK(safeName("a\"b`c&d") == "a_b_c_d");
  CHECK(safeName("line\nbreak\x7f") == "line_break_");
  CHECK(safeName("bad\xff\xc0\x80utf") == "bad___utf");
  CHECK(safeName("right\u202eleft\u200b") == "right_left_");
  CHECK(safeName("") == "_");
  CHECK(safeName(std::string(300, 'a')).size() == 100);
}

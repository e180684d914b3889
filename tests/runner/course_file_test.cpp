// Is a course file read as it is meant, and is every mistake in it told by name?

#include "runner/course_file.hpp"

#include <unistd.h>

#include "failure.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;
using carom_test::failureOf;

namespace {

Exercise exercise(const std::string& chapter, const std::string& name) {
  Exercise e;
  e.chapter = chapter;
  e.name = name;
  e.id = chapter.substr(0, 2) + "." + name;
  e.points = 6;
  e.checks = {{"turns", "it turns", 4, "", ""},
              {"stops", "it stops", 2, "", ""},
              {"is_finite", "a guard", 0, "", ""}};
  return e;
}

// A project of two chapters, and a place for course files.
struct Place {
  fs::path root =
      fs::path(CAROM_BUILD_DIR) / "work" / ("course-file-test-" + std::to_string(getpid()));
  Project project{.root = root,
                  .build = root / "build",
                  .manifest = {},
                  .exercises = {exercise("01_rotation", "spin"), exercise("01_rotation", "slerp"),
                                exercise("02_mass", "volume")},
                  .problems = {}};
  Place() {
    for (const char* chapter : {"01_rotation", "02_mass", "03_detection"})
      fs::create_directories(root / "chapters" / chapter);
  }
  ~Place() {
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
  Course read(const std::string& text) const {
    writeFile(root / "autumn.ini", text);
    return readCourse(root / "autumn.ini", project);
  }
  std::string failure(const std::string& text) const {
    return failureOf([&] { read(text); });
  }
  const Exercise& spin() const {
    return project.exercises[0];
  }
  const Exercise& slerp() const {
    return project.exercises[1];
  }
  const Exercise& volume() const {
    return project.exercises[2];
  }
};

}  // namespace

TEST_CASE("a course file says which chapters, by when, and what is hidden") {
  const Place place;
  writeFile(place.root / "seed.secret", "a secret");
  const Course course = place.read(
      "# The course of one autumn\n"
      "[course]\ntitle = Collisions, autumn\nchapters = 1 02_mass\nwithout = 01.slerp\n"
      "solutions = after due\nsecret = seed.secret\n\n"
      "[chapter 01]\ndue = 2026-12-01\n\n"
      "[exercise 01.spin]\npoints = 12\nhidden = stops is_finite\ntopic = how it ends\n"
      "solutions = never\n");
  CHECK(course.title == "Collisions, autumn");
  CHECK(course.secret == "a secret");
  CHECK(course.secretFile == place.root / "seed.secret");
  CHECK(course.chapters == std::set<std::string>{"01_rotation", "02_mass"});

  const auto spin = course.policy(place.spin());
  CHECK(spin.taken);
  CHECK(spin.due == "2026-12-01");
  CHECK(spin.points == 12);
  CHECK(spin.topic == "how it ends");
  CHECK(spin.hides("stops"));
  CHECK_FALSE(spin.hides("turns"));
  CHECK(spin.solutions == "never");

  CHECK_FALSE(course.policy(place.slerp()).taken);

  const auto volume = course.policy(place.volume());
  CHECK(volume.taken);
  CHECK(volume.due.empty());
  CHECK(volume.points == 6);
  CHECK(volume.hidden.empty());
}

TEST_CASE("a worked answer shows from the day after the last one") {
  const Place place;
  const Course course = place.read(
      "[course]\ntitle = t\n[chapter 01]\ndue = 2026-12-01\n"
      "[exercise 01.slerp]\nsolutions = never\n");
  CHECK_FALSE(course.solutionShows(place.spin(), "2026-11-30"));
  CHECK_FALSE(course.solutionShows(place.spin(), "2026-12-01"));
  CHECK(course.solutionShows(place.spin(), "2026-12-02"));
  CHECK(course.solutionShows(place.spin(), "2027-01-01"));
  CHECK_FALSE(course.solutionShows(place.slerp(), "2027-01-01"));
  // No day was given for it.
  CHECK_FALSE(course.solutionShows(place.volume(), "2027-01-01"));

  const Course open = place.read("[course]\ntitle = t\nsolutions = always\n");
  CHECK(open.solutionShows(place.volume(), "2026-01-01"));
}

TEST_CASE("without a file a course has all exercises and shows no answer") {
  const Place place;
  const Course course = defaultCourse(place.project);
  for (const auto& e : place.project.exercises) {
    CHECK(course.policy(e).taken);
    CHECK(course.policy(e).points == e.points);
    CHECK_FALSE(course.solutionShows(e, "2099-01-01"));
  }
  CHECK(course.chapters.size() == 3);
  CHECK(course.file.empty());
}

TEST_CASE("mistakes in a course file are told with the file, the section and the key") {
  const Place place;
  const std::string head = "[course]\ntitle = t\n";
  CHECK_THAT(place.failure(head + "titel = x\n"),
             ContainsSubstring("autumn.ini: [course] unknown key 'titel'"));
  CHECK_THAT(place.failure(head + "title = x\n"),
             ContainsSubstring("[course] 'title' is given twice"));
  CHECK_THAT(place.failure("[course]\n"), ContainsSubstring("[course] needs 'title = ...'"));
  CHECK_THAT(place.failure("[chapter 1]\ndue = 2026-12-01\n"),
             ContainsSubstring("there is no section [course]"));
  CHECK_THAT(place.failure("due = 2026-12-01\n" + head), ContainsSubstring("is none of [course]"));
  CHECK_THAT(place.failure(head + "[lesson 1]\n"),
             ContainsSubstring("[lesson 1] is none of [course], [chapter NUMBER], [exercise ID]"));
  CHECK_THAT(place.failure(head + "chapters = 1 9\n"),
             ContainsSubstring("[course] there is no chapter '9'"));
  CHECK_THAT(place.failure(head + "without = 01.spun\n"),
             ContainsSubstring("[course] there is no exercise 01.spun"));
  CHECK_THAT(place.failure(head + "[chapter 1]\npoints = 3\n"),
             ContainsSubstring("[chapter 1] unknown key 'points'"));
  CHECK_THAT(place.failure(head + "[exercise 01.spin]\nsolutions = sometimes\n"),
             ContainsSubstring("[exercise 01.spin] solutions = sometimes: it is one of"));
  CHECK_THAT(place.failure(head + "[exercise 01.spin]\npoints = many\n"),
             ContainsSubstring("[exercise 01.spin] points = many: it is a number"));
  CHECK_THAT(place.failure(head + "[exercise 01.spin]\nhidden = flies\n"),
             ContainsSubstring("01.spin has no check 'flies'"));
  CHECK_THAT(place.failure(head + "[exercise 01.spin]\nhidden = turns stops\n"),
             ContainsSubstring("no scored check of 01.spin is left for students"));
  CHECK_THAT(place.failure(head + "secret = none.secret\n"),
             ContainsSubstring("[course] secret = none.secret: there is no such file"));
  for (const char* day : {"2026-13-01", "2026-02-29", "1-12-2026", "tomorrow", "2026-12-1"})
    CHECK_THAT(place.failure(head + "[chapter 2]\ndue = " + day + "\n"),
               ContainsSubstring("a day is written 2026-12-01"));
  // All of them at once.
  const auto two = place.failure(head + "titel = x\n[exercise 01.spin]\npoints = -1\n");
  CHECK_THAT(two, ContainsSubstring("titel"));
  CHECK_THAT(two, ContainsSubstring("points = -1"));
  CHECK_THAT(failureOf([&] { readCourse(place.root / "none.ini", place.project); }),
             ContainsSubstring("none.ini cannot be read"));
}

TEST_CASE("a seed is HMAC-SHA-256 of student and exercise under the secret") {
  Course course;
  course.secret = "a secret";
  // printf 'student a\00001.hamilton_product' | openssl dgst -sha256 -hmac 'a secret'
  CHECK(seedOf(course, "student a", "01.hamilton_product") == 0xaa2a4b4c93be6518u);
  CHECK(seedOf(course, "student b", "01.hamilton_product") !=
        seedOf(course, "student a", "01.hamilton_product"));
  // The zero byte keeps "a" + "b.c" apart from "ab" + ".c".
  CHECK(seedOf(course, "a", "b.c") != seedOf(course, "ab", ".c"));
  const auto known = seedOf(Course{}, "student a", "01.hamilton_product");
  CHECK(known != seedOf(course, "student a", "01.hamilton_product"));
  course.secret = "carom";
  CHECK(known == seedOf(course, "student a", "01.hamilton_product"));
}

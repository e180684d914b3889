// The small functions on text and files.

#include "runner/text.hpp"

#include <unistd.h>

#include "failure.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;
using carom_test::failureOf;

namespace {

struct Scratch {
  fs::path path = fs::path(CAROM_BUILD_DIR) / "work" / ("text-test-" + std::to_string(getpid()));
  Scratch() {
    fs::create_directories(path);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

}  // namespace

TEST_CASE("lines are split at every kind of line end") {
  CHECK(splitLines("").empty());
  CHECK(splitLines("\n") == std::vector<std::string>{""});
  CHECK(splitLines("a\r\nb\n\nc") == std::vector<std::string>{"a", "b", "", "c"});
  CHECK(splitLines("a\n") == std::vector<std::string>{"a"});
}

TEST_CASE("blanks around a text go, blanks inside stay") {
  CHECK(trimmed(" \t a b \r\n") == "a b");
  CHECK(trimmed(" \n").empty());
  CHECK(trimmed("").empty());
}

TEST_CASE("a paragraph is broken at its width and begins every line with its indentation") {
  CHECK(wrapped("one two three four", 9, "  ") == "  one two\n  three\n  four");
  CHECK(wrapped("", 9, "  ") == "  ");
  // A word that is too long stands alone rather than being cut.
  CHECK(wrapped("a incomprehensibilities b", 9, "") == "a\nincomprehensibilities\nb");
}

TEST_CASE("the hash is FNV-1a with 64 bits") {
  // Published test vectors of Fowler, Noll and Vo.
  CHECK(hashOf("") == "cbf29ce484222325");
  CHECK(hashOf("a") == "af63dc4c8601ec8c");
  CHECK(hashOf("foobar") == "85944171f73967e8");
}

TEST_CASE(
    "a file is written as a whole, with the folders that it needs, and read back with every byte") {
  const Scratch scratch;
  const fs::path file = scratch.path / "new folder" / "däta";
  const std::string content("a\0b\r\n\xff", 6);
  writeFile(file, content);
  CHECK(readFile(file) == content);
  writeFile(file, "second");
  CHECK(readFile(file) == "second");
  CHECK(std::distance(fs::directory_iterator(file.parent_path()), {}) == 1);
}

TEST_CASE("a file that is not there is nothing, or a failure that names it") {
  const Scratch scratch;
  CHECK(!readIfThere(scratch.path / "none"));
  CHECK(!readIfThere(scratch.path));
  CHECK_THAT(failureOf([&] { readFile(scratch.path / "none"); }), ContainsSubstring("/none"));
  writeFile(scratch.path / "file", "x");
  CHECK_THROWS(writeFile(scratch.path / "file" / "below", "x"));
}

TEST_CASE("what somebody else wrote steers no terminal and breaks no report") {
  CHECK(printable("a line\n\tand m\xc2\xb2, \xe6\x97\xa5, \xf0\x9f\x99\x82") ==
        "a line\n\tand m\xc2\xb2, \xe6\x97\xa5, \xf0\x9f\x99\x82");
  CHECK(printable("\x1b[2Jx\r\x07\x7f") == "?[2Jx???");
  // Half a character, one too long, a surrogate, and what turns the direction of writing.
  CHECK(printable("\xc3") == "?");
  CHECK(printable("\xc0\xaf") == "??");
  CHECK(printable("\xed\xa0\x80!").back() == '!');
  CHECK(printable("a\xe2\x80\xae"
                  "b") == "a?b");
  CHECK(printable("") == "");
}

TEST_CASE("what is read aloud is ASCII and says what the signs mean") {
  CHECK(spoken("3 N·s, kg m², 10⁻⁷, ω × r, 90°") == "3 N s, kg m^2, 10^-7, omega x r, 90 degrees");
  CHECK(spoken("✓ R_WBᵀ ≤ √2 ± ½") == "passed R_WB^T <= sqrt 2 +- 1/2");
  CHECK(spoken("a “word” … cöurse") == "a \"word\" ... coeurse");
  // A sign that nobody thought of stands for one character, however many bytes it has.
  CHECK(spoken("a\xF0\x9F\x8E\xB1z") == "a?z");
  CHECK(spoken("") == "");
}

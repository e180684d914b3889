// What the screen finds in the text of a submission, and what it leaves alone.

#include "runner/screen.hpp"

#include "support/catch.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;

namespace {

std::string refusal(std::string_view source) {
  Screening result;
  screenSource(source, result);
  return result.refused.empty() ? "" : result.refused.front();
}

}  // namespace

TEST_CASE("an ordinary answer is let through") {
  CHECK(refusal("#include \"carom/core/real.hpp\"\n#include <cmath>\n"
                "double f(double x) { return std::sqrt(x) * 1'000; }\n")
            .empty());
  CHECK(refusal("").empty());
}

TEST_CASE("words in remarks and in texts count for nothing") {
  CHECK(refusal("// asm volatile\n/* __asm__ in\n two lines */ int a;\n").empty());
  CHECK(refusal("const char* t = \"asm(\\\" __asm__\";\n").empty());
  CHECK(refusal("const char* t = R\"x(asm \" )\" __asm__ )x\";\n").empty());
  CHECK(refusal("// #include \"/etc/hostname\"\n").empty());
  CHECK(refusal("int plasma = 1, asmr = 2; // no assembler\n").empty());
  CHECK(refusal("// an attribute constructor\nstruct A { A(); };\n").empty());
}

TEST_CASE("assembly is found in every spelling") {
  const char* const hidden[] = {
      "asm(\"nop\");",
      "__asm__ volatile(\"\");",
      "int a; __asm (\"\");",
      "as\\\nm(\"nop\");",
      "as\\  \nm(\"nop\");",
      "/* */ asm /* */ (\"nop\");",
      "const char* t = \"//\"; asm(\"nop\");",
      "const char* t = \"\\\"\"; asm(\"nop\");",
      "char q = '\"'; asm(\"nop\"); char r = '\"';",
      "int n = 1'000; asm(\"nop\"); int m = 1'000;",
      "const char* t = R\"(\n/*\n)\"; asm(\"nop\"); // */",
      "const char* t = R\"a(\")\")a\"; asm(\"nop\");",
      "const char* t = u8R\"(/*)\"; asm(\"nop\"); /* */",
  };
  for (const char* source : hidden) {
    INFO(source);
    CHECK_THAT(refusal(source), ContainsSubstring("assembly code"));
  }
}

TEST_CASE("names that are pasted together are refused, whatever they become") {
  CHECK_THAT(refusal("#define J(a, b) a##b\n"), ContainsSubstring("pastes names"));
  CHECK_THAT(refusal("#define J(a, b) a%:%:b\n"), ContainsSubstring("pastes names"));
  CHECK_THAT(refusal("__CONCAT(as, m)(\"nop\");"), ContainsSubstring("pastes names"));
}

TEST_CASE("code before main is found in every spelling") {
  for (const char* source :
       {"__attribute__((constructor)) void f();", "[[gnu::constructor]] void f();",
        "__attribute((__constructor__)) void f();", "[[gnu::destructor]] void f();"}) {
    INFO(source);
    CHECK_THAT(refusal(source), ContainsSubstring("before or after main"));
  }
}

TEST_CASE("files that are none of a submission's business are not included") {
  const char* const outside[] = {
      "#include \"/etc/hostname\"",        "#include </etc/hostname>",
      "  #  include \"../x.cpp\"",         "#/**/include \"/etc/hostname\"",
      "/**/#include \"/etc/hostname\"",    "%:include \"/etc/hostname\"",
      "#inc\\\nlude \"/etc/hostname\"",    "#include_next \"/etc/hostname\"",
      "#include \"carom/../../../x.cpp\"",
  };
  for (const char* source : outside) {
    INFO(source);
    CHECK_THAT(refusal(source), ContainsSubstring("outside the course"));
  }
  CHECK_THAT(refusal("#define F \"/etc/hostname\"\n#include F"), ContainsSubstring("computes"));
  for (const char* source : {"#include \"grading/grade.hpp\"", "#include <support/catch.hpp>",
                             "#include <catch2/catch.hpp>"}) {
    INFO(source);
    CHECK_THAT(refusal(source), ContainsSubstring("the grader's own files"));
  }
}

TEST_CASE("texts that never end do not confuse the reader") {
  for (const char* source : {"\"", "'", "R\"(", "R\"", "/*", "//", "\\", "\"\\", "#include \"",
                             "#include", "#", "%:", "1'"}) {
    INFO(source);
    CHECK_NOTHROW(refusal(source));
  }
  CHECK_THAT(refusal("const char* t = \"never closed;\nasm(\"nop\");"),
             ContainsSubstring("assembly code"));
}

TEST_CASE("what is no text, or too much of it, is refused") {
  CHECK_THAT(refusal(std::string(300 << 10, ' ')), ContainsSubstring("larger than 256 kB"));
  CHECK_THAT(refusal(std::string_view("int a;\0", 7)), ContainsSubstring("zero byte"));
}

TEST_CASE("a symbol is shown as it was written") {
  CHECK(demangled("_ZN5carom4todoEv") == "carom::todo()");
  CHECK(demangled("memcpy") == "memcpy");
}

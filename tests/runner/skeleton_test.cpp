// Are skeletons cut where the markers say, and is every mistake in the markers told with its line?

#include "runner/skeleton.hpp"

#include "failure.hpp"

using namespace carom::runner;
using carom_test::ContainsSubstring;
using carom_test::failureOf;

namespace {

const char* const kAnswer =
    "int twice(int x) {\n"
    "  //# solution\n"
    "  // Add it to itself.\n"
    "  const int sum = x + x;\n"
    "\n"
    "  return sum;\n"
    "  //# stub\n"
    "  // What is x and x?\n"
    "  //#| const char* text = \"//\";\n"
    "  //#|\n"
    "  //#| return todo<int>(\"twice\");\n"
    "  //# end\n"
    "}\n";

}  // namespace

TEST_CASE("a skeleton has the stub in place of the answer, with the stub's indentation") {
  CHECK(cutSkeleton(kAnswer, "twice.cpp") ==
        "int twice(int x) {\n"
        "  // What is x and x?\n"
        "  const char* text = \"//\";\n"
        "\n"
        "  return todo<int>(\"twice\");\n"
        "}\n");
}

TEST_CASE("an answer is shown without stub and markers") {
  CHECK(cutAnswer(kAnswer, "twice.cpp") ==
        "int twice(int x) {\n"
        "  // Add it to itself.\n"
        "  const int sum = x + x;\n"
        "\n"
        "  return sum;\n"
        "}\n");
}

TEST_CASE("lines that a student writes are counted without comments and blank lines") {
  CHECK(answerLines(kAnswer, "twice.cpp") == 2);
  CHECK(answerOnly(kAnswer, "twice.cpp") ==
        "// Add it to itself.\nconst int sum = x + x;\n\nreturn sum;\n");
}

TEST_CASE("a file may have several regions") {
  const std::string two =
      "//# solution\na;\n//# stub\n//#| A;\n//# end\nbetween;\n//# solution\nb;\n//# stub\n// B?\n"
      "//# end\n";
  CHECK(cutSkeleton(two, "x.cpp") == "A;\nbetween;\n// B?\n");
  CHECK(cutAnswer(two, "x.cpp") == "a;\nbetween;\nb;\n");
}

TEST_CASE("a prediction is cut by its own markers") {
  const std::string source =
      "# How far?\n## solution\ndistance = 3.5 m\n## stub\n##| distance = ? m\n## end\n";
  CHECK(cutSkeleton(source, "far.txt") == "# How far?\ndistance = ? m\n");
  CHECK(cutAnswer(source, "far.txt") == "# How far?\ndistance = 3.5 m\n");
}

TEST_CASE("an empty line in a stub stays empty") {
  CHECK(cutSkeleton("//# solution\na;\n//# stub\n// b\n\n//#| c;\n//# end\n", "x.cpp") ==
        "// b\n\nc;\n");
}

TEST_CASE("lines that end as on Windows are cut like others") {
  CHECK(cutSkeleton("//# solution\r\na;\r\n//# stub\r\n//#| b;\r\n//# end\r\n", "x.cpp") == "b;\n");
}

TEST_CASE("every mistake in the markers names its line") {
  struct Mistake {
    const char* source;
    const char* message;
  };
  const Mistake mistakes[] = {
      {"a;\n  b; //# end\n", "x.cpp:2: a marker must stand alone on its line"},
      {"//# solution\na;\n//# stub\nb;\n//# end\n",
       "x.cpp:4: a stub line is a comment, or code behind //#|"},
      {"//#| a;\n", "x.cpp:1: stub code outside a stub"},
      {"//# solution\n//#| a;\n", "x.cpp:2: stub code outside a stub"},
      {"//# solution\na;\n//# solution\n", "x.cpp:3: markers cannot be nested"},
      {"//# solution\na;\n//# stub\n// b\n//# solution\n", "x.cpp:5: markers cannot be nested"},
      {"a;\n//# stub\n", "x.cpp:2: 'stub' follows 'solution'"},
      {"//# solution\na;\n//# stub\n//# stub\n", "x.cpp:4: 'stub' follows 'solution'"},
      {"//# end\n", "x.cpp:1: 'end' follows 'stub'"},
      {"//# solution\na;\n//# end\n", "x.cpp:3: 'end' follows 'stub'"},
      {"//# solution\na;\n//# stub\n//# end\n", "x.cpp:4: the stub is empty"},
      {"//# solutoin\n", "x.cpp:1: unknown marker 'solutoin'"},
      {"//#\n", "x.cpp:1: unknown marker ''"},
      {"//# solution\na;\n", "x.cpp:2: a region is not closed"},
      {"//# solution\na;\n//# stub\n// b\n", "x.cpp:4: a region is not closed"},
      {"int a;\n", "x.cpp:1: there is no region 'solution'"},
      {"", "x.cpp:0: there is no region 'solution'"},
  };
  for (const auto& mistake : mistakes) {
    INFO(mistake.source);
    CHECK(failureOf([&] { cutSkeleton(mistake.source, "x.cpp"); }) == mistake.message);
  }
}

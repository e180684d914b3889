// The files of a new exercise: everything that follows from the function, and blanks for what only its author knows.

#include <algorithm>
#include <map>
#include <regex>

#include "runner/develop.hpp"
#include "runner/skeleton.hpp"

namespace carom::runner {

namespace {

std::string camelCase(const std::string& name) {
  std::string result;
  bool upper = false;
  for (const char c : name) {
    if (c == '_') {
      upper = true;
    } else {
      result += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      upper = false;
    }
  }
  return result;
}

// What a header declares: `Real name(const Vector3& a, Real b);`
struct Signature {
  std::string result, parameters, arguments;
};

std::optional<Signature> signatureOf(const std::string& header, const std::string& function) {
  // Comments hold the name too.
  std::string code;
  for (const auto& line : splitLines(header)) code += line.substr(0, line.find("//")) + "\n";
  const std::regex declaration("([A-Za-z_:][A-Za-z0-9_:<>, ]*[A-Za-z0-9_>])\\s+" + function +
                               "\\(([^;{]*)\\)\\s*;");
  std::smatch match;
  if (!std::regex_search(code, match, declaration)) return std::nullopt;
  Signature found{trimmed(match[1].str()), "", ""};
  for (const auto& word : words(match[2].str()))
    found.parameters += (found.parameters.empty() ? "" : " ") + word;
  // The name of a parameter is the last word in front of a comma that stands in no bracket, or of its default.
  int depth = 0;
  std::string parameter;
  auto take = [&] {
    std::string text = trimmed(parameter.substr(0, parameter.find(" =")));
    const auto from =
        text.find_last_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
    if (!text.empty()) {
      found.arguments += (found.arguments.empty() ? "" : ", ") +
                         text.substr(from == std::string::npos ? 0 : from + 1);
    }
    parameter.clear();
  };
  for (const char c : found.parameters) {
    depth += c == '<' || c == '(' ? 1 : c == '>' || c == ')' ? -1 : 0;
    if (c == ',' && depth == 0)
      take();
    else
      parameter += c;
  }
  take();
  return found;
}

// The source with markers around the body of the function.
std::optional<std::string> withMarkers(const std::string& source, const std::string& function,
                                       const Signature& signature, const std::string& head) {
  const auto lines = splitLines(source);
  std::size_t at = 0;
  while (at < lines.size() && !lines[at].starts_with("#include")) ++at;
  std::string text = head;
  std::size_t start = lines.size();
  for (std::size_t i = at; i < lines.size(); ++i) {
    if (lines[i].find(" " + function + "(") != std::string::npos && !lines[i].starts_with(" ") &&
        !lines[i].starts_with("//")) {
      start = i;
      break;
    }
  }
  std::size_t body = start;
  while (body < lines.size() && !lines[body].ends_with("{")) ++body;
  std::size_t end = body;
  while (end < lines.size() && lines[end] != "}") ++end;
  if (end >= lines.size()) return std::nullopt;
  // Behind the last header of ours; on its own if that is the function's.
  std::size_t include = at;
  for (std::size_t i = at; i < start; ++i) {
    if (lines[i].starts_with("#include \"")) include = i;
  }
  for (std::size_t i = at; i < lines.size(); ++i) {
    if (i == end) {
      const bool nothing = signature.result == "void";
      text += "  //# stub\n  // What is given, and what the answer is.\n  //#| " +
              std::string(nothing ? "" : "return ") + "todo<" + signature.result + ">(\"" +
              function + "\");\n  //# end\n";
    }
    text += lines[i] + "\n";
    if (i == body) text += "  //# solution\n";
    if (i == include)
      text += std::string(include == at ? "\n" : "") + "#include \"carom/core/todo.hpp\"\n";
  }
  return text;
}

}  // namespace

std::vector<std::string> missingFiles(const Project& project, const Exercise& exercise) {
  std::vector<std::string> missing;
  auto need = [&](const fs::path& file, const char* what) {
    if (!fs::exists(project.root / file))
      missing.push_back(exercise.id + ": there is no " + file.string() + ", " + what);
  };
  const fs::path graders = exercise.graderFolder();
  if (exercise.kind == "predict") {
    need(graders / (exercise.name + "_test.cpp"), "the grader");
  } else if (!exercise.isTest()) {
    need(graders / (exercise.name + "_test.cpp"), "the grader");
    need(graders / (exercise.name + "_seam.cpp"), "the line CAROM_SEAM of the function");
    need(fs::path(exercise.home) / (exercise.name + ".hpp"), "the header of the function");
    need(fs::path(exercise.home) / (exercise.name + ".cpp"), "the library's version");
  }
  if (missing.empty() && !exercise.isPrediction()) {
    missing.push_back(exercise.id + ": CMake does not know it; is " +
                      (exercise.isTest() ? exercise.tests : exercise.name) + " a seam in " +
                      exercise.home + "/CMakeLists.txt?");
  }
  return missing;
}

std::vector<std::string> newExercise(const Project& project, const NewExercise& wanted) {
  const std::string chapter = project.chapterFolder(wanted.chapter);
  const std::string& name = wanted.name;
  if (name.empty() ||
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
    throw Failure{usage, "'" + name +
                             "' is no name for an exercise: it is the file name of its "
                             "function, in small letters, digits and underscores"};
  }
  const bool predicts = wanted.kind == "predict";
  const bool tests = wanted.kind == "test";
  if (!predicts && !tests && wanted.kind != "implement" && wanted.kind != "fix" &&
      wanted.kind != "measure") {
    throw Failure{usage, "there is no kind '" + wanted.kind +
                             "'; there are implement, fix, measure, predict, test"};
  }
  const fs::path folder = fs::path("solutions") / chapter / name;
  if (fs::exists(project.root / folder)) throw Failure{usage, folder.string() + " exists already"};

  const std::string id = chapter.substr(0, 2) + "." + name;
  // The layer of the chapter is that of most of its exercises.
  std::map<std::string, int> layers;
  int order = 0;
  for (const auto& e : project.exercises) {
    if (e.chapter == chapter) {
      ++layers[e.layer];
      order += 10;
    }
  }
  std::string layer = "core";
  int most = 0;
  for (const auto& [candidate, count] : layers) {
    if (count > most) {
      most = count;
      layer = candidate;
    }
  }

  std::vector<std::pair<fs::path, std::string>> files;
  std::string home;
  std::string more;
  std::string checkKeys = "wrong = 01_first_slip\n";
  const std::string head = "// Exercise " + id + ": the question, in one line.\n" +
                           "// Check it with: ./course check " + id + "\n\n";
  const fs::path graders = fs::path("tests/graders") / chapter;
  if (predicts) {
    const std::string text = "# Exercise " + id + ": the question, in one line.\n" +
                             "# Check it with: ./course check " + id + "\n" +
                             "# Put a number in the place of each question mark.\n\n";
    files = {{folder / (name + ".txt"),
              text + "## solution\nanswer = 1 m\n## stub\n##| answer = ? m\n## end\n"},
             {folder / "wrong/01_first_slip.txt", text + "answer = 2 m\n"},
             {folder / "right/01_rounded.txt", text + "answer = 1.0 m\n"},
             {graders / (name + "_test.cpp"),
              "#include \"grading/grade.hpp\"\n\nusing namespace carom;\nusing namespace "
              "carom::grading;\n\n// The expected number is computed here, by the library or in "
              "closed form.\nTEST_CASE(\"first\") {}\n\nPROBES() {\n  PROBE(predicted(\"answer\", "
              "\"m\"));\n}\n"}};
  } else if (tests) {
    if (wanted.tests.empty())
      throw Failure{usage,
                    "test cases are about the function of an exercise: --tests 03.sat_boxes"};
    const Exercise& tested = project.find(wanted.tests);
    layer = tested.layer;
    home = tested.home;
    more = "tests = " + tested.id + "\n";
    checkKeys = "catches = " + (tested.wrong.empty() ? std::string() : tested.wrong[0].name) +
                "\nslipped = \n";
    const std::string include =
        home.starts_with("lib/") ? fs::path(home).lexically_relative("lib").string() + "/" : "";
    const std::string top = head + "#include \"" + include + tested.name + ".hpp\"\n";
    const std::string rest = "#include \"support/catch.hpp\"\n\nusing namespace carom;\n\n";
    const std::string one =
        "TEST_CASE(\"a sentence that a wrong version makes false\") {\n  "
        "CHECK(true);\n}\n";
    files = {{folder / (name + ".cpp"),
              top + "#include \"carom/core/todo.hpp\"\n" + rest + "//# solution\n" + one +
                  "//# stub\n// One case for each thing that a wrong version could get wrong.\n" +
                  "//#| TEST_CASE(\"what does a right version answer?\") {\n//#|   "
                  "todo<void>(\"this case\");\n//#| }\n//# end\n"},
             {folder / "wrong/01_lets_the_first_through.cpp", top + rest + one},
             {folder / "right/01_another_way.cpp", top + rest + one}};
  } else {
    const std::string function = camelCase(name);
    // In a layer of the library, or beside the chapter's programs.
    fs::path header;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(project.root / "lib/carom", none)) {
      if (fs::exists(entry.path() / (name + ".hpp"))) {
        header = entry.path() / (name + ".hpp");
        layer = entry.path().filename().string();
        home = "lib/carom/" + layer;
      }
    }
    if (fs::exists(project.root / "chapters" / chapter / (name + ".hpp"))) {
      header = project.root / "chapters" / chapter / (name + ".hpp");
      home = "chapters/" + chapter;
    }
    if (header.empty()) {
      throw Failure{usage, "there is no " + name +
                               ".hpp, neither in a layer of lib/carom nor in chapters/" + chapter +
                               ". Write the function first, with its header and its line in "
                               "CMakeLists.txt; the guide says how, under 'Adding an exercise'"};
    }
    const auto signature = signatureOf(readFile(header), function);
    if (!signature) {
      throw Failure{usage, header.lexically_relative(project.root).string() +
                               " declares no function " + function +
                               "; a seam's function has the name of its file"};
    }
    const fs::path source = fs::path(header).replace_extension(".cpp");
    const auto marked = withMarkers(readFile(source), function, *signature, head);
    if (!marked) {
      throw Failure{usage, source.lexically_relative(project.root).string() +
                               " has no definition of " + function +
                               " that begins at the start of a line and ends with a } there"};
    }
    const std::string include =
        home.starts_with("lib/") ? "carom/" + layer + "/" + name + ".hpp" : name + ".hpp";
    const std::string fields =
        fs::exists(project.root / "tests/grading" / ("fields_" + layer + ".hpp"))
            ? "#include \"grading/fields_" + layer + ".hpp\"\n"
            : "";
    const std::string plain = cutAnswer(*marked, name + ".cpp");
    files = {
        {folder / (name + ".cpp"), *marked},
        {folder / "wrong/01_first_slip.cpp", plain},
        {folder / "right/01_another_way.cpp", plain},
        {graders / (name + "_seam.cpp"),
         "#include \"" + include + "\"\n\n" + fields + "#include \"grading/seam.hpp\"\n\n" +
             "CAROM_SEAM(" + signature->result + ", " + function + ", (" + signature->parameters +
             "), (" + signature->arguments + "))\n"},
        {graders / (name + "_test.cpp"),
         "// Grader of " + id + ": where its expected values come from.\n\n#include \"" + include +
             "\"\n\n" + fields +
             "#include \"grading/grade.hpp\"\n\nusing namespace carom;\nusing namespace "
             "carom::grading;\n\n// One TEST_CASE for each [check....] of exercise.ini. What is "
             "expected comes from closed forms,\n// invariants and other roads, never from a "
             "copy of the function:\n//   GRADE(" +
             function + "(" + signature->arguments +
             "), expected, within(1e-12, \"why so near\"), given(\"a\", a, \"m\"), "
             "unit(\"m\"));\nTEST_CASE(\"first\") {}\n\n// Inputs on which each wrong version "
             "answers differently: PROBE(" +
             function + "(" + signature->arguments + "));\nPROBES() {}\n"}};
  }

  std::string ini =
      "# Values run to the end of the line. ./course dev check " + id +
      " says what is missing.\nid = " + id + "\ntitle = \nkind = " + wanted.kind +
      "\nlevel = 1\nminutes = 15\npoints = 1\norder = " + std::to_string(order + 10) +
      "\nlayer = " + layer + "\n" + (home.empty() ? "" : "home = " + home + "\n") + more +
      "# a heading of the chapter's page\nread = \n# names that the statement stands on\nuses = "
      "\n\n"
      "# one for each thing that can be misunderstood; their points add up to those above\n"
      "[check.first]\ntitle = \npoints = 1\n" +
      checkKeys + "\n[wrong." + (tests ? "01_lets_the_first_through" : "01_first_slip") +
      "]\nsays = \ncheck = first\n\n# a question first; only the last hint may hold a line of the "
      "answer\n[hint.1]\ntext = \n\n[hint.2]\ntext = \n";
  files.emplace_back(folder / "exercise.ini", ini);
  files.emplace_back(folder / "statement.md", "");
  files.emplace_back(folder / "why.md", "");
  std::vector<std::string> written;
  for (const auto& [file, text] : files) {
    if (fs::exists(project.root / file)) continue;
    writeFile(project.root / file, text);
    written.push_back(file.string());
  }
  std::sort(written.begin(), written.end());
  return written;
}

}  // namespace carom::runner

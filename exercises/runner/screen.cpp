#include "runner/screen.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>

#include "runner/confine.hpp"

namespace carom::runner {

namespace {

// Functions of C that a numeric answer may call. Everything not named here, in std::, or in the stage is refused.
const std::set<std::string> kAllowedC = {"sqrt",
                                         "cbrt",
                                         "hypot",
                                         "sin",
                                         "cos",
                                         "tan",
                                         "sincos",
                                         "asin",
                                         "acos",
                                         "atan",
                                         "atan2",
                                         "sinh",
                                         "cosh",
                                         "tanh",
                                         "exp",
                                         "exp2",
                                         "expm1",
                                         "log",
                                         "log2",
                                         "log10",
                                         "log1p",
                                         "pow",
                                         "fabs",
                                         "fma",
                                         "fmod",
                                         "remainder",
                                         "floor",
                                         "ceil",
                                         "round",
                                         "trunc",
                                         "rint",
                                         "nearbyint",
                                         "lround",
                                         "llround",
                                         "lrint",
                                         "ldexp",
                                         "frexp",
                                         "scalbn",
                                         "scalbln",
                                         "ilogb",
                                         "logb",
                                         "modf",
                                         "copysign",
                                         "nextafter",
                                         "fmax",
                                         "fmin",
                                         "fdim",
                                         "erf",
                                         "erfc",
                                         "tgamma",
                                         "lgamma",
                                         "nan",
                                         "abs",
                                         "labs",
                                         "memcpy",
                                         "memmove",
                                         "memset",
                                         "memcmp",
                                         "strlen",
                                         "strcmp",
                                         "malloc",
                                         "free",
                                         "calloc",
                                         "realloc",
                                         "aligned_alloc",
                                         "posix_memalign",
                                         "abort",
                                         "__assert_fail",
                                         "__stack_chk_fail",
                                         "_Unwind_Resume",
                                         "__gxx_personality_v0",
                                         "__dso_handle",
                                         "_GLOBAL_OFFSET_TABLE_",
                                         "__tls_get_addr",
                                         "feclearexcept",
                                         "bsearch",
                                         "qsort"};

const std::set<std::string> kPrinting = {
    "printf", "puts",   "putchar", "fprintf",      "fputs",         "fputc",    "fwrite",
    "fflush", "stdout", "stderr",  "__printf_chk", "__fprintf_chk", "snprintf", "sprintf"};

const std::set<std::string> kEnding = {
    "exit",          "_exit",        "_Exit",   "quick_exit",   "atexit",
    "at_quick_exit", "on_exit",      "raise",   "kill",         "killpg",
    "signal",        "sigaction",    "longjmp", "siglongjmp",   "alarm",
    "setitimer",     "pthread_exit", "tgkill",  "pthread_kill", "abort_handler"};

struct Symbol {
  char type;
  std::string name;
};

std::vector<Symbol> symbolsOf(const Project& project, const fs::path& object,
                              const grading::Sandbox* sandbox = nullptr) {
  grading::Command command;
  command.words = {project.text("nm"), "-P", object.string()};
  command.limits.outputKilobytes = 64 << 10;
  if (sandbox) command = confinedTool(project, std::move(command), {object}, {}, *sandbox);
  const auto done = grading::run(command);
  std::vector<Symbol> symbols;
  for (const auto& line : splitLines(done.output)) {
    const auto parts = words(line);
    if (parts.size() >= 2 && parts[1].size() == 1) symbols.push_back({parts[1][0], parts[0]});
  }
  return symbols;
}

bool beginsWithAny(const std::string& text, std::initializer_list<const char*> beginnings) {
  for (const char* b : beginnings) {
    if (text.rfind(b, 0) == 0) return true;
  }
  return false;
}

// The source as the compiler reads it: continued lines joined, comments replaced by blanks, and the insides of texts
// too (except in an #include), so that the word "asm" in a remark or a message counts for nothing.
std::string codeOnly(std::string_view source) {
  std::string joined;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i] == '\\') {
      // GCC lets blanks stand between the backslash and the end of the line.
      const auto end = source.find_first_not_of(" \t\r", i + 1);
      if (end != std::string_view::npos && source[end] == '\n') {
        i = end;
        continue;
      }
    }
    joined += source[i];
  }
  std::string code;
  bool directive = false;  // on a line that begins with #
  bool lineEmpty = true;
  auto partOfName = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t i = 0; i < joined.size();) {
    const char c = joined[i];
    const char next = i + 1 < joined.size() ? joined[i + 1] : '\0';
    if (c == '/' && next == '/') {
      i = std::min(joined.find('\n', i), joined.size());
    } else if (c == '/' && next == '*') {
      const auto end = std::min(joined.find("*/", i + 2), joined.size());
      i = std::min(end + 2, joined.size());
      code += ' ';
    } else if (c == '"' && !code.empty() && code.back() == 'R' && !directive) {
      // R"mark( ... )mark": nothing inside has a meaning, not even the end of a line.
      const auto bracket = joined.find('(', i);
      if (bracket == std::string::npos) return code;
      const std::string mark = ")" + joined.substr(i + 1, bracket - i - 1) + "\"";
      const auto end = joined.find(mark, bracket);
      i = end == std::string::npos ? joined.size() : end + mark.size();
      code += "\"\"";
    } else if (c == '"' || (c == '\'' && (code.empty() || !partOfName(code.back())))) {
      // A quote behind a digit separates digits: 1'000.
      code += c;
      for (++i; i < joined.size() && joined[i] != c && joined[i] != '\n'; ++i) {
        if (directive) code += joined[i];
        if (joined[i] == '\\' && !directive) ++i;
      }
      if (i < joined.size() && joined[i] == c) {
        code += c;
        ++i;
      }
    } else if (lineEmpty && (c == '#' || (c == '%' && next == ':'))) {
      directive = true;
      lineEmpty = false;
      code += '#';
      i += c == '#' ? 1 : 2;
    } else {
      if (c == '\n') {
        directive = false;
        lineEmpty = true;
      } else if (!std::isspace(static_cast<unsigned char>(c))) {
        lineEmpty = false;
      }
      code += c;
      ++i;
    }
  }
  return code;
}

bool hasWord(const std::string& code, const std::string& word) {
  auto partOfName = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
    const bool before = at > 0 && partOfName(code[at - 1]);
    const bool after = at + word.size() < code.size() && partOfName(code[at + word.size()]);
    if (!before && !after) return true;
  }
  return false;
}

}  // namespace

std::string demangled(const std::string& symbol) {
  int status = 0;
  char* name = abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status);
  std::string result = status == 0 && name ? name : symbol;
  std::free(name);
  return result;
}

void screenSource(std::string_view source, Screening& result, bool isTest) {
  if (source.size() > (256u << 10)) result.refused.push_back("The file is larger than 256 kB.");
  if (source.find('\0') != std::string_view::npos)
    result.refused.push_back("The file is not text: it holds a zero byte.");
  const std::string code = codeOnly(source);
  constexpr auto npos = std::string::npos;
  auto hasAny = [&](std::initializer_list<const char*> all) {
    return std::any_of(all.begin(), all.end(), [&](const char* w) { return hasWord(code, w); });
  };
  if (hasAny({"asm", "__asm", "__asm__"})) {
    result.refused.push_back(
        "It holds assembly code, which can do anything: an answer is written in C++.");
  }
  if (hasAny({"constructor", "__constructor__", "destructor", "__destructor__"}) &&
      (hasAny({"__attribute__", "__attribute"}) || code.find("[[") != std::string::npos)) {
    result.refused.push_back(
        "It asks for code to run before or after main (attribute 'constructor').");
  }
  const bool attributes = hasAny({"__attribute__", "__attribute"}) || code.find("[[") != npos;
  if (attributes && hasAny({"section", "__section__", "ifunc", "__ifunc__", "alias", "__alias__",
                            "weak", "__weak__", "weakref", "__weakref__", "symver", "__symver__",
                            "no_sanitize", "__no_sanitize__", "naked", "__naked__"})) {
    result.refused.push_back(
        "It asks compiler and linker to treat a name unlike others (attributes 'section', 'alias', "
        "'weak' and the like), which an answer does not need.");
  }
  if (hasAny({"__has_include", "__has_embed", "__has_include__", "_Pragma"})) {
    result.refused.push_back(
        "It asks which files there are (__has_include), or gives orders to the compiler where "
        "nobody sees them (_Pragma).");
  }
  // Such words can be put together where no reader sees them.
  if (code.find("##") != std::string::npos || code.find("%:%:") != std::string::npos ||
      hasAny({"__CONCAT", "EIGEN_CAT", "EIGEN_CAT2"})) {
    result.refused.push_back("It pastes names together (##), which an answer does not need.");
  }
  for (const auto& line : splitLines(code)) {
    const std::string text = trimmed(line);
    if (!text.starts_with("#")) continue;
    const std::string directive = trimmed(text.substr(1));
    if (directive.starts_with("line") ||
        (!directive.empty() && std::isdigit(static_cast<unsigned char>(directive[0])))) {
      result.refused.push_back("It says that it is another file or line: #" + directive);
    }
    if (directive.starts_with("pragma") &&
        (hasWord(directive, "dependency") || hasWord(directive, "pch_preprocess"))) {
      result.refused.push_back("It asks for files: #" + directive);
    }
    if (directive.starts_with("include") || directive.starts_with("import") ||
        directive.starts_with("embed")) {
      const auto quote = directive.find_first_of("\"<");
      const std::string path = quote == std::string::npos ? "" : directive.substr(quote + 1);
      if (path.empty()) {
        result.refused.push_back("It includes a file whose name it computes: " + directive);
      } else if (path.starts_with("/") || path.find("..") != std::string::npos) {
        result.refused.push_back("It includes a file outside the course: " + directive);
      } else if (isTest && path.starts_with("support/catch.hpp")) {
        continue;
      } else if (path.starts_with("grading/") || path.starts_with("support/") ||
                 path.starts_with("catch2/")) {
        result.refused.push_back("It includes the grader's own files: " + directive);
      }
    }
  }
  // They quote the file.
  for (auto& reason : result.refused) reason = printable(reason);
}

void screenIncludes(const Project& project, const Exercise& exercise,
                    const std::vector<fs::path>& included, const fs::path& source,
                    Screening& result) {
  std::error_code none;
  auto real = [&](const fs::path& path) {
    const auto canonical = fs::weakly_canonical(path, none);
    return none ? path : canonical;
  };
  auto below = [](const fs::path& path, const fs::path& folder) {
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    static_cast<void>(rest);
    return end == folder.end();
  };
  const auto& entry = project.entry(exercise);
  std::vector<fs::path> course = {real(entry.at("home").get<std::string>()),
                                  real(project.text("no_geometry_include"))};
  for (const auto& include : project.manifest.at("includes"))
    course.push_back(real(include.get<std::string>()));
  if (exercise.isTest()) course.push_back(real(project.root / "tests/support"));
  std::vector<fs::path> system = {"/usr", "/opt", "/nix/store", "/gnu/store"};
  for (const auto& include : project.manifest.at("system_includes")) {
    if (!include.get<std::string>().empty()) system.push_back(real(include.get<std::string>()));
  }
  const fs::path own = real(source);
  // What the build puts in front of every submission.
  const fs::path precompiled = real(project.build / "course_pch");
  const fs::path root = real(project.root);
  const bool noGeometry = entry.at("no_geometry").get<bool>();
  for (const auto& file : included) {
    const fs::path path = real(file);
    if (path == own || below(path, precompiled)) continue;
    auto holds = [&](const fs::path& folder) { return below(path, folder); };
    if (std::any_of(course.begin(), course.end(), holds)) {
      if (path.extension() == ".hpp" || below(path, course[1])) continue;
      result.refused.push_back("It includes the library's own code, " + path.filename().string() +
                               ": that is the answer itself.");
      return;
    }
    if (below(path, root) || std::none_of(system.begin(), system.end(), holds)) {
      result.refused.push_back("It includes a file outside the course: " + file.string());
      return;
    }
    if (!noGeometry) continue;
    for (const char* part : {"Geometry", "LU", "SVD", "Eigenvalues"}) {
      if (path.string().find(std::string("/Eigen/src/") + part + "/") == std::string::npos)
        continue;
      result.refused.push_back(std::string("It includes Eigen/") + part +
                               ": this exercise writes by hand what is there.");
      return;
    }
  }
}

void screenObject(const Project& project, const Exercise& exercise, const fs::path& object,
                  const fs::path& library, const fs::path& stage, Screening& result,
                  const grading::Sandbox* sandbox) {
  std::set<std::string> wanted;
  for (const auto& symbol : symbolsOf(project, library)) {
    if (symbol.type == 'T') wanted.insert(symbol.name);
  }
  std::set<std::string> available;
  for (const auto& symbol : symbolsOf(project, stage)) {
    if (symbol.type != 'U') available.insert(symbol.name);
  }
  // Test cases call the function instead of defining it.
  const bool isTest = exercise.isTest();
  if (isTest) available.merge(wanted);
  if (isTest) wanted.clear();
  std::set<std::string> defined;
  std::set<std::string> printing;
  std::set<std::string> seen;
  auto refuse = [&](const std::string& reason) {
    if (seen.insert(reason).second) result.refused.push_back(printable(reason));
  };

  const auto symbols = symbolsOf(project, object, sandbox);
  for (const auto& symbol : symbols) {
    if (symbol.type != 'U' && symbol.type != 'w') defined.insert(symbol.name);
  }
  for (const auto& symbol : symbols) {
    const std::string name = demangled(symbol.name);
    const bool mangled = symbol.name.rfind("_Z", 0) == 0;
    if (std::string("TDBRVWu").find(symbol.type) != std::string::npos) {
      // Template instances and inline functions are weak; a strong definition is the file's own.
      if (symbol.name == "main") {
        refuse("It defines main: the grader has its own.");
      } else if (!mangled && symbol.name.rfind("DW.ref.", 0) != 0) {
        refuse("It defines the C symbol '" + symbol.name +
               "', which could replace one of the system.");
      } else if (beginsWithAny(name, {"operator new", "operator delete"})) {
        refuse("It replaces " + name + ".");
      } else if (isTest && symbol.type != 'T' && symbol.type != 'D' && symbol.type != 'B') {
        // Catch2's templates, made for what the cases compare.
      } else if (beginsWithAny(name, {"Catch::", "carom::grading::", "carom_test::"})) {
        refuse("It defines " + name + ", which belongs to the grader.");
      }
      continue;
    }
    if (symbol.type == 'i') {
      refuse("It has " + name +
             " chosen while the program is loaded (ifunc), before anything runs.");
      continue;
    }
    if (symbol.type != 'U' && symbol.type != 'w' && symbol.type != 'v') continue;
    if (kAllowedC.count(symbol.name)) continue;
    if (isTest && name.find("Catch::") != std::string::npos) continue;
    // The float and long double forms: sinf, sinl.
    if (!mangled && symbol.name.size() > 1 &&
        (symbol.name.ends_with("f") || symbol.name.ends_with("l")) &&
        kAllowedC.count(symbol.name.substr(0, symbol.name.size() - 1))) {
      continue;
    }
    if (kPrinting.count(symbol.name)) {
      printing.insert(symbol.name);
      continue;
    }
    if (beginsWithAny(symbol.name, {"__cxa_", "__asan_", "__ubsan_"}) &&
        symbol.name != "__cxa_at_quick_exit") {
      if (symbol.name.rfind("__asan_", 0) != 0 && symbol.name.rfind("__ubsan_", 0) != 0) continue;
      continue;
    }
    if (kEnding.count(symbol.name) ||
        beginsWithAny(name, {"std::terminate", "std::quick_exit", "std::exit"})) {
      refuse("It calls " + name + ", which ends or interrupts the program: an answer is returned.");
      continue;
    }
    if (beginsWithAny(name, {"std::cout", "std::cerr", "std::clog", "std::ios_base::Init",
                             "std::ostream", "std::basic_ostream", "std::ctype", "std::__ostream",
                             "std::__throw_bad_cast"})) {
      printing.insert("std::cout");
      continue;
    }
    if (name.find("basic_ifstream") != std::string::npos ||
        name.find("basic_ofstream") != std::string::npos ||
        name.find("basic_fstream") != std::string::npos ||
        name.find("basic_filebuf") != std::string::npos ||
        name.find("std::filesystem") != std::string::npos ||
        name.find("std::thread") != std::string::npos) {
      refuse("It uses " + name + ": an answer is computed from the arguments alone.");
      continue;
    }
    if (beginsWithAny(name, {"std::", "operator new", "operator delete",
                             "vtable for std::", "typeinfo for std::", "vtable for __cxxabiv1",
                             "typeinfo name for std::", "__gnu_cxx::", "typeinfo for "}) ||
        name.find(" std::") != std::string::npos || name.find("vtable for carom::") == 0) {
      continue;
    }
    if (mangled && name.find("carom::") != std::string::npos) {
      if (available.count(symbol.name) || defined.count(symbol.name)) continue;
      if (name.find("carom::grading") != std::string::npos ||
          name.find("carom_test") != std::string::npos) {
        refuse("It calls " + name + ", which belongs to the grader.");
      } else {
        refuse("It calls " + name +
               ", which this exercise does not have: either it belongs to a later chapter, or it "
               "would be the answer "
               "itself.");
      }
      continue;
    }
    refuse("It calls " + name +
           ", which an exercise does not need: only mathematics, the standard containers and "
           "algorithms, Eigen and the earlier chapters are available.");
  }
  for (const auto& symbol : wanted) {
    if (!defined.count(symbol)) {
      refuse("It does not define " + demangled(symbol) +
             ". Keep the name, the parameters and the namespace as the skeleton has them.");
    }
  }
  // What cases compare is printed by Catch2, in their object file.
  if (!printing.empty() && !isTest) {
    result.notes.push_back(
        "It prints. That is fine while you look for a mistake; the grader reads only what is "
        "returned.");
  }
}

std::vector<std::string> definedFunctions(const Project& project, const fs::path& object) {
  std::vector<std::string> names;
  for (const auto& symbol : symbolsOf(project, object)) {
    if (symbol.type != 'T') continue;
    const std::string name = demangled(symbol.name);
    names.push_back(name.substr(0, name.find('(')));
  }
  return names;
}

}  // namespace carom::runner

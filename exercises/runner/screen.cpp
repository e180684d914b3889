#include "runner/screen.hpp"

#include <cxxabi.h>

#include <cstdlib>
#include <map>
#include <set>

#include "grading/process.hpp"

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

std::vector<Symbol> symbolsOf(const Project& project, const fs::path& object) {
  grading::Command command;
  command.words = {project.text("nm"), "-P", object.string()};
  command.limits.outputKilobytes = 64 << 10;
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

// Comments and the insides of texts replaced by spaces, so that the word "main" in a remark counts for nothing.
std::string codeOnly(std::string_view source) {
  std::string code(source);
  enum { plain, lineComment, blockComment, text, character } where = plain;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    const char next = i + 1 < code.size() ? code[i + 1] : '\0';
    switch (where) {
      case plain:
        if (c == '/' && next == '/') where = lineComment;
        if (c == '/' && next == '*') where = blockComment;
        if (c == '"') where = text;
        // A quote behind a digit separates digits: 1'000.
        if (c == '\'' && !(i > 0 && std::isalnum(static_cast<unsigned char>(code[i - 1]))))
          where = character;
        if (where == lineComment || where == blockComment) code[i] = ' ';
        break;
      case lineComment:
        if (c == '\n')
          where = plain;
        else
          code[i] = ' ';
        break;
      case blockComment:
        if (c == '*' && next == '/') {
          code[i] = code[i + 1] = ' ';
          ++i;
          where = plain;
        } else if (c != '\n') {
          code[i] = ' ';
        }
        break;
      case text:
      case character:
        if (c == '\\')
          ++i;
        else if (c == '\n' || c == (where == text ? '"' : '\''))
          where = plain;
        break;
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

void screenSource(std::string_view source, Screening& result) {
  if (source.size() > (256u << 10)) result.refused.push_back("The file is larger than 256 kB.");
  if (source.find('\0') != std::string_view::npos)
    result.refused.push_back("The file is not text: it holds a zero byte.");
  const std::string code = codeOnly(source);
  for (const char* word : {"asm", "__asm", "__asm__"}) {
    if (hasWord(code, word)) {
      result.refused.push_back(
          "It holds assembly code, which can do anything: an answer is written in C++.");
      break;
    }
  }
  if (hasWord(code, "constructor") && hasWord(code, "__attribute__")) {
    result.refused.push_back("It asks for code to run before main (attribute 'constructor').");
  }
  for (const auto& line : splitLines(code)) {
    const std::string text = trimmed(line);
    if (!text.starts_with("#")) continue;
    const std::string directive = trimmed(text.substr(1));
    if (directive.starts_with("include") || directive.starts_with("import") ||
        directive.starts_with("embed")) {
      const auto quote = directive.find_first_of("\"<");
      const std::string path = quote == std::string::npos ? "" : directive.substr(quote + 1);
      if (path.starts_with("/") || path.find("..") != std::string::npos) {
        result.refused.push_back("It includes a file outside the course: " + directive);
      } else if (path.starts_with("grading/") || path.starts_with("support/") ||
                 path.starts_with("catch2/")) {
        result.refused.push_back("It includes the grader's own files: " + directive);
      }
    }
  }
}

void screenObject(const Project& project, const fs::path& object, const fs::path& library,
                  const fs::path& stage, Screening& result) {
  std::set<std::string> wanted;
  for (const auto& symbol : symbolsOf(project, library)) {
    if (symbol.type == 'T') wanted.insert(symbol.name);
  }
  std::set<std::string> available;
  for (const auto& symbol : symbolsOf(project, stage)) {
    if (symbol.type != 'U') available.insert(symbol.name);
  }
  std::set<std::string> defined;
  std::set<std::string> printing;
  std::set<std::string> seen;
  auto refuse = [&](const std::string& reason) {
    if (seen.insert(reason).second) result.refused.push_back(reason);
  };

  const auto symbols = symbolsOf(project, object);
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
      } else if (beginsWithAny(name, {"Catch::", "carom::grading::", "carom_test::"})) {
        refuse("It defines " + name + ", which belongs to the grader.");
      }
      continue;
    }
    if (symbol.type != 'U' && symbol.type != 'w' && symbol.type != 'v') continue;
    if (kAllowedC.count(symbol.name)) continue;
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
  if (!printing.empty()) {
    result.notes.push_back(
        "It prints. That is fine while you look for a mistake; the grader reads only what is "
        "returned.");
  }
}

}  // namespace carom::runner

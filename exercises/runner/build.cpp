#include "runner/build.hpp"

#include <unistd.h>

#include <atomic>
#include <optional>

#include "runner/confine.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

std::vector<std::string> list(const json& array) {
  std::vector<std::string> all;
  for (const auto& element : array) {
    // A generator expression without content leaves an empty text behind.
    if (!element.get<std::string>().empty()) all.push_back(element.get<std::string>());
  }
  return all;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

fs::path link(const Project& project, const std::vector<std::string>& inputs,
              const fs::path& target, const grading::Sandbox* sandbox = nullptr) {
  std::optional<OutFolder> out;
  if (sandbox) out.emplace(target.parent_path());
  const fs::path name = target.filename();
  grading::Command command;
  command.words = {project.text("compiler")};
  append(command.words, list(project.manifest.at("flags")));
  append(command.words, inputs);
  append(command.words, {"-o", (out ? out->path() / name : target).string()});
  command.limits = {.wallSeconds = 120, .cpuSeconds = 60, .outputKilobytes = 1024};
  if (sandbox) {
    // A plugin would run what an object asks it to.
    if (project.text("compiler_id") == "GNU")
      append(command.words, {"-fno-lto", "-fno-use-linker-plugin"});
    std::vector<fs::path> files;
    for (const auto& input : inputs) {
      if (input.starts_with("/")) files.emplace_back(input);
    }
    command.limits.fileKilobytes = 256 << 10;
    command = confinedTool(project, std::move(command), files, out->path(), *sandbox);
  }
  const auto done = grading::run(command);
  if (!done.ok() || (out && !out->take(name.string(), target)))
    throw Failure{ourFault, "linking " + target.filename().string() + " failed: " + done.end +
                                "\n" + printable(done.output)};
  return target;
}

// The commonest messages of g++ and clang in plain words.
std::string inPlainWords(const std::string& error) {
  struct Case {
    const char* part;
    const char* words;
  };
  static const Case cases[] = {
      {"expected ';'", "A semicolon is missing, probably at the end of the line before."},
      {"was not declared in this scope",
       "This name is not known here: is it spelled right, and is its header included?"},
      {"use of undeclared identifier",
       "This name is not known here: is it spelled right, and is its header included?"},
      {"no matching function for call",
       "The function exists, but not with these arguments: compare their number and types."},
      {"expected '}'", "A closing brace is missing somewhere above."},
      {"expected primary-expression",
       "Something is missing in this expression: an operand, or a closing parenthesis."},
      {"could not convert", "This value has another type than is asked for here."},
      {"cannot convert", "This value has another type than is asked for here."},
      {"invalid operands", "These two types cannot be combined with this operator."},
      {"no match for", "These two types cannot be combined with this operator."},
      {"No such file or directory",
       "The included file does not exist, or is not available in this exercise."},
      {"file not found", "The included file does not exist, or is not available in this exercise."},
      {"redefinition of", "This name is defined twice."},
      {"discards qualifiers", "The argument is const: it may be read, not changed."},
      {"read-only", "The argument is const: it may be read, not changed."},
      {"has no member named", "The type has no member of this name: look at its header."},
      {"no member named", "The type has no member of this name: look at its header."},
      {"YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES",
       "Two Eigen objects of different sizes are combined here."},
      {"INVALID_MATRIX_PRODUCT", "These two matrices cannot be multiplied: compare their sizes."},
  };
  for (const auto& c : cases) {
    if (error.find(c.part) != std::string::npos) return c.words;
  }
  return "";
}

// The files in a rule of make, `x.o: a.cpp b.hpp \`; blanks in their names are escaped.
std::vector<fs::path> includedFiles(std::string_view rule) {
  std::vector<fs::path> files;
  const auto colon = rule.find(": ");
  if (colon == std::string_view::npos) return files;
  std::string name;
  for (std::size_t i = colon + 1; i <= rule.size(); ++i) {
    const char c = i < rule.size() ? rule[i] : '\n';
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\n';
    if (c == '\\' && (next == ' ' || next == '#' || next == '\\')) {
      name += next;
      ++i;
    } else if (c == '$' && next == '$') {
      name += c;
      ++i;
    } else if (c == ' ' || c == '\n' || (c == '\\' && next == '\n')) {
      if (!name.empty()) files.emplace_back(name);
      name.clear();
    } else {
      name += c;
    }
  }
  return files;
}

}  // namespace

WorkFolder::WorkFolder(const Project& project) {
  static std::atomic<int> counter{0};
  path_ = project.build / "work" / (std::to_string(getpid()) + "-" + std::to_string(counter++));
  fs::create_directories(path_);
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Compiled compileSubmission(const Project& project, const Exercise& exercise, const fs::path& source,
                           const fs::path& folder, int cpuSeconds, const grading::Sandbox* sandbox,
                           const std::vector<std::string>& moreFlags) {
  std::optional<OutFolder> out;
  if (sandbox) out.emplace(folder);
  const auto& entry = project.entry(exercise);
  grading::Command command;
  command.words = {project.text("compiler")};
  // Messages in English and with plain quotes, whatever language is set: they are read below.
  command.environment = {"LC_ALL=C"};
  append(command.words, list(project.manifest.at("flags")));
  append(command.words, list(project.manifest.at(exercise.isTest() ? "test_submission_flags"
                                                                   : "submission_flags")));
  if (entry.at("no_geometry").get<bool>())
    command.words.push_back("-I" + project.text("no_geometry_include"));
  for (const auto& include : list(project.manifest.at("includes")))
    command.words.push_back("-I" + include);
  command.words.push_back("-I" + entry.at("home").get<std::string>());
  for (const auto& include : list(project.manifest.at("system_includes"))) {
    append(command.words, {"-isystem", include});
  }
  append(command.words, moreFlags);
  Compiled result;
  result.object = folder / (exercise.name + ".o");
  fs::path depends = result.object;
  depends += ".d";
  auto written = [&](const fs::path& file) {
    return (out ? out->path() / file.filename() : file).string();
  };
  append(command.words, {"-MD", "-MF", written(depends)});
  append(command.words, {"-c", source.string(), "-o", written(result.object)});
  command.limits = {.wallSeconds = cpuSeconds ? 3.0 * cpuSeconds : 60,
                    .cpuSeconds = cpuSeconds ? cpuSeconds : 20,
                    .memoryMegabytes = 2048,
                    .fileKilobytes = 64 << 10,
                    .outputKilobytes = 1024};
  if (sandbox)
    command = confinedCompiler(project, exercise, std::move(command), fs::absolute(source),
                               out->path(), *sandbox);
  const auto done = grading::run(command);
  result.ok = done.ok();
  if (out && result.ok) {
    result.ok = out->take(depends.filename(), depends) &&
                out->take(result.object.filename(), result.object);
  }
  // What it quotes is somebody else's.
  const std::string said = printable(done.output);
  result.full = said;
  result.seconds = done.seconds;
  result.included = includedFiles(readIfThere(depends).value_or(""));
  bool found = false;
  const auto lines = splitLines(said);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].find("warning:") != std::string::npos) ++result.warnings;
    const bool error = lines[i].find("error:") != std::string::npos;
    if (error && !found) {
      found = true;
      result.plain = inPlainWords(lines[i]);
      result.firstError = lines[i];
      // The source line and its caret follow.
      for (std::size_t j = i + 1; j < lines.size() && j < i + 3 && lines[j].starts_with(" "); ++j) {
        result.firstError += "\n" + lines[j];
      }
    }
  }
  // A compiler that breaks a limit is ended by the system, and its driver says so in these words.
  const bool limited = done.timedOut || done.exitCode < 0 ||
                       done.output.find("terminated program") != std::string::npos ||
                       done.output.find("virtual memory exhausted") != std::string::npos ||
                       done.output.find("out of memory") != std::string::npos;
  result.limited = !result.ok && limited;
  if (result.limited) {
    result.firstError = "the compiler was stopped: the file asks too much of it";
  } else if (!result.ok && !found) {
    result.firstError = trimmed(said);
  }
  return result;
}

fs::path linkSelfCheck(const Project& project, const Exercise& exercise, const fs::path& object,
                       const fs::path& folder) {
  const auto& entry = project.entry(exercise);
  std::vector<std::string> inputs = {object.string()};
  append(inputs, list(entry.at("test_objects")));
  append(inputs, list(project.manifest.at("grading_objects")));
  inputs.push_back(entry.at("stage").get<std::string>());
  append(inputs, list(project.manifest.at("catch_libraries")));
  return link(project, inputs, folder / "self_check");
}

fs::path linkChild(const Project& project, const Exercise& exercise, const fs::path& object,
                   const fs::path& folder, const grading::Sandbox* sandbox) {
  const auto& entry = project.entry(exercise);
  std::vector<std::string> inputs = {object.string()};
  append(inputs, list(entry.at("child_objects")));
  append(inputs, list(project.manifest.at("serve_objects")));
  inputs.push_back(entry.at("stage").get<std::string>());
  return link(project, inputs, folder / "child", sandbox);
}

fs::path linkTester(const Project& project, const Exercise& exercise, const fs::path& object,
                    const fs::path& folder, const grading::Sandbox* sandbox) {
  const auto& entry = project.entry(exercise);
  std::vector<std::string> inputs = {object.string()};
  append(inputs, list(entry.at("proxy_objects")));
  append(inputs, list(project.manifest.at("tester_objects")));
  inputs.push_back(entry.at("stage").get<std::string>());
  append(inputs, list(project.manifest.at("catch_libraries")));
  return link(project, inputs, folder / "tester", sandbox);
}

fs::path linkCases(const Project& project, const Exercise& exercise, const fs::path& object,
                   const fs::path& folder) {
  const auto& entry = project.entry(exercise);
  std::vector<std::string> inputs = {object.string(), entry.at("library_object").get<std::string>(),
                                     list(project.manifest.at("grading_objects")).back(),
                                     entry.at("stage").get<std::string>()};
  append(inputs, list(project.manifest.at("catch_libraries")));
  return link(project, inputs, folder / "cases");
}

fs::path linkProgram(const Project& project, const std::string& program,
                     const std::vector<std::pair<std::string, fs::path>>& replaced,
                     const fs::path& folder) {
  const auto& all = project.manifest.at("programs");
  const auto entry = all.find(program);
  if (entry == all.end()) throw Failure{usage, "there is no program " + program};
  std::vector<std::string> inputs = list(entry->at("objects"));
  auto replacement = [&](const std::string& seam) -> const fs::path* {
    for (const auto& [name, object] : replaced) {
      if (name == seam) return &object;
    }
    return nullptr;
  };
  auto addSeams = [&](const json& seams) {
    for (const auto& [seam, object] : seams.items()) {
      const fs::path* mine = replacement(seam);
      inputs.push_back(mine ? mine->string() : object.get<std::string>());
    }
  };
  addSeams(entry->at("seams"));
  for (const auto& name : list(entry->at("layers"))) {
    const auto& layer = project.manifest.at("layers").at(name);
    addSeams(layer.at("seams"));
    append(inputs, list(layer.at("objects")));
  }
  inputs.push_back(project.text(replaced.empty() ? "variant_library" : "variant_mine"));
  inputs.push_back(project.text("io_library"));
  append(inputs, list(project.manifest.at("io_links")));
  std::string name = program;
  return link(project, inputs, folder / name.substr(name.find('/') + 1));
}

}  // namespace carom::runner

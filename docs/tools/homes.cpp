#include "homes.hpp"

#include <algorithm>
#include <regex>

#include "text.hpp"

namespace site {
namespace {

namespace fs = std::filesystem;

// Every file below `folder` with one of the extensions, in alphabetical order.
std::vector<fs::path> filesBelow(const fs::path& folder,
                                 const std::vector<std::string>& extensions) {
  std::vector<fs::path> files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void add(std::vector<Home>& homes, const Home& home) {
  const auto same = [&home](const Home& other) { return other.reference == home.reference; };
  if (std::none_of(homes.begin(), homes.end(), same)) {
    homes.push_back(home);
  }
}

// Enters every tag of `line` for `home`.
void addTags(const std::string& line, const Home& home, Homes& homes) {
  static const std::regex tag(R"(\\(source|erratum)\{([0-9., ]+)\})");
  for (std::sregex_iterator it(line.begin(), line.end(), tag), end; it != end; ++it) {
    for (const std::string& number : split((*it)[2], ',')) {
      add((*it)[1] == "source" ? homes.equations[trimmed(number)] : homes.errata[trimmed(number)],
          home);
    }
  }
}

// The name that a declaration introduces: what stands before the first ( or { or = or ;.
std::string declaredName(const std::string& declaration) {
  static const std::regex templateHead(R"(^\s*template\s*<[^>]*>\s*)");
  static const std::regex attribute(R"(\[\[[^\]]*\]\])");
  std::string text = std::regex_replace(declaration, templateHead, "");
  text = std::regex_replace(text, attribute, "");
  static const std::regex leading(R"(^\s*(enum\s+class|enum|struct|class|concept|using)\s+(\w+))");
  std::smatch match;
  if (std::regex_search(text, match, leading)) {
    return match[2];
  }
  text = text.substr(0, text.find_first_of("({=;"));
  static const std::regex lastWord(R"((\w+)\s*$)");
  return std::regex_search(text, match, lastWord) ? match[1].str() : "";
}

void scanHeader(const fs::path& path, Homes& homes) {
  static const std::regex opensNamespace(R"(^(?:inline )?namespace ([\w:]+) \{)");
  static const std::regex opensType(R"(^(?:enum class|struct|class) (\w+))");
  const std::vector<std::string> lines = splitLines(readFile(path));
  std::string scope;
  std::string type;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (std::regex_search(lines[i], match, opensNamespace)) {
      scope = match[1].str() + "::";
    } else if (std::regex_search(lines[i], match, opensType)) {
      type = match[1];
    }
    const std::string line = trimmed(lines[i]);
    if (line.find("///") == std::string::npos ||
        line.find("\\source{") == line.find("\\erratum{")) {
      continue;  // no tag: both searches found nothing
    }
    std::string name = type;  // a tag behind or above a member belongs to the type
    if (lines[i].compare(0, 3, "///") == 0) {
      std::size_t next = i;
      while (next < lines.size() && trimmed(lines[next]).compare(0, 3, "///") == 0) {
        ++next;
      }
      std::string declaration;
      for (; next < lines.size(); ++next) {
        declaration += lines[next] + ' ';
        if (lines[next].find_first_of("({=;") != std::string::npos) {
          break;
        }
      }
      name = declaredName(declaration);
    }
    addTags(line, {scope + name, scope + name}, homes);
  }
}

void scanPage(const fs::path& path, Homes& homes) {
  const std::string text = readFile(path);
  const std::string label = pageLabel(text);
  static const std::regex section(R"(^#{2,}.*\{#([\w-]+)\}\s*$)");
  Home home{label, pageTitle(text)};
  for (const std::string& line : splitLines(text)) {
    std::smatch match;
    if (std::regex_search(line, match, section)) {
      home.reference = match[1];
    }
    addTags(line, home, homes);
  }
}

}  // namespace

std::string pageLabel(const std::string& pageText) {
  static const std::regex label(R"(^(?:# .*\{#([\w-]+)\}|[\\@]page ([\w-]+) ))");
  std::smatch match;
  const std::string head = pageText.substr(0, pageText.find('\n'));
  if (!std::regex_search(head, match, label)) {
    return "";
  }
  return match[1].matched ? match[1] : match[2];
}

std::string pageTitle(const std::string& pageText) {
  static const std::regex title(R"(^(?:# (.*?)\s*\{#[\w-]+\}|[\\@]page [\w-]+ (.*)))");
  std::smatch match;
  const std::string head = pageText.substr(0, pageText.find('\n'));
  if (!std::regex_search(head, match, title)) {
    return "";
  }
  return match[1].matched ? match[1] : match[2];
}

Homes findHomes(const fs::path& projectRoot) {
  Homes homes;
  for (const char* folder : {"lib/carom", "lib/carom_io", "chapters"}) {
    for (const fs::path& path : filesBelow(projectRoot / folder, {".hpp"})) {
      scanHeader(path, homes);
    }
  }
  for (const fs::path& path : filesBelow(projectRoot / "chapters", {".md"})) {
    scanPage(path, homes);
  }
  return homes;
}

}  // namespace site

#include "page_filter.hpp"

#include <iostream>
#include <regex>

#include "pages.hpp"
#include "text.hpp"

namespace site {
namespace {

std::string figureHtml(const std::string& kind, const std::string& source, const std::string& shows,
                       const std::string& caption) {
  const std::string text = htmlText(shows);
  const std::string drawn = kind == "figure"
                                ? "<img src=\"" + source + "\" alt=\"" + text + "\"/>"
                                : "<iframe class=\"carom-player\" loading=\"lazy\" src=\"" +
                                      source + "\" title=\"" + text + "\"></iframe>";
  return "\\htmlonly<figure class=\"carom-figure\">" + drawn + "<figcaption>" + htmlText(caption) +
         (kind == "figure" ? "" : " <a href=\"" + source + "\">Open it alone.</a>") +
         "</figcaption></figure>\\endhtmlonly";
}

// A file of code that opens on a click.
std::string foldedCode(const std::string& kind, const std::string& file) {
  const std::string name = htmlText(std::filesystem::path(file).filename().string());
  const std::string summary = kind == "program" ? "The whole program, " + name
                                                : "The library's version, " + name +
                                                      " (write your own first: it is an exercise)";
  return "\\htmlonly<details class=\"carom-plain\"><summary>" + summary +
         "</summary>\\endhtmlonly\n\\include " + file + "\n\\htmlonly</details>\\endhtmlonly";
}

// Is this a student's copy of the course, in which programs stand on functions that may be missing?
bool isStudents(const std::filesystem::path& projectRoot) {
  return !std::filesystem::exists(projectRoot / "solutions");
}

}  // namespace

bool filterPage(const std::filesystem::path& projectRoot, const std::filesystem::path& outputFolder,
                const std::filesystem::path& page) {
  static const std::regex figure(R"(^\\(figure|player) ([^|]+)\|([^|]+)\|([^|]+)$)");
  static const std::regex folded(R"(^\\(program|answer) (\S+)$)");
  const std::string chapter = page.parent_path().filename().string();
  bool complete = true;
  for (const std::string& line : splitLines(readFile(page))) {
    std::smatch match;
    if (trimmed(line) == "\\exercises") {
      std::cout << chapterExercises(projectRoot, chapter) << '\n';
    } else if (std::regex_match(line, match, figure)) {
      const std::string file = trimmed(match[2]);
      if (!std::filesystem::exists(outputFolder / chapter / file)) {
        if (isStudents(projectRoot)) {
          std::cout << "*A picture belongs here. Its program draws it when the functions that it "
                       "stands on are written.*\n";
          continue;
        }
        std::cerr << page.string() << ": the chapter's programs wrote no " << file << '\n';
        complete = false;
      }
      std::cout << figureHtml(match[1], "programs/" + chapter + "/" + file, trimmed(match[3]),
                              trimmed(match[4]))
                << '\n';
    } else if (std::regex_match(line, match, folded)) {
      std::cout << foldedCode(match[1], match[2]) << '\n';
    } else {
      std::cout << line << '\n';
    }
  }
  return complete;
}

}  // namespace site

#include "pages.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <regex>
#include <sstream>
#include <vector>

#include "homes.hpp"
#include "text.hpp"

namespace site {
namespace {

namespace fs = std::filesystem;

struct Exercise {
  std::string id;
  std::string title;
  std::string kind;
  std::string level;
  std::string minutes;
  std::string chapter;
  fs::path statement;
};

// The folders with an exercise.ini: solutions/<chapter>/<name>, where exercises are authored, and in
// a student's copy of the course exercises/<chapter>/given/<name>.
std::vector<fs::path> exerciseFolders(const fs::path& projectRoot) {
  std::vector<fs::path> folders;
  std::error_code none;
  const auto addFrom = [&](const fs::path& above) {
    for (const auto& folder : fs::directory_iterator(above, none)) {
      if (fs::exists(folder.path() / "exercise.ini")) {
        folders.push_back(folder.path());
      }
    }
  };
  for (const auto& chapter : fs::directory_iterator(projectRoot / "solutions", none)) {
    addFrom(chapter.path());
  }
  for (const auto& chapter : fs::directory_iterator(projectRoot / "exercises", none)) {
    addFrom(chapter.path() / "given");
  }
  return folders;
}

// All exercises, in the order of their chapters and, within one, of `order` or the id.
std::vector<Exercise> findExercises(const fs::path& projectRoot) {
  struct Found {
    int order;
    Exercise exercise;
  };
  std::vector<Found> found;
  for (const fs::path& folder : exerciseFolders(projectRoot)) {
    Settings settings = readSettings(folder / "exercise.ini");
    auto& general = settings[""];
    const std::string order = general.count("order") ? general["order"] : "1000";
    const fs::path above = folder.parent_path();
    const fs::path chapter = above.filename() == "given" ? above.parent_path() : above;
    found.push_back({std::stoi(order),
                     {general["id"], general["title"], general["kind"], general["level"],
                      general["minutes"], chapter.filename().string(), folder / "statement.md"}});
  }
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return std::tie(a.exercise.chapter, a.order, a.exercise.id) <
           std::tie(b.exercise.chapter, b.order, b.exercise.id);
  });
  std::vector<Exercise> exercises;
  for (const Found& item : found) {
    exercises.push_back(item.exercise);
  }
  return exercises;
}

std::string anchorOf(const Exercise& exercise) {
  std::string anchor = "exercise_" + exercise.id;
  std::replace_if(
      anchor.begin(), anchor.end(), [](char c) { return c == '.' || c == '-'; }, '_');
  return anchor;
}

// A page's file and label, if the chapter has been written: "" otherwise.
std::string chapterLabel(const fs::path& projectRoot, const std::string& folder) {
  const fs::path page = projectRoot / "chapters" / folder / "page.md";
  return fs::exists(page) ? pageLabel(readFile(page)) : "";
}

std::string homeCell(const std::map<std::string, std::vector<Home>>& homes,
                     const std::string& item) {
  const auto it = homes.find(item);
  if (it == homes.end()) {
    return "<span class=\"not-yet\">not yet</span>";
  }
  std::string cell;
  for (const Home& home : it->second) {
    cell += (cell.empty() ? "\\ref " : "<br/>\\ref ") + home.reference + " \"" + home.text + "\"";
  }
  return cell;
}

// An anchor that a plain link can name, with the dot of "3.8" kept.
std::string rowAnchor(const std::string& id) {
  return "\\htmlonly<span id=\"" + id + "\"></span>\\endhtmlonly ";
}

std::string tableHead(std::initializer_list<const char*> titles) {
  std::string head = "<div class=\"carom-table\"><table>\n<tr>";
  for (const char* title : titles) {
    head += std::string("<th>") + title + "</th>";
  }
  return head + "</tr>\n";
}

constexpr const char* kTableEnd = "</table></div>\n\n";

std::size_t countHomes(const std::vector<std::vector<std::string>>& rows,
                       const std::map<std::string, std::vector<Home>>& homes) {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&homes](const auto& row) { return homes.count(row[0]) > 0; }));
}

std::string sourceEquationsPage(const std::vector<std::vector<std::string>>& rows,
                                const Homes& homes) {
  std::ostringstream page;
  page << "# Source equations {#source_equations}\n\n"
       << "The course follows a Dutch school thesis on the simulation of collisions (\\ref "
          "ref_source).\n"
       << "It has 56 numbered equations.\n"
       << "Here is what each says, and where this project computes or discusses it: "
       << countHomes(rows, homes.equations) << " of " << rows.size() << " have a home so far.\n"
       << "An equation that is wrong in the source is given in its right form; \\ref errata lists "
          "the "
          "differences.\n\n"
       << tableHead({"Equation", "Section", "What it says", "Chapter", "Home"});
  for (const auto& row : rows) {
    page << "<tr><td>" << rowAnchor("eq_" + row[0]) << '(' << row[0] << ")</td><td>" << row[1]
         << "</td><td>" << cellText(row[3]) << "</td><td>" << row[2] << "</td><td>"
         << homeCell(homes.equations, row[0]) << "</td></tr>\n";
  }
  page << kTableEnd;
  return page.str();
}

std::string errataPage(const std::vector<std::vector<std::string>>& rows, const Homes& homes) {
  std::ostringstream page;
  page << "# Errata {#errata}\n\n"
       << "A school thesis that covers this much ground so clearly is a fine thing to learn from.\n"
       << "Its slips are the slips that every learner makes, so each becomes a lesson and a test "
          "here.\n"
       << "Grade **A** is a formula or listing that gives wrong results, **B** a wrong statement, "
          "**C** an "
          "imprecise or misleading one.\n"
       << "Of " << rows.size() << " items, " << countHomes(rows, homes.errata)
       << " have a home in a chapter or a function so far.\n\n";
  std::string section;
  for (const auto& row : rows) {
    const std::string rowSection = row[0].substr(0, row[0].find('.'));
    if (rowSection != section) {
      page << (section.empty() ? "" : kTableEnd) << "## Section " << rowSection
           << " of the source\n\n"
           << tableHead({"Item", "Grade", "Where", "What the source says", "What is right",
                         "Chapter", "Home"});
      section = rowSection;
    }
    page << "<tr><td>" << rowAnchor("erratum_" + row[0]) << row[0] << "</td><td>" << row[1]
         << "</td><td>" << cellText(row[2]) << "</td><td>" << cellText(row[4]) << "</td><td>"
         << cellText(row[5]) << "</td><td>" << row[3] << "</td><td>"
         << homeCell(homes.errata, row[0]) << "</td></tr>\n";
  }
  page << kTableEnd;
  return page.str();
}

// `linked`: the chapter's page exists and holds the statement.
std::string exerciseRow(const Exercise& exercise, bool linked) {
  const std::string id =
      linked ? "\\ref " + anchorOf(exercise) + " \"" + exercise.id + "\"" : exercise.id;
  return "<tr><td>" + id + "</td><td class=\"wide\">" + cellText(exercise.title) + "</td><td>" +
         exercise.kind + "</td><td>" + exercise.level + "</td><td>" + exercise.minutes +
         "</td></tr>\n";
}

std::string exercisesPage(const fs::path& projectRoot, const std::vector<Exercise>& exercises) {
  std::ostringstream page;
  page << "# Exercises {#exercises}\n\n"
       << "Every exercise is one function in one file below `exercises/`.\n"
       << "You edit the file and run `./course check` with its name; the verdict comes within "
          "seconds.\n"
       << "`./course` without a word after it shows where you stand and what comes next.\n\n"
       << "- **implement**: write the function.\n"
       << "- **fix**: it is written, and wrong. Find out where.\n"
       << "- **predict**: write down the number before the program shows it.\n"
       << "- **test**: write the cases that tell right from wrong.\n"
       << "- **measure**: produce a table; its slope is judged.\n"
       << "- **explore**: no verdict, a question to play with.\n\n";
  std::string chapter;
  for (const Exercise& exercise : exercises) {
    if (exercise.chapter != chapter) {
      const std::string label = chapterLabel(projectRoot, exercise.chapter);
      page << (chapter.empty() ? "" : kTableEnd) << "## "
           << (label.empty() ? exercise.chapter : "Chapter \\ref " + label) << "\n\n"
           << tableHead({"Exercise", "Title", "Kind", "Level", "Minutes"});
      chapter = exercise.chapter;
    }
    page << exerciseRow(exercise, !chapterLabel(projectRoot, exercise.chapter).empty());
  }
  page << (chapter.empty() ? "" : kTableEnd);
  return page.str();
}

// The table of layers, read from the build's own: set(CAROM_USES_<layer> <layer>...).
std::string layersDot(const fs::path& projectRoot,
                      const std::vector<std::vector<std::string>>& chapters) {
  const std::string table = readFile(projectRoot / "lib/cmake/CaromLayers.cmake");
  static const std::regex uses(R"re(set\(CAROM_USES_(\w+) "?([\w ]*)"?\))re");
  std::ostringstream dot;
  dot << "digraph layers {\n  rankdir=TB;\n  bgcolor=\"white\";\n"
      << "  node [shape=box, style=\"rounded,filled\", fillcolor=\"#e6f2ee\", color=\"#0f6b4f\", "
         "fontname=\"Helvetica\", fontsize=13];\n  edge [color=\"#57606a\"];\n";
  for (std::sregex_iterator it(table.begin(), table.end(), uses), end; it != end; ++it) {
    const std::string layer = (*it)[1];
    std::string taught;
    for (const auto& chapter : chapters) {
      const std::vector<std::string> layers = split(chapter[3], ' ');
      if (std::find(layers.begin(), layers.end(), layer) != layers.end()) {
        taught += (taught.empty() ? "" : ", ") + chapter[0];
      }
    }
    const bool written = fs::exists(projectRoot / "lib/carom" / layer / "CMakeLists.txt");
    dot << "  " << layer << " [label=\"" << layer << "\\nchapter " << taught << "\""
        << (written ? "" : ", style=\"rounded,dashed\"") << "];\n";
    for (const std::string& used : split((*it)[2], ' ')) {
      if (!used.empty()) {
        dot << "  " << layer << " -> " << used << ";\n";
      }
    }
  }
  dot << "}\n";
  return dot.str();
}

std::string chaptersPage(const fs::path& projectRoot,
                         const std::vector<std::vector<std::string>>& chapters) {
  std::ostringstream page;
  page << "# Chapters {#chapters}\n\n"
       << "Each chapter teaches one layer of the library, from the numbers up to the engine.\n"
       << "Read them in order: a chapter uses only what earlier ones introduced.\n\n";
  for (const auto& row : chapters) {
    const std::string label = chapterLabel(projectRoot, row[1]);
    if (label.empty()) {
      page << "- " << row[0] << ' ' << cellText(row[2])
           << " <span class=\"not-yet\">(not yet)</span> - " << cellText(row[4]) << '\n';
    } else {
      page << "- \\subpage " << label << " - " << cellText(row[4]) << '\n';
    }
  }
  page << "\n## The layers of the library {#layers}\n\n"
       << "An arrow points from a layer to one that it uses; a dashed box is a layer that is not "
          "written "
          "yet.\n\n"
       << "\\htmlonly<figure class=\"carom-figure\"><img src=\"layers.svg\" alt=\"The layers from "
          "core at "
          "the bottom to world at the top, each with its chapter and arrows to the layers it "
          "uses.\"/><figcaption>Drawn from the table that the build itself "
          "obeys.</figcaption></figure>\\endhtmlonly\n";
  return page.str();
}

bool tagsExist(const std::map<std::string, std::vector<Home>>& homes,
               const std::vector<std::vector<std::string>>& rows, const char* kind) {
  bool allExist = true;
  for (const auto& [item, places] : homes) {
    const std::string wanted = item;
    if (std::none_of(rows.begin(), rows.end(), [&](const auto& row) { return row[0] == wanted; })) {
      std::cerr << places.front().text << ": \\" << kind << "{" << item
                << "}: there is no such item\n";
      allExist = false;
    }
  }
  return allExist;
}

}  // namespace

std::string chapterExercises(const fs::path& projectRoot, const std::string& chapter) {
  std::ostringstream rows;
  std::ostringstream statements;
  for (const Exercise& exercise : findExercises(projectRoot)) {
    if (exercise.chapter != chapter) {
      continue;
    }
    rows << exerciseRow(exercise, true);
    statements << "### " << exercise.id << ": " << exercise.title << " {#" << anchorOf(exercise)
               << "}\n\n"
               << "*" << exercise.kind << ", level " << exercise.level << ", about "
               << exercise.minutes << " minutes.*\n\n"
               << trimmed(readFile(exercise.statement)) << "\n\nCheck it with `./course check "
               << exercise.id << "`.\n\n";
  }
  if (rows.str().empty()) {
    return "The exercises of this chapter are not written yet.\n";
  }
  return tableHead({"Exercise", "Title", "Kind", "Level", "Minutes"}) + rows.str() + kTableEnd +
         statements.str();
}

bool writePages(const fs::path& projectRoot, const fs::path& outputFolder) {
  const auto equations = readTable(projectRoot / "docs/source_equations.tsv", 4);
  const auto errata = readTable(projectRoot / "docs/errata.tsv", 6);
  const auto chapters = readTable(projectRoot / "docs/chapters.tsv", 5);
  const Homes homes = findHomes(projectRoot);

  writeFile(outputFolder / "source_equations.md", sourceEquationsPage(equations, homes));
  writeFile(outputFolder / "errata.md", errataPage(errata, homes));
  writeFile(outputFolder / "exercises.md", exercisesPage(projectRoot, findExercises(projectRoot)));
  writeFile(outputFolder / "chapters.md", chaptersPage(projectRoot, chapters));
  writeFile(outputFolder / "layers.dot", layersDot(projectRoot, chapters));

  const bool equationsExist = tagsExist(homes.equations, equations, "source");
  return tagsExist(homes.errata, errata, "erratum") && equationsExist;
}

}  // namespace site

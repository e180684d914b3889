// The part of the documentation that is made, not written.
//
//     site_pages pages  <project> <folder>         writes the generated pages into <folder>
//     site_pages filter <project> <output> <page>  prints a chapter page, figures filled in
//     site_pages check  <project> <output>         filters every chapter page, for its errors

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "page_filter.hpp"
#include "pages.hpp"

namespace {

bool checkChapters(const std::filesystem::path& project, const std::filesystem::path& output) {
  bool complete = true;
  std::ostringstream unseen;
  std::streambuf* const shown = std::cout.rdbuf(unseen.rdbuf());
  for (const auto& folder : std::filesystem::directory_iterator(project / "chapters")) {
    const auto page = folder.path() / "page.md";
    if (std::filesystem::exists(page)) {
      complete = site::filterPage(project, output, page) && complete;
    }
  }
  std::cout.rdbuf(shown);
  return complete;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "pages") {
    return site::writePages(words[1], words[2]) ? 0 : 1;
  }
  if (words.size() == 4 && words[0] == "filter") {
    return site::filterPage(words[1], words[2], words[3]) ? 0 : 1;
  }
  if (words.size() == 3 && words[0] == "check") {
    return checkChapters(words[1], words[2]) ? 0 : 1;
  }
  std::cerr << "usage: site_pages pages PROJECT FOLDER | filter PROJECT OUTPUT PAGE | check "
               "PROJECT OUTPUT\n";
  return 64;
}

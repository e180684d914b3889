#pragma once
// Small pieces of text work that the site's pages need: tables with tabs, settings with sections,
// escaping.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace site {

// The whole of a file; ends the program with a message when it cannot be read.
std::string readFile(const std::filesystem::path& path);

// Writes only when the text differs, so that file times do not change for nothing.
void writeFile(const std::filesystem::path& path, const std::string& text);

std::vector<std::string> splitLines(const std::string& text);
std::vector<std::string> split(const std::string& text, char separator);
std::string trimmed(const std::string& text);

// Rows of a file whose columns are separated by tabs; lines that start with # are comments.
std::vector<std::vector<std::string>> readTable(const std::filesystem::path& path,
                                                std::size_t columns);

// `key = value` lines under `[section]` lines; keys before the first section stand in section "".
using Settings = std::map<std::string, std::map<std::string, std::string>>;
Settings readSettings(const std::filesystem::path& path);

// Text for an HTML cell of a page that Doxygen reads: its special characters escaped, $...$ made a
// formula.
std::string cellText(const std::string& text);

// Escapes what HTML reserves, for text that goes into a page as it is (attributes, captions).
std::string htmlText(const std::string& text);

}  // namespace site

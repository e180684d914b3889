#pragma once
// Pages of the site that are made from the project's data instead of being written by hand.

#include <filesystem>
#include <string>

namespace site {

// Writes chapters.md, source_equations.md, errata.md, exercises.md and layers.dot into
// `outputFolder`. Returns false, after naming the fault, when a tag names an equation or an item
// that does not exist.
bool writePages(const std::filesystem::path& projectRoot,
                const std::filesystem::path& outputFolder);

// The exercises of one chapter, e.g. "00_start", as Markdown: a table, then each statement.
std::string chapterExercises(const std::filesystem::path& projectRoot, const std::string& chapter);

}  // namespace site

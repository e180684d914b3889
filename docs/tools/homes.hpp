#pragma once
// Where do the equations and the errata of the source live in the project?
//
// A documentation comment or a chapter page that carries \source{32,33} or \erratum{3.8} is a home
// of those items. This finds every such tag and the name of what it documents, so that the pages
// "Source equations" and "Errata" can link to it. A name that Doxygen does not know makes the
// site's build fail, which is how a tag that documents nothing is noticed.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace site {

struct Home {
  std::string reference;  // what \ref is given, e.g. carom::hamiltonProduct or chapter_01
  std::string text;       // what the link reads
};

struct Homes {
  std::map<std::string, std::vector<Home>> equations;  // by number, "32"
  std::map<std::string, std::vector<Home>> errata;     // by item, "3.8"
};

Homes findHomes(const std::filesystem::path& projectRoot);

// The label of a page written in Markdown: the id in its first heading, or after \page. "" without
// one.
std::string pageLabel(const std::string& pageText);

// The title of such a page.
std::string pageTitle(const std::string& pageText);

}  // namespace site

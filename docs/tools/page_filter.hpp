#pragma once
// Doxygen reads every chapter page through this filter, which expands what only the project knows:
//
//     \exercises                              the chapter's exercises: table and statements
//     \figure FILE | what it shows | caption  a picture that the chapter's program drew
//     \player FILE | what it shows | caption  a recording that the chapter's program wrote
//     \program FILE                            a whole file of code, folded away
//     \answer FILE                             the same, for a function that an exercise asks for
//
// The FILE of a picture or recording stands in the output folder of the chapter's programs. A file
// that is not there is an error of the site's build.

#include <filesystem>

namespace site {

// Prints the expanded page; false when something is missing.
bool filterPage(const std::filesystem::path& projectRoot, const std::filesystem::path& outputFolder,
                const std::filesystem::path& page);

}  // namespace site

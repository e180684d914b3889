#pragma once
// What a student hands in, in one file: the answers, and a list of them that whoever receives it can check.

#include "runner/manifest.hpp"

namespace carom::runner {

struct PackedFile {
  const Exercise* exercise = nullptr;
  std::string path;  ///< relative to the project, and in the archive
  std::string hash;  ///< SHA-256
  std::uintmax_t bytes = 0;
  bool untouched = false;  ///< it is the skeleton
};

/// The files to pack. \throws Failure (usage) naming every one that is missing, too large or no text, and every file
/// beside them that has no exercise's name: a misspelt name would not be graded
std::vector<PackedFile> filesToPack(const Project& project,
                                    const std::vector<const Exercise*>& which);

/// Writes a zip archive of the files and `carom-pack.json`, which says of each its exercise and hash, and of the
/// course its edition. The same files make the same bytes.
void writePack(const Project& project, const std::vector<PackedFile>& files, const fs::path& zip);

/// SHA-256 as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace carom::runner

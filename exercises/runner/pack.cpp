#include "runner/pack.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <openssl/evp.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <set>

#include "grading/process.hpp"
#include "runner/build.hpp"
#include "runner/skeleton.hpp"
#include "runner/state.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

constexpr std::uintmax_t kLargest = 256u << 10;  // what graders take

// The name that was probably meant: the one with the fewest letters to change.
std::string nearest(const std::string& name, const std::vector<std::string>& known) {
  std::string best;
  std::size_t least = name.size() / 2 + 1;
  for (const auto& other : known) {
    // Levenshtein's distance, a row at a time.
    std::vector<std::size_t> row(other.size() + 1);
    for (std::size_t j = 0; j <= other.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= name.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= other.size(); ++j) {
        const std::size_t changed = diagonal + (name[i - 1] != other[j - 1]);
        diagonal = row[j];
        row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
      }
    }
    if (row[other.size()] < least) {
      least = row[other.size()];
      best = other;
    }
  }
  return best;
}

std::string commitOf(const Project& project) {
  grading::Command git;
  git.words = {"git", "-C", project.root.string(), "rev-parse", "HEAD"};
  const auto done = grading::run(git);
  return done.ok() ? trimmed(done.output) : "";
}

}  // namespace

std::string sha256(std::string_view bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha256(), nullptr) != 1)
    throw Failure{ourFault, "SHA-256 is not available"};
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    text += "0123456789abcdef"[digest[i] >> 4];
    text += "0123456789abcdef"[digest[i] & 15];
  }
  return text;
}

std::vector<PackedFile> filesToPack(const Project& project,
                                    const std::vector<const Exercise*>& which) {
  std::vector<PackedFile> files;
  std::string problems;
  std::set<std::string> chapters;
  for (const auto* e : which) {
    chapters.insert(e->chapter);
    const std::string path = e->studentFile().string();
    const auto content = readIfThere(project.root / path);
    if (!content) {
      problems += "\n  " + path + " is missing: ./course reset " + e->id + " brings it back";
    } else if (content->size() > kLargest) {
      problems += "\n  " + path + " is larger than 256 kB";
    } else if (content->find('\0') != std::string::npos) {
      problems += "\n  " + path + " is not text: it holds a zero byte";
    } else {
      files.push_back({.exercise = e,
                       .path = path,
                       .hash = sha256(*content),
                       .bytes = content->size(),
                       .untouched = isSkeleton(project, *e)});
    }
  }
  for (const auto& chapter : chapters) {
    std::vector<std::string> known;
    for (const auto& e : project.exercises) {
      if (e.chapter == chapter) known.push_back(e.fileName());
    }
    std::error_code none;
    for (const auto& file : fs::directory_iterator(project.root / "exercises" / chapter, none)) {
      const std::string name = file.path().filename().string();
      const auto extension = file.path().extension();
      // What editors and compilers leave behind is nobody's answer.
      if (name.starts_with(".") || (extension != ".cpp" && extension != ".txt")) continue;
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      const std::string meant = nearest(name, known);
      problems +=
          "\n  exercises/" + chapter + "/" + name + " has no exercise's name" +
          (meant.empty() ? std::string(": move it elsewhere") : "; did you mean " + meant + "?");
    }
  }
  if (!problems.empty()) throw Failure{usage, "nothing is packed, because" + problems};
  return files;
}

void writePack(const Project& project, const std::vector<PackedFile>& files, const fs::path& zip) {
  const WorkFolder work(project);
  const fs::path fresh = work.path() / "pack.zip";
  const std::unique_ptr<archive, int (*)(archive*)> out(archive_write_new(), archive_write_free);
  const auto require = [&](int result) {
    if (result == ARCHIVE_OK) return;
    const char* why = archive_error_string(out.get());
    throw Failure{ourFault, std::string("the archive could not be written: ") + (why ? why : "")};
  };
  require(archive_write_set_format_zip(out.get()));
  require(archive_write_open_filename(out.get(), fresh.c_str()));
  const auto add = [&](const std::string& name, const std::string& content) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                         archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    // One time for all, and no other: the same answers make the same archive.
    constexpr std::time_t kNewYear2000 = 946684800;
    archive_entry_set_mtime(entry.get(), kNewYear2000, 0);
    require(archive_write_header(out.get(), entry.get()));
    if (archive_write_data(out.get(), content.data(), content.size()) < 0) require(ARCHIVE_FATAL);
  };
  json list = json::array();
  for (const auto& file : files) {
    list.push_back({{"id", file.exercise->id},
                    {"path", file.path},
                    {"sha256", file.hash},
                    {"bytes", file.bytes},
                    {"untouched", file.untouched}});
  }
  const json facts{{"carom", project.manifest.value("edition", "")},
                   {"commit", commitOf(project)},
                   {"files", list}};
  add("carom-pack.json", facts.dump(1) + "\n");
  for (const auto& file : files) add(file.path, readFile(project.root / file.path));
  require(archive_write_close(out.get()));
  std::error_code error;
  if (zip.has_parent_path()) fs::create_directories(zip.parent_path(), error);
  fs::copy_file(fresh, zip, fs::copy_options::overwrite_existing, error);
  if (error) throw Failure{usage, "cannot write " + zip.string() + ": " + error.message()};
}

}  // namespace carom::runner

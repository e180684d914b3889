#pragma once
// Archives as students and as enemies make them, for tests.

#include <archive.h>
#include <archive_entry.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace carom_test {

struct Packed {
  std::string path;
  std::string content = {};
  int type = AE_IFREG;
  std::string link = {};      ///< where a symbolic link leads
  std::string hardlink = {};  ///< what a hard link is another name of
};

enum class Pack { zip, zipEncrypted, tar, tarGz, tarXz };

inline void pack(const std::filesystem::path& file, Pack how, const std::vector<Packed>& entries) {
  const auto good = [](int result) {
    if (result < ARCHIVE_WARN) throw std::runtime_error("the archive cannot be written");
  };
  archive* a = archive_write_new();
  if (how == Pack::zip || how == Pack::zipEncrypted) {
    good(archive_write_set_format_zip(a));
    if (how == Pack::zipEncrypted) {
      good(archive_write_set_options(a, "zip:encryption=traditional"));
      good(archive_write_set_passphrase(a, "open sesame"));
    }
  } else {
    good(archive_write_set_format_pax_restricted(a));
    if (how == Pack::tarGz) good(archive_write_add_filter_gzip(a));
    if (how == Pack::tarXz) good(archive_write_add_filter_xz(a));
  }
  good(archive_write_open_filename(a, file.c_str()));
  for (const auto& packed : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, packed.path.c_str());
    archive_entry_set_filetype(entry, static_cast<unsigned>(packed.type));
    archive_entry_set_perm(entry, 0644);
    if (!packed.link.empty()) archive_entry_set_symlink(entry, packed.link.c_str());
    if (!packed.hardlink.empty()) archive_entry_set_hardlink(entry, packed.hardlink.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(packed.content.size()));
    good(archive_write_header(a, entry));
    if (!packed.content.empty() &&
        archive_write_data(a, packed.content.data(), packed.content.size()) < 0)
      throw std::runtime_error("the archive cannot be written");
    archive_entry_free(entry);
  }
  good(archive_write_close(a));
  archive_write_free(a);
}

}  // namespace carom_test

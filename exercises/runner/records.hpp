#pragma once
// What grading leaves behind in the folder of reports:
//
//   records/class.json                     what was graded, under which version
//   records/students/<student>.json        what came of it, check by check
//   records/files/<student>/<chapter>/...  the files that were graded
//
// They are the teacher's: hidden checks stand in them with their questions. The folders
// <student>/ beside them are the students'.

#include <nlohmann/json.hpp>
#include <vector>

#include "runner/text.hpp"

namespace carom::runner {

/// Everything that reports are made of.
struct Records {
  nlohmann::json course;                 ///< class.json
  std::vector<nlohmann::json> students;  ///< by name
};

/// The name of the folder with a student's reports: some names beside it are taken.
std::string folderOf(const std::string& student);
/// Where a student's record is.
fs::path recordFile(const fs::path& out, const std::string& student);
/// Where a student's graded files are.
fs::path filesFolder(const fs::path& out, const std::string& student);

/// \throws Failure (usage) when the folder holds no records or broken ones
Records readRecords(const fs::path& out);

/// Writes one file of records; text that is no UTF-8 is replaced.
void writeRecord(const fs::path& file, const nlohmann::json& record);

/// JSON as it is written to every report: sorted keys, valid UTF-8, a line break at the end.
std::string dumped(const nlohmann::json& value);

}  // namespace carom::runner

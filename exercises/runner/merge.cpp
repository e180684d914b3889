#include "runner/merge.hpp"

#include <algorithm>
#include <iostream>
#include <map>

#include "runner/reports.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

bool holdsRecords(const fs::path& folder) {
  return fs::exists(folder / "records/class.json");
}

// What must be the same for two grades to mean the same.
void checkAlike(const Records& first, const fs::path& firstFolder, const Records& other,
                const fs::path& folder) {
  const auto differs = [&](const char* key) {
    return first.course.value(key, json()) != other.course.value(key, json());
  };
  const std::string where = firstFolder.string() + " and " + folder.string();
  if (differs("title")) throw Failure{usage, where + " are of different courses"};
  if (differs("version"))
    throw Failure{usage, where + " were graded by different versions of the course"};
  if (differs("seeds") || differs("secret"))
    throw Failure{usage, where + " were graded with different secrets"};
  if (differs("exercises"))
    throw Failure{usage, where + " differ in exercises, points, dates or hidden checks"};
}

}  // namespace

int mergeReports(const std::vector<fs::path>& given, const fs::path& out) {
  std::vector<fs::path> folders;
  for (const auto& folder : given) {
    if (holdsRecords(folder)) {
      folders.push_back(folder);
      continue;
    }
    std::vector<fs::path> below;
    std::error_code none;
    for (const auto& child : fs::directory_iterator(folder, none)) {
      if (holdsRecords(child.path())) below.push_back(child.path());
    }
    if (below.empty()) throw Failure{usage, folder.string() + " holds no records of grades"};
    std::sort(below.begin(), below.end());
    folders.insert(folders.end(), below.begin(), below.end());
  }
  if (holdsRecords(out)) folders.insert(folders.begin(), out);

  Records all;
  fs::path firstFolder;
  std::map<std::string, std::pair<json, fs::path>> byStudent;
  std::string twice;
  for (const auto& folder : folders) {
    Records records = readRecords(folder);
    if (firstFolder.empty()) {
      firstFolder = folder;
      all.course = records.course;
    } else {
      checkAlike(all, firstFolder, records, folder);
      // Jobs run on different machines and days: the weakest sandbox is the one to know of.
      if (all.course["sandbox"] != records.course["sandbox"]) {
        std::string both = all.course["sandbox"];
        const std::string more = records.course["sandbox"];
        if (both.find(more) == both.npos) all.course["sandbox"] = both + "; elsewhere " + more;
      }
      if (all.course.value("today", "") < records.course.value("today", ""))
        all.course["today"] = records.course["today"];
    }
    for (auto& student : records.students) {
      const std::string name = student.at("student");
      const auto [at, fresh] = byStudent.try_emplace(name, student, folder);
      if (!fresh && at->second.first != student) {
        twice +=
            "\n  " + name + ": in " + at->second.second.string() + " and in " + folder.string();
      }
    }
  }
  if (!twice.empty()) throw Failure{usage, "graded twice, with different results:" + twice};
  int exitCode = Exit::pass;
  for (const auto& [name, found] : byStudent) {
    const auto& [student, folder] = found;
    const fs::path files = filesFolder(folder, name);
    if (folder != out && fs::exists(files)) {
      std::error_code none;
      fs::remove_all(filesFolder(out, name), none);
      fs::create_directories(filesFolder(out, name));
      fs::copy(files, filesFolder(out, name), fs::copy_options::recursive);
    }
    writeRecord(recordFile(out, name), student);
    if (gradeOf(all.course, student).state == "not graded") exitCode = Exit::ourFault;
  }
  writeRecord(out / "records/class.json", all.course);
  all = readRecords(out);
  writeReports(out, all);
  std::cout << "joined " << folders.size() << (folders.size() == 1 ? " folder" : " folders")
            << " of " << all.students.size() << " students into " << out.string() << "\n";
  return exitCode;
}

}  // namespace carom::runner

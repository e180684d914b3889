#include "runner/records.hpp"

#include <algorithm>

namespace carom::runner {

using nlohmann::json;

std::string folderOf(const std::string& student) {
  // Compared without capitals, which not every disk tells apart.
  std::string name = student;
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  for (const char* taken : {"records", "class.html", "grades.csv", "junit.xml"}) {
    if (name == taken) return student + "_";
  }
  return student;
}

std::string dumped(const json& value) {
  return value.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

fs::path recordFile(const fs::path& out, const std::string& student) {
  return out / "records/students" / (student + ".json");
}

fs::path filesFolder(const fs::path& out, const std::string& student) {
  return out / "records/files" / student;
}

void writeRecord(const fs::path& file, const json& record) {
  writeFile(file, dumped(record));
}

Records readRecords(const fs::path& out) {
  const auto read = [](const fs::path& file) {
    json parsed = json::parse(readIfThere(file).value_or(""), nullptr, false);
    if (!parsed.is_object() || parsed.value("format", 0) != 1)
      throw Failure{usage, file.string() + " is not a record of this grader"};
    return parsed;
  };
  const fs::path folder = out / "records";
  if (!fs::exists(folder / "class.json"))
    throw Failure{usage, out.string() + " holds no records: has course teach grade written there?"};
  Records records;
  records.course = read(folder / "class.json");
  std::error_code none;
  for (const auto& file : fs::directory_iterator(folder / "students", none)) {
    if (file.path().extension() == ".json") records.students.push_back(read(file.path()));
  }
  std::sort(records.students.begin(), records.students.end(), [](const json& a, const json& b) {
    return a.at("student").get<std::string>() < b.at("student").get<std::string>();
  });
  return records;
}

}  // namespace carom::runner

// Does every file of lib/carom include only what its layer may include?
//
// A layer's own folder, the layers below it, Eigen and the standard library; nothing else. The table is the one that
// the build has (lib/cmake/CaromLayers.cmake).

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace fs = std::filesystem;

namespace {

using Table = std::map<std::string, std::set<std::string>>;

const std::set<std::string> kStandard = {"algorithm",
                                         "any",
                                         "array",
                                         "atomic",
                                         "barrier",
                                         "bit",
                                         "bitset",
                                         "cassert",
                                         "cctype",
                                         "cerrno",
                                         "cfenv",
                                         "cfloat",
                                         "charconv",
                                         "chrono",
                                         "cinttypes",
                                         "climits",
                                         "clocale",
                                         "cmath",
                                         "compare",
                                         "complex",
                                         "concepts",
                                         "condition_variable",
                                         "csignal",
                                         "cstdarg",
                                         "cstddef",
                                         "cstdint",
                                         "cstdio",
                                         "cstdlib",
                                         "cstring",
                                         "ctime",
                                         "cwchar",
                                         "deque",
                                         "exception",
                                         "execution",
                                         "filesystem",
                                         "forward_list",
                                         "fstream",
                                         "functional",
                                         "future",
                                         "initializer_list",
                                         "iomanip",
                                         "ios",
                                         "iosfwd",
                                         "iostream",
                                         "istream",
                                         "iterator",
                                         "latch",
                                         "limits",
                                         "list",
                                         "locale",
                                         "map",
                                         "memory",
                                         "memory_resource",
                                         "mutex",
                                         "new",
                                         "numbers",
                                         "numeric",
                                         "optional",
                                         "ostream",
                                         "queue",
                                         "random",
                                         "ranges",
                                         "ratio",
                                         "regex",
                                         "scoped_allocator",
                                         "semaphore",
                                         "set",
                                         "shared_mutex",
                                         "span",
                                         "sstream",
                                         "stack",
                                         "stdexcept",
                                         "stop_token",
                                         "streambuf",
                                         "string",
                                         "string_view",
                                         "system_error",
                                         "thread",
                                         "tuple",
                                         "type_traits",
                                         "typeindex",
                                         "typeinfo",
                                         "unordered_map",
                                         "unordered_set",
                                         "utility",
                                         "valarray",
                                         "variant",
                                         "vector",
                                         "version"};

Table readTable(const fs::path& path) {
  Table table;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string layer;
    if (!(words >> layer)) continue;
    auto& allowed = table[layer];
    for (std::string word; words >> word;) allowed.insert(word);
  }
  return table;
}

// The file that a line includes; empty for other lines, "?" for a name that is computed.
std::string included(const std::string& line) {
  const auto hash = line.find_first_not_of(" \t");
  if (hash == std::string::npos || line[hash] != '#') return "";
  const auto word = line.find_first_not_of(" \t", hash + 1);
  if (word == std::string::npos || line.compare(word, 7, "include") != 0) return "";
  const auto open = line.find_first_of("\"<", word + 7);
  if (open == std::string::npos) return "?";
  const auto close = line.find(line[open] == '<' ? '>' : '"', open + 1);
  return close == std::string::npos ? "?" : line.substr(open + 1, close - open - 1);
}

// Why a file of `layer`, in `folder`, may not include `name`; empty where it may.
std::string objection(const Table& table, const std::string& layer, const fs::path& folder,
                      const std::string& name) {
  if (name == "?") return "the name of the file is computed";
  if (kStandard.count(name) || name.rfind("Eigen/", 0) == 0) return "";
  const std::string ours = "carom/";
  if (name.rfind(ours, 0) == 0) {
    const std::string other = name.substr(ours.size(), name.find('/', ours.size()) - ours.size());
    if (!table.count(other)) return "'" + other + "' is no layer";
    if (other == layer || table.at(layer).count(other)) return "";
    return "layer '" + layer + "' may not use '" + other + "'";
  }
  if (name.find("..") == std::string::npos && fs::exists(folder / name)) return "";
  return "neither a layer, Eigen nor the standard library";
}

std::vector<std::string> violations(const fs::path& root, const Table& table) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path& path = entry.path();
    const auto ending = path.extension();
    if (ending != ".hpp" && ending != ".cpp" && ending != ".h" && ending != ".ipp") continue;
    const fs::path relative = fs::relative(path, root);
    const std::string layer = relative.begin()->string();
    std::ifstream file(path);
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      const std::string name = included(line);
      if (name.empty()) continue;
      const std::string why = table.count(layer) ? objection(table, layer, path.parent_path(), name)
                                                 : "'" + layer + "' is no layer";
      if (!why.empty()) {
        found.push_back(relative.string() + ":" + std::to_string(number) + ": includes " + name +
                        ": " + why);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

TEST_CASE("the table of layers begins with core, which uses nothing") {
  const Table table = readTable(CAROM_LAYER_TABLE);
  REQUIRE(table.count("core"));
  CHECK(table.at("core").empty());
  CHECK(table.size() > 4);
  // No layer stands above itself.
  for (const auto& [layer, uses] : table) {
    CHECK_FALSE(uses.count(layer));
    for (const auto& used : uses) {
      CHECK(table.count(used));
      CHECK_FALSE(table.at(used).count(layer));
    }
  }
}

TEST_CASE("every file of the library includes only its own and lower layers, Eigen and std") {
  const fs::path root = fs::path(CAROM_SOURCE_DIR) / "lib/carom";
  const auto found = violations(root, readTable(CAROM_LAYER_TABLE));
  std::string text;
  for (const auto& line : found) text += "lib/carom/" + line + "\n";
  INFO(text);
  CHECK(found.empty());
}

TEST_CASE("what breaks the table is found, with file and line") {
  const fs::path root = CAROM_SCRATCH_DIR;
  fs::remove_all(root);
  const auto write = [&](const char* name, const char* content) {
    fs::create_directories((root / name).parent_path());
    std::ofstream(root / name) << content;
  };
  write("rotation/up.hpp", "#pragma once\n\n#include \"carom/mass/triangle_mesh.hpp\"\n");
  write("rotation/fine.cpp",
        "#include \"carom/rotation/up.hpp\"\n#include \"carom/core/real.hpp\"\n#include <vector>\n"
        "#include <Eigen/Core>\n#include \"up.hpp\"\n// #include \"carom/mass/x.hpp\"\n");
  write(
      "rotation/third.cpp",
      "#include <CGAL/Polyhedron_3.h>\n#include <boost/any.hpp>\n  #  include <nlohmann/json.hpp>\n"
      "#include <unistd.h>\n#include \"carom_io/table.hpp\"\n#include FILE\n"
      "#include \"../mass/x.hpp\"\n#include \"carom/gravity/x.hpp\"\n");
  write("gravity/new.cpp", "#include <cmath>\n");
  write("mass/deep/nested.cpp", "#include \"carom/detection/x.hpp\"\n");
  const std::string other = ": neither a layer, Eigen nor the standard library";
  CHECK(
      violations(root, readTable(CAROM_LAYER_TABLE)) ==
      std::vector<std::string>{
          "gravity/new.cpp:1: includes cmath: 'gravity' is no layer",
          "mass/deep/nested.cpp:1: includes carom/detection/x.hpp: layer 'mass' may not use "
          "'detection'",
          "rotation/third.cpp:1: includes CGAL/Polyhedron_3.h" + other,
          "rotation/third.cpp:2: includes boost/any.hpp" + other,
          "rotation/third.cpp:3: includes nlohmann/json.hpp" + other,
          "rotation/third.cpp:4: includes unistd.h" + other,
          "rotation/third.cpp:5: includes carom_io/table.hpp" + other,
          "rotation/third.cpp:6: includes ?: the name of the file is computed",
          "rotation/third.cpp:7: includes ../mass/x.hpp" + other,
          "rotation/third.cpp:8: includes carom/gravity/x.hpp: 'gravity' is no layer",
          "rotation/up.hpp:3: includes carom/mass/triangle_mesh.hpp: layer 'rotation' may not use "
          "'mass'"});
}

#pragma once
// Reading of reference values from tests/cases/<file>.json. Numbers there are strings, so that no
// digit is lost on the way.

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "carom/core/real.hpp"

namespace carom_test {

using nlohmann::json;

// One case of a file: readCase("motion", "N7").
inline json readCase(const std::string& file, const std::string& id) {
  std::ifstream in(std::string(CAROM_CASES_DIR) + "/" + file + ".json");
  return json::parse(in).at(id);
}

inline double number(const json& value) {
  return std::strtod(value.get<std::string>().c_str(), nullptr);
}

inline carom::Vector3 vector(const json& value) {
  return {number(value.at(0)), number(value.at(1)), number(value.at(2))};
}

}  // namespace carom_test

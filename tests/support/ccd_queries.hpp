#pragma once
// Reading of queries with known answers: a vertex against a face, an edge against an edge.
//
// Two forms. tests/cases/toi_queries.json, which make_toi_queries.py writes; and the folders of the
// public Sample Queries of Wang et al. (ACM TOG 40(5), 2021), which the project does not contain:
// eight rows of coordinates a query, each coordinate a fraction that is a double, and whether there
// is a hit. First times for these are read from <folder>-toi.json where that file exists.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "carom/toi/moving_points.hpp"

namespace carom_test {

struct CcdQuery {
  std::string from;  // family or file
  carom::FeaturePair pair = carom::FeaturePair::kVertexFace;
  carom::MovingPoints points;
  bool isHit = false;
  std::optional<long double> time;  // of the first contact, to more digits than a double has
};

inline std::vector<CcdQuery> ownQueries(const std::string& file) {
  std::ifstream in(file);
  std::vector<CcdQuery> queries;
  const nlohmann::json all = nlohmann::json::parse(in);
  for (const nlohmann::json& row : all.at("queries")) {
    CcdQuery q;
    q.from = row.at("family").get<std::string>();
    q.pair = row.at("kind") == "edge-edge" ? carom::FeaturePair::kEdgeEdge
                                           : carom::FeaturePair::kVertexFace;
    std::size_t next = 0;
    for (auto* places : {&q.points.start, &q.points.end}) {
      for (carom::Vector3& p : *places) {
        for (int k = 0; k < 3; ++k) {
          p[k] = std::strtod(row.at("points").at(next++).get<std::string>().c_str(), nullptr);
        }
      }
    }
    q.isHit = !row.at("time").is_null();
    if (q.isHit) q.time = std::strtod(row.at("time").get<std::string>().c_str(), nullptr);
    queries.push_back(q);
  }
  return queries;
}

inline std::vector<CcdQuery> publicQueries(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::map<std::pair<std::string, int>, long double> times;
  if (std::ifstream in(folder.string() + "-toi.json"); in) {
    const nlohmann::json all = nlohmann::json::parse(in);
    for (const nlohmann::json& row : all) {
      times[{row.at("file").get<std::string>(), row.at("query").get<int>()}] =
          std::strtold(row.at("toi").get<std::string>().c_str(), nullptr);
    }
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<CcdQuery> queries;
  for (const fs::path& file : files) {
    const std::string name = fs::relative(file, folder).generic_string();
    std::ifstream in(file);
    CcdQuery q;
    q.from = name;
    q.pair = name.find("edge-edge") != std::string::npos ? carom::FeaturePair::kEdgeEdge
                                                         : carom::FeaturePair::kVertexFace;
    std::size_t row = 0;
    for (std::string line; std::getline(in, line);) {
      if (line.empty()) continue;
      std::istringstream cells(line);
      std::vector<double> c;
      for (std::string cell; std::getline(cells, cell, ',');) {
        c.push_back(std::strtod(cell.c_str(), nullptr));
      }
      // Numerators have at most 53 bits and denominators are powers of two: nothing is rounded.
      carom::Vector3& p = (row % 8 < 4 ? q.points.start : q.points.end)[row % 4];
      p = carom::Vector3(c.at(0) / c.at(1), c.at(2) / c.at(3), c.at(4) / c.at(5));
      q.isHit = c.at(6) != 0;
      if (++row % 8 != 0) continue;
      const auto known = times.find({name, static_cast<int>(row / 8) - 1});
      q.time.reset();
      if (known != times.end()) q.time = known->second;
      queries.push_back(q);
    }
  }
  return queries;
}

}  // namespace carom_test

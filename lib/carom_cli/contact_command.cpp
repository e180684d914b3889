#include "carom_cli/contact_command.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/detection/verdict.hpp"
#include "carom/manifold/collide.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/quick_mesh_check.hpp"
#include "carom_io/mesh_file.hpp"
#include "carom_io/number_text.hpp"
#include "carom_io/table.hpp"

namespace carom::cli {

namespace {

using Json = nlohmann::ordered_json;

// How far a vertex may stand out of the plane of a triangle, relative to the largest coordinate:
// files written as text with seven digits are good to this.
constexpr Real kConvexTolerance = 1e-6;

// The part that each vertex belongs to: vertices are in one part if triangles join them. -1: in none.
std::vector<int> partOfVertex(const TriangleMesh& mesh, int& parts) {
  std::vector<int> above(mesh.vertices.size());
  std::iota(above.begin(), above.end(), 0);
  auto root = [&](int v) {
    while (above[static_cast<std::size_t>(v)] != v) {
      int& up = above[static_cast<std::size_t>(v)];
      up = above[static_cast<std::size_t>(up)];
      v = up;
    }
    return v;
  };
  for (const auto& triangle : mesh.triangles) {
    for (const int k : {1, 2}) {
      above[static_cast<std::size_t>(root(triangle[static_cast<std::size_t>(k)]))] =
          root(triangle[0]);
    }
  }
  std::vector<int> part(mesh.vertices.size(), -1);
  std::vector<int> number(mesh.vertices.size(), -1);
  parts = 0;
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) {
      int& mine = number[static_cast<std::size_t>(root(v))];
      if (mine < 0) mine = parts++;
      part[static_cast<std::size_t>(v)] = mine;
    }
  }
  return part;
}

// Refuses a part in which a vertex stands outside of a triangle's plane, and names the worst one.
void requireConvex(const TriangleMesh& mesh, const std::vector<int>& part, int which) {
  Real size = 0;
  for (const Vector3& v : mesh.vertices) size = std::max(size, v.cwiseAbs().maxCoeff());
  std::vector<std::size_t> corners;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (part[v] == which) corners.push_back(v);
  }
  Real worst = kConvexTolerance * size;
  std::size_t vertex = 0;
  std::size_t plane = mesh.triangles.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    if (part[static_cast<std::size_t>(triangle[0])] != which) continue;
    auto corner = [&](std::size_t k) -> const Vector3& {
      return mesh.vertices[static_cast<std::size_t>(triangle[k])];
    };
    const Vector3 n = cross(corner(1) - corner(0), corner(2) - corner(0));
    const Real length = n.norm();
    if (!(length > 0)) continue;
    for (const std::size_t v : corners) {
      const Real height = n.dot(mesh.vertices[v] - corner(0)) / length;
      if (height <= worst) continue;
      worst = height;
      vertex = v;
      plane = t;
    }
  }
  if (plane < mesh.triangles.size()) {
    throw InvalidInput("part " + std::to_string(which) + " is not convex: vertex " +
                       std::to_string(vertex) + " lies " +
                       io::roundedText(worst, std::chars_format::general, 3) +
                       " m outside of the plane of triangle " + std::to_string(plane) +
                       "; a concave solid is given as convex parts that share no vertex");
  }
}

Shape readSolid(const std::string& file, int& parts) {
  const TriangleMesh mesh = io::readMesh(file);
  if (!isClearlyGood(mesh)) {
    const auto problems = checkMesh(mesh);
    if (!problems.empty()) throw InvalidInput(problems.front().message);
  }
  const std::vector<int> part = partOfVertex(mesh, parts);
  Compound compound;
  for (int which = 0; which < parts; ++which) {
    requireConvex(mesh, part, which);
    std::vector<Vector3> corners;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (part[v] == which) corners.push_back(mesh.vertices[v]);
    }
    compound.parts.push_back({hullOfPoints(corners), Pose()});
  }
  if (parts == 1) return std::get<ConvexHull>(compound.parts.front().shape);
  return makeCompound(std::move(compound.parts));
}

Pose poseFrom(const std::vector<double>& numbers) {
  if (numbers.empty()) return {};
  const Vector3 position(numbers[0], numbers[1], numbers[2]);
  if (numbers.size() == 3) return poseOf({1, 0, 0, 0}, position);
  return poseOf({numbers[3], numbers[4], numbers[5], numbers[6]}, position);
}

Json numbers(const Vector3& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::separated:
      return "separated";
    case Verdict::touching:
      return "touching";
    case Verdict::overlapping:
      return "overlapping";
  }
  return "";
}

struct Found {
  Separation distance;
  std::vector<PartManifold> manifolds;
  int partsA = 0;
  int partsB = 0;

  Verdict verdict() const {
    return verdictOf(distance.separation);
  }
};

void printJson(const ContactRequest& request, const Found* found,
               const std::vector<std::string>& problems) {
  Json out{{"a", request.fileA},   {"b", request.fileB},    {"overlap", nullptr},
           {"verdict", nullptr},   {"separation", nullptr}, {"normal", nullptr},
           {"nearest_a", nullptr}, {"nearest_b", nullptr},  {"points", Json::array()},
           {"problems", problems}};
  if (found != nullptr) {
    out["overlap"] = found->distance.separation < 0;
    out["verdict"] = nameOf(found->verdict());
    out["separation"] = found->distance.separation;
    out["normal"] = numbers(found->distance.normal);
    out["nearest_a"] = numbers(found->distance.pointA);
    out["nearest_b"] = numbers(found->distance.pointB);
    for (const auto& pair : found->manifolds) {
      for (int i = 0; i < pair.manifold.count; ++i) {
        const auto& point = pair.manifold.points[static_cast<std::size_t>(i)];
        out["points"].push_back({{"position", numbers(point.position)},
                                 {"separation", point.separation},
                                 {"normal", numbers(pair.manifold.normal)},
                                 {"part_a", pair.partA},
                                 {"part_b", pair.partB}});
      }
    }
  }
  std::cout << out.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void printText(const ContactRequest& request, const Found& found) {
  auto solid = [](const std::string& file, int parts) {
    return file + (parts == 1 ? "" : " (" + std::to_string(parts) + " parts)");
  };
  std::cout << solid(request.fileA, found.partsA) << " and " << solid(request.fileB, found.partsB)
            << " are " << nameOf(found.verdict()) << ".\n";
  const io::Notation digits = io::significant(12);
  io::Table facts;
  facts.column("quantity").column("x", digits).column("y", digits).column("z", digits);
  auto add = [&](const char* name, const Vector3& v) { facts.row({name, v.x(), v.y(), v.z()}); };
  add("normal, from A to B", found.distance.normal);
  add(found.distance.separation > 0 ? "nearest point of A [m]" : "deepest point of A [m]",
      found.distance.pointA);
  add(found.distance.separation > 0 ? "nearest point of B [m]" : "deepest point of B [m]",
      found.distance.pointB);
  std::cout << "signed distance "
            << io::roundedText(found.distance.separation, std::chars_format::general, 12)
            << " m\n\n"
            << facts;
  if (found.manifolds.empty()) return;
  io::Table table;
  table.column("part of A").column("part of B");
  table.column("x [m]", digits).column("y [m]", digits).column("z [m]", digits);
  table.column("separation [m]", digits);
  for (const auto& pair : found.manifolds) {
    for (int i = 0; i < pair.manifold.count; ++i) {
      const auto& point = pair.manifold.points[static_cast<std::size_t>(i)];
      table.row({pair.partA, pair.partB, point.position.x(), point.position.y(), point.position.z(),
                 point.separation});
    }
  }
  std::cout << "\npoints of contact\n\n" << table;
}

}  // namespace

int runContact(const ContactRequest& request) {
  std::vector<std::string> problems;
  auto attempt = [&](const std::string& what, auto&& step) {
    try {
      step();
    } catch (const InvalidInput& error) {
      const std::string message = error.what();
      problems.push_back(message.starts_with(what) ? message : what + ": " + message);
    }
  };
  Found found;
  Shape a;
  Shape b;
  Pose A;
  Pose B;
  attempt(request.fileA, [&] { a = readSolid(request.fileA, found.partsA); });
  attempt(request.fileB, [&] { b = readSolid(request.fileB, found.partsB); });
  attempt("--pose-a", [&] { A = poseFrom(request.poseA); });
  attempt("--pose", [&] { B = poseFrom(request.poseB); });
  if (problems.empty()) {
    found.distance = signedDistance(a, A, b, B);
    collide(a, A, b, B, found.manifolds);
  }
  for (const auto& problem : problems) std::cerr << problem << '\n';
  if (request.json) {
    printJson(request, problems.empty() ? &found : nullptr, problems);
  } else if (problems.empty()) {
    printText(request, found);
  }
  return problems.empty() ? 0 : 1;
}

}  // namespace carom::cli

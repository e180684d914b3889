// Exercise 02.check_mesh: is this mesh the skin of a solid at all?
// Check it with: ./course check 02.check_mesh

#include "carom/mass/check_mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

namespace {

using Problems = std::vector<MeshProblem>;

// Given: adds a problem with a sentence about it, unless the list is full.
void report(Problems& problems, MeshProblem problem) {
  if (problems.size() >= kMaxMeshProblems) return;
  problem.message = std::string(nameOf(problem.kind)) + " at vertex " +
                    std::to_string(problem.vertex) + ", triangle " +
                    std::to_string(problem.triangle) + ", edge " + std::to_string(problem.edge[0]) +
                    "-" + std::to_string(problem.edge[1]);
  problems.push_back(std::move(problem));
}

// Given: vertices are numbers, and indices name vertices.
Problems checkNumbers(const TriangleMesh& mesh) {
  Problems problems;
  if (mesh.triangles.empty()) report(problems, {.kind = MeshProblemKind::empty, .message = {}});
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].allFinite()) continue;
    report(problems, {.kind = MeshProblemKind::notANumber,
                      .vertex = static_cast<std::int32_t>(v),
                      .message = {}});
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t index : mesh.triangles[t]) {
      if (index >= 0 && static_cast<std::size_t>(index) < mesh.vertices.size()) continue;
      report(problems, {.kind = MeshProblemKind::indexOutOfRange,
                        .triangle = static_cast<std::int32_t>(t),
                        .message = {}});
    }
  }
  return problems;
}

// Given: no triangle has its corners on a line.
Problems checkAreas(const TriangleMesh& mesh) {
  Problems problems;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, mesh.triangles[t]);
    // A sine of the angle between two sides that rounding alone can make.
    constexpr Real kRounding = 2e-15;
    if (cross(b - a, c - a).norm() > kRounding * (b - a).norm() * (c - a).norm()) continue;
    report(problems, {.kind = MeshProblemKind::degenerateTriangle,
                      .triangle = static_cast<std::int32_t>(t),
                      .message = {}});
  }
  return problems;
}

// A pass along an edge: by which triangle, and whether from the smaller to the larger vertex
// number.
struct Pass {
  std::int32_t triangle = 0;
  bool rising = false;
};

// Every edge must be passed by two triangles, in opposite directions.
Problems checkEdges(const TriangleMesh& mesh) {
  Problems problems;
  // Collect the passes of every edge: std::map<std::array<std::int32_t, 2>, std::vector<Pass>>
  // keeps them in order. Then report openEdge, nonManifoldEdge or partlyFlipped.
  return todo<Problems>("checkEdges");
}

// All triangles may agree and still look inwards.
Problems checkOrientation(const TriangleMesh& mesh) {
  Problems problems;
  // Which number tells whether the triangles look outwards?
  return todo<Problems>("checkOrientation");
}

}  // namespace

// Given: a later check would only repeat what an earlier one found, so the first that finds
// something ends it.
std::vector<MeshProblem> checkMesh(const TriangleMesh& mesh) {
  for (const auto check : {checkNumbers, checkAreas, checkEdges, checkOrientation}) {
    Problems problems = check(mesh);
    if (!problems.empty()) return problems;
  }
  return {};
}

}  // namespace carom

#include "carom/mass/check_mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "carom/core/cross.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

namespace {

using Problems = std::vector<MeshProblem>;

void report(Problems& problems, MeshProblem problem) {
  if (problems.size() >= kMaxMeshProblems) return;
  problem.message = std::string(nameOf(problem.kind)) + " at vertex " +
                    std::to_string(problem.vertex) + ", triangle " +
                    std::to_string(problem.triangle) + ", edge " + std::to_string(problem.edge[0]) +
                    "-" + std::to_string(problem.edge[1]);
  problems.push_back(std::move(problem));
}

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

Problems checkAreas(const TriangleMesh& mesh) {
  Problems problems;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, mesh.triangles[t]);
    constexpr Real kRounding = 2e-15;
    if (cross(b - a, c - a).norm() > kRounding * (b - a).norm() * (c - a).norm()) continue;
    report(problems, {.kind = MeshProblemKind::degenerateTriangle,
                      .triangle = static_cast<std::int32_t>(t),
                      .message = {}});
  }
  return problems;
}

struct Pass {
  std::int32_t triangle = 0;
  bool rising = false;
};

Problems checkEdges(const TriangleMesh& mesh) {
  Problems problems;
  std::map<std::array<std::int32_t, 2>, std::vector<Pass>> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = mesh.triangles[t][k];
      const std::int32_t to = mesh.triangles[t][(k + 1) % 3];
      const std::array<std::int32_t, 2> key = {std::min(from, to), std::max(from, to)};
      edges[key].push_back({static_cast<std::int32_t>(t), from < to});
    }
  }
  for (const auto& [edge, passes] : edges) {
    MeshProblem problem;
    problem.triangle = passes[0].triangle;
    problem.edge = edge;
    if (passes.size() == 1) {
      problem.kind = MeshProblemKind::openEdge;
    } else if (passes.size() > 2) {
      problem.kind = MeshProblemKind::nonManifoldEdge;
    } else if (passes[0].rising != passes[1].rising) {
      problem.kind = MeshProblemKind::partlyFlipped;
    } else {
      continue;
    }
    report(problems, problem);
  }
  return problems;
}

Problems checkOrientation(const TriangleMesh& mesh) {
  Problems problems;
  if (!(signedVolume(mesh) > 0)) {
    report(problems, {.kind = MeshProblemKind::flipped, .message = {}});
  }
  return problems;
}

}  // namespace

std::vector<MeshProblem> checkMesh(const TriangleMesh& mesh) {
  for (const auto check : {checkNumbers, checkAreas, checkEdges, checkOrientation}) {
    Problems problems = check(mesh);
    if (!problems.empty()) return problems;
  }
  return {};
}

}  // namespace carom

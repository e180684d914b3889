#include "carom/mass/check_mesh.hpp"

#include <algorithm>
#include <tuple>
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

struct Side {
  std::int32_t low = 0, high = 0, triangle = 0;
  bool rising = false;
};

// All sides sorted, so that those of one edge stand together.
Problems checkEdges(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corner = mesh.triangles[t];
    for (const auto& [from, to] : {std::pair{corner[0], corner[1]}, std::pair{corner[1], corner[2]},
                                   std::pair{corner[2], corner[0]}}) {
      sides.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::tie(p.low, p.high, p.triangle) < std::tie(q.low, q.high, q.triangle);
  });
  Problems problems;
  std::size_t next = 0;
  for (std::size_t i = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next].low == sides[i].low &&
           sides[next].high == sides[i].high) {
      ++next;
    }
    MeshProblem problem;
    problem.triangle = sides[i].triangle;
    problem.edge = {sides[i].low, sides[i].high};
    if (next - i == 2 && sides[i].rising != sides[i + 1].rising) continue;
    problem.kind = next - i == 1   ? MeshProblemKind::openEdge
                   : next - i == 2 ? MeshProblemKind::partlyFlipped
                                   : MeshProblemKind::nonManifoldEdge;
    report(problems, problem);
  }
  return problems;
}

Problems checkOrientation(const TriangleMesh& mesh) {
  Problems problems;
  if (signedVolume(mesh) <= 0) {
    MeshProblem problem;
    problem.kind = MeshProblemKind::flipped;
    report(problems, problem);
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

#include "carom/mass/check_mesh.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "carom/core/cross.hpp"
#include "carom/mass/check_pieces.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {
namespace {

using Triangle = std::array<std::int32_t, 3>;

std::string text(const Triangle& t) {
  std::string corners = "(";
  corners += std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " + std::to_string(t[2]) + ")";
  return corners;
}

// Adds a problem unless the list is full.
void report(std::vector<MeshProblem>& problems, MeshProblem problem) {
  if (problems.size() < kMaxMeshProblems) problems.push_back(std::move(problem));
}

// Vertices must be numbers and indices must name vertices; everything later relies on it.
std::vector<MeshProblem> checkNumbers(const TriangleMesh& mesh) {
  std::vector<MeshProblem> problems;
  if (mesh.triangles.empty()) {
    report(problems,
           {.kind = MeshProblemKind::empty, .message = "the mesh is empty: it has no triangles"});
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].allFinite()) continue;
    report(problems, {.kind = MeshProblemKind::notANumber,
                      .vertex = static_cast<std::int32_t>(v),
                      .message = "vertex " + std::to_string(v) +
                                 " has a coordinate that is not a finite number"});
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t index : mesh.triangles[t]) {
      if (index >= 0 && static_cast<std::size_t>(index) < mesh.vertices.size()) continue;
      report(problems, {.kind = MeshProblemKind::indexOutOfRange,
                        .triangle = static_cast<std::int32_t>(t),
                        .message = "triangle " + std::to_string(t) + " names vertex " +
                                   std::to_string(index) + ", but the mesh has " +
                                   std::to_string(mesh.vertices.size()) + " vertices"});
    }
  }
  return problems;
}

// No area: two corners in one place, or three on a line.
bool isDegenerate(const TriangleMesh& mesh, const Triangle& triangle) {
  const auto [a, b, c] = cornersOf(mesh, triangle);
  Vector3 u = b - a;
  Vector3 v = c - a;
  const Real uSize = u.cwiseAbs().maxCoeff();
  const Real vSize = v.cwiseAbs().maxCoeff();
  if (uSize == 0 || vSize == 0) return true;
  u /= uSize;  // so that the squares of very small edges do not vanish
  v /= vSize;
  // The sine of the angle between the edges that rounding alone can make: eight units in the last
  // place.
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  return !(cross(u, v).norm() > kRounding * u.norm() * v.norm());
}

std::vector<MeshProblem> checkAreas(const TriangleMesh& mesh) {
  std::vector<MeshProblem> problems;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!isDegenerate(mesh, mesh.triangles[t])) continue;
    report(problems, {.kind = MeshProblemKind::degenerateTriangle,
                      .triangle = static_cast<std::int32_t>(t),
                      .message = "triangle " + std::to_string(t) + " " + text(mesh.triangles[t]) +
                                 " has no area: its corners lie on a line"});
  }
  return problems;
}

// One side of a triangle, running from vertex to vertex as the triangle does.
struct Side {
  std::int32_t low = 0;   // the smaller of its two vertices
  std::int32_t high = 0;  // the larger
  std::int32_t triangle = 0;
  bool rising = false;  // runs from low to high

  bool sameEdge(const Side& other) const {
    return low == other.low && high == other.high;
  }
};

// Sides sorted so that those along the same edge stand together.
std::vector<Side> sortedSides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = mesh.triangles[t][k];
      const std::int32_t to = mesh.triangles[t][(k + 1) % 3];
      sides.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::tie(p.low, p.high, p.triangle) < std::tie(q.low, q.high, q.triangle);
  });
  return sides;
}

// Every edge must have two triangles that run along it in opposite directions.
std::vector<MeshProblem> checkEdges(const TriangleMesh& mesh) {
  std::vector<MeshProblem> problems;
  const std::vector<Side> sides = sortedSides(mesh);
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last =
        std::find_if(first, sides.end(), [&](const Side& side) { return !side.sameEdge(*first); });
    const auto count = last - first;
    const std::string edge = "edge " + std::to_string(first->low) + "-" +
                             std::to_string(first->high) + " of triangle " +
                             std::to_string(first->triangle);
    MeshProblem problem;
    problem.triangle = first->triangle;
    problem.edge = {first->low, first->high};
    if (count == 1) {
      problem.kind = MeshProblemKind::openEdge;
      problem.message = edge + " is open: no other triangle shares it";
      report(problems, problem);
    } else if (count > 2) {
      problem.kind = MeshProblemKind::nonManifoldEdge;
      problem.message = edge + " is not manifold: " + std::to_string(count) + " triangles share it";
      report(problems, problem);
    } else if (first->rising == (first + 1)->rising) {
      problem.kind = MeshProblemKind::partlyFlipped;
      problem.message = edge + " is passed in the same direction by triangle " +
                        std::to_string((first + 1)->triangle) + ": one of the two is flipped";
      report(problems, problem);
    }
    first = last;
  }
  return problems;
}

std::vector<MeshProblem> checkOrientation(const TriangleMesh& mesh) {
  const Real volume = signedVolume(mesh);
  if (volume > 0) return {};
  return {
      {.kind = MeshProblemKind::flipped,
       .message = "the mesh is flipped: its triangles look inwards, from triangle 0 on, and the "
                  "signed volume is " +
                  std::to_string(volume)}};
}

}  // namespace

std::vector<MeshProblem> checkMesh(const TriangleMesh& mesh) {
  for (const auto check : {checkNumbers, checkAreas, checkEdges, checkOrientation, checkPieces}) {
    std::vector<MeshProblem> problems = check(mesh);
    if (!problems.empty()) return problems;
  }
  return {};
}

}  // namespace carom

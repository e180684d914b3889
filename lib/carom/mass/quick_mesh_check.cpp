#include "carom/mass/quick_mesh_check.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "carom/mass/signed_volume.hpp"

namespace carom {
namespace {

// So that twice the number of a vertex, plus one, is a 32-bit number.
constexpr std::size_t kMostVertices = std::numeric_limits<std::int32_t>::max();

std::size_t number(std::int32_t index) {
  return static_cast<std::size_t>(index);
}

bool usable(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.vertices.size();
  if (mesh.triangles.empty() || vertices > kMostVertices) {
    return false;
  }
  Real zero = 0;  // x - x is not zero for an infinite x, nor for one that is no number
  for (const Vector3& v : mesh.vertices)
    zero += (v.x() - v.x()) + (v.y() - v.y()) + (v.z() - v.z());
  if (zero != 0) return false;

  const auto last = static_cast<std::uint32_t>(vertices - 1);
  std::uint32_t signs = 0;  // the highest bit is set if an index is negative or beyond the last
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const std::int32_t index : {a, b, c}) {
      const auto i = static_cast<std::uint32_t>(index);
      signs |= i | (last - i);
    }
  }
  return vertices > 0 && (signs >> 31) == 0;
}

// All areas far above rounding, and all products far from the ends of the range of a double.
bool haveAreas(const TriangleMesh& mesh) {
  constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();
  constexpr Real kSine = 64 * kEpsilon;  // eight times what checkMesh() asks for
  constexpr Real kTiny = 1e-280, kHuge = 1e280;
  bool good = true;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    const Real ux = b.x() - a.x(), uy = b.y() - a.y(), uz = b.z() - a.z();
    const Real wx = c.x() - a.x(), wy = c.y() - a.y(), wz = c.z() - a.z();
    const Real nx = uy * wz - uz * wy, ny = uz * wx - ux * wz, nz = ux * wy - uy * wx;
    const Real sides = (ux * ux + uy * uy + uz * uz) * (wx * wx + wy * wy + wz * wz);
    const Real normal = nx * nx + ny * ny + nz * nz;
    good = good & (normal > kSine * kSine * sides) & (normal > kTiny) & (sides < kHuge);
  }
  return good;
}

// Every edge passed twice, once in each direction.
bool edgesMatch(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.vertices.size();
  // Row v holds the edges whose lower vertex is v: twice the upper one, plus one if passed upwards.
  std::vector<std::uint32_t> begin(vertices + 1, 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    ++begin[number(std::min(a, b))];
    ++begin[number(std::min(b, c))];
    ++begin[number(std::min(c, a))];
  }
  std::uint32_t sum = 0;  // each row's end; filling moves it back to the row's begin
  for (std::uint32_t& count : begin) count = sum += count;
  std::vector<std::uint32_t> entries(3 * mesh.triangles.size());
  const auto enter = [&](std::int32_t from, std::int32_t to) {
    const auto high = static_cast<std::uint32_t>(std::max(from, to));
    entries[--begin[number(std::min(from, to))]] = 2 * high + (from < to ? 1u : 0u);
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    enter(a, b);
    enter(b, c);
    enter(c, a);
  }

  // Mark of an upper vertex: four times the row's number, plus 1 and 2 for the directions seen.
  std::vector<std::uint64_t> marks(vertices, std::numeric_limits<std::uint64_t>::max());
  std::uint64_t repeated = 0;
  std::size_t edges = 0;
  for (std::size_t row = 0; row < vertices; ++row) {
    const std::uint64_t fresh = 4 * static_cast<std::uint64_t>(row);
    for (std::uint32_t i = begin[row]; i < begin[row + 1]; ++i) {
      std::uint64_t& mark = marks[entries[i] / 2];
      const std::uint64_t seen = mark - fresh < 4 ? mark : fresh;
      const std::uint64_t direction = 1 + (entries[i] & 1u);
      edges += seen == fresh;
      repeated |= seen & direction & 3;
      mark = seen | direction;
    }
  }
  return repeated == 0 && 2 * edges == entries.size();
}

// All triangles hang together.
bool isOnePiece(const TriangleMesh& mesh) {
  std::vector<std::int32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&parent](std::int32_t v) {
    while (parent[number(v)] != v) v = parent[number(v)] = parent[number(parent[number(v)])];
    return v;
  };
  std::size_t joins = 0;
  for (const auto& [first, second, third] : mesh.triangles) {
    std::int32_t a = find(first);
    for (const std::int32_t other : {second, third}) {
      const std::int32_t b = find(other);
      if (a == b) continue;
      parent[number(std::max(a, b))] = std::min(a, b);
      a = std::min(a, b);
      ++joins;
    }
  }
  // A tree of joins over n vertices has n - 1 of them. A vertex that no triangle uses is doubt
  // enough.
  return joins + 1 == mesh.vertices.size();
}

}  // namespace

bool isClearlyGood(const TriangleMesh& mesh) {
  return usable(mesh) && haveAreas(mesh) && edgesMatch(mesh) && signedVolume(mesh) > 0 &&
         isOnePiece(mesh);
}

}  // namespace carom

#include "carom/mass/check_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "carom/core/cross.hpp"

namespace carom {
namespace {

// Joins vertices into sets; the smallest number of a set is its name.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::int32_t find(std::int32_t v) {
    while (at(v) != v) v = at(v) = at(at(v));  // halves the way for the next time
    return v;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    at(std::max(a, b)) = std::min(a, b);
  }

 private:
  std::int32_t& at(std::int32_t v) {
    return parent_[static_cast<std::size_t>(v)];
  }
  std::vector<std::int32_t> parent_;
};

struct Piece {
  std::vector<std::int32_t> triangles;  // ascending
  Real sixVolumes = 0;
  Vector3 low, high;  // bounds

  bool mayHold(const Vector3& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
};

const std::array<std::int32_t, 3>& triangleOf(const TriangleMesh& mesh, std::int32_t t) {
  return mesh.triangles[static_cast<std::size_t>(t)];
}

std::vector<Piece> collect(const TriangleMesh& mesh, const MeshPieces& found) {
  std::vector<Piece> pieces(static_cast<std::size_t>(found.count));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Piece& piece = pieces[static_cast<std::size_t>(found.pieceOf[t])];
    piece.triangles.push_back(static_cast<std::int32_t>(t));
    const auto [a, b, c] = cornersOf(mesh, mesh.triangles[t]);
    if (piece.triangles.size() == 1) piece.low = piece.high = a;
    for (const Vector3& corner : {a, b, c}) {
      piece.low = piece.low.cwiseMin(corner);
      piece.high = piece.high.cwiseMax(corner);
    }
    // About a vertex of the piece, for the same reason as in signedVolume().
    const Vector3& origin = cornersOf(mesh, triangleOf(mesh, piece.triangles.front())).a;
    piece.sixVolumes += (a - origin).dot(cross(b - a, c - a));
  }
  return pieces;
}

// How often a piece goes round a point: 1 inside, 0 outside, -1 inside if it looks inwards; not a
// number for a point that lies on a triangle, or so near that rounding decides on which side.
Real windingNumber(const TriangleMesh& mesh, const Piece& piece, const Vector3& p) {
  constexpr Real kOnIt = 1e-9;  // of a half solid angle of pi [rad]: far above rounding
  Real halfAngles = 0;          // of the solid angles of the triangles
  for (const std::int32_t t : piece.triangles) {
    const auto [cornerA, cornerB, cornerC] = cornersOf(mesh, triangleOf(mesh, t));
    const Vector3 a = cornerA - p, b = cornerB - p, c = cornerC - p;
    const Real lengthA = a.norm(), lengthB = b.norm(), lengthC = c.norm();
    const Real y = a.dot(cross(b, c));
    const Real x =
        lengthA * lengthB * lengthC + a.dot(b) * lengthC + b.dot(c) * lengthA + c.dot(a) * lengthB;
    if (x <= 0 && std::abs(y) <= -kOnIt * x) return std::numeric_limits<Real>::quiet_NaN();
    halfAngles += std::atan2(y, x);
  }
  return halfAngles / (2 * std::numbers::pi);
}

// How often all other pieces go round a piece; none if its vertices that were tried lie on them, or
// do not agree, because pieces cut each other.
std::optional<int> windingAround(const TriangleMesh& mesh, const std::vector<Piece>& pieces,
                                 std::size_t which) {
  constexpr std::size_t kTries = 8;      // vertices, spread over the piece
  constexpr Real kNearAnInteger = 0.01;  // rounding is far below, a vertex on an edge far above
  const std::vector<std::int32_t>& own = pieces[which].triangles;
  std::optional<int> result;
  for (std::size_t i = 0; i < std::min(kTries, own.size()); ++i) {
    const std::size_t spread = i * own.size() / std::min(kTries, own.size());
    const Vector3 p = cornersOf(mesh, triangleOf(mesh, own[spread])).a;
    Real winding = 0;
    for (std::size_t other = 0; other < pieces.size(); ++other) {
      if (other == which || !pieces[other].mayHold(p)) continue;
      winding += windingNumber(mesh, pieces[other], p);
    }
    if (!(std::abs(winding - std::round(winding)) < kNearAnInteger)) continue;
    const int found = static_cast<int>(std::lround(winding));
    if (result && *result != found) return std::nullopt;
    result = found;
  }
  return result;
}

}  // namespace

MeshPieces piecesOf(const TriangleMesh& mesh) {
  requireUsable(mesh);
  Sets sets(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.join(a, b);
    sets.join(b, c);
  }
  MeshPieces pieces;
  pieces.pieceOf.reserve(mesh.triangles.size());
  std::vector<std::int32_t> numberOf(mesh.vertices.size(), -1);  // by name of the set
  for (const auto& triangle : mesh.triangles) {
    std::int32_t& number = numberOf[static_cast<std::size_t>(sets.find(triangle[0]))];
    if (number < 0) number = pieces.count++;
    pieces.pieceOf.push_back(number);
  }
  return pieces;
}

std::vector<MeshProblem> checkPieces(const TriangleMesh& mesh) {
  const MeshPieces found = piecesOf(mesh);
  if (found.count < 2) return {};
  const std::vector<Piece> pieces = collect(mesh, found);
  std::vector<MeshProblem> problems;
  for (std::size_t i = 0; i < pieces.size() && problems.size() < kMaxMeshProblems; ++i) {
    const std::optional<int> winding = windingAround(mesh, pieces, i);
    if (!winding) continue;
    const bool outwards = pieces[i].sixVolumes > 0;
    const bool inwards = pieces[i].sixVolumes < 0;
    MeshProblem problem;
    problem.kind = MeshProblemKind::flippedPiece;
    problem.triangle = pieces[i].triangles.front();
    const std::string name =
        "the piece of the surface that begins with triangle " + std::to_string(problem.triangle);
    if (outwards && *winding > 0) {
      problem.message = name +
                        " lies inside the solid and looks outwards: its inside counts twice; a "
                        "cavity must be reversed";
      problems.push_back(problem);
    } else if (inwards && *winding <= 0) {
      problem.message = name + " looks inwards and no other piece is around it: it is flipped";
      problems.push_back(problem);
    }
  }
  return problems;
}

}  // namespace carom

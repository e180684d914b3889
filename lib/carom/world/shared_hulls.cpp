#include "carom/world/shared_hulls.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "carom/world/weigh_shapes.hpp"

namespace carom::world {

namespace {

// The number by which a hull is known.
std::uint64_t numberOf(const ConvexHull& hull) {
  std::uint64_t number = hull.vertices.size();
  for (const Vector3& vertex : hull.vertices) {
    for (int k = 0; k < 3; ++k) {
      number = std::rotl(number, 5) ^ std::bit_cast<std::uint64_t>(vertex[k]);
      number *= 0x9E3779B97F4A7C15u;
    }
  }
  return number;
}

// No entry has a gap between its members, so that equal bits are equal parts.
static_assert(sizeof(Vector3) == 3 * sizeof(Real));
static_assert(sizeof(HullFace) == 4 * sizeof(Real) + 2 * sizeof(std::int32_t));
static_assert(sizeof(HullHalfEdge) == 5 * sizeof(std::int32_t));

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

// All else follows from these.
bool isSame(const ConvexHull& a, const ConvexHull& b) {
  return sameBits(a.vertices, b.vertices) && sameBits(a.faces, b.faces) &&
         sameBits(a.halfEdges, b.halfEdges);
}

// Forgets hulls that no shape has any more, as often as their number has doubled.
void forgetOld(WorldState& state) {
  if (state.hulls.size() < state.hullsAtMost) return;
  std::erase_if(state.hulls, [](const auto& known) { return known.second.expired(); });
  constexpr std::size_t kFew = 64;
  state.hullsAtMost = kFew + 2 * state.hulls.size();
}

}  // namespace

std::shared_ptr<const ShapeData> sharedHull(WorldState& state, const ConvexHull& hull) {
  const std::uint64_t number = numberOf(hull);
  const auto [begin, end] = state.hulls.equal_range(number);
  for (auto known = begin; known != end; ++known) {
    std::shared_ptr<const ShapeData> data = known->second.lock();
    if (data && isSame(std::get<ConvexHull>(data->whole), hull)) return data;
  }
  auto data = std::make_shared<ShapeData>();
  data->whole = hull;
  data->convex = hull;
  data->usesAxes = true;
  ShapeDescription alone;
  alone.shape = hull;
  data->middle = weighShapes(std::span(&alone, 1)).center;
  forgetOld(state);
  state.hulls.emplace(number, data);
  return data;
}

}  // namespace carom::world

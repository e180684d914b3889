#include "carom/detection/hull_view.hpp"

namespace carom::detail {
namespace {

// What all boxes have in common, made once from the loops of boxHull().
struct BoxTopology {
  std::array<HullHalfEdge, 24> halfEdges;
  std::array<HullEdge, 12> edges;
  std::array<std::int32_t, 8> anyHalfEdge;
};

constexpr BoxTopology makeTopology() {
  constexpr std::int32_t loops[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  BoxTopology box{};
  for (std::int32_t f = 0; f < 6; ++f) {
    for (std::int32_t k = 0; k < 4; ++k) {
      const std::int32_t i = 4 * f + k;
      box.halfEdges[i] = {loops[f][k], 4 * f + (k + 1) % 4, -1, f, -1};
      box.anyHalfEdge[loops[f][k]] = i;
    }
  }
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < 24; ++i) {
    const std::int32_t end = box.halfEdges[box.halfEdges[i].next].origin;
    for (std::int32_t j = 0; j < 24; ++j) {
      if (box.halfEdges[j].origin != end) continue;
      if (box.halfEdges[box.halfEdges[j].next].origin != box.halfEdges[i].origin) continue;
      box.halfEdges[i].twin = j;
      if (i < j) {
        box.halfEdges[i].edge = box.halfEdges[j].edge = count;
        box.edges[count++] = {box.halfEdges[i].origin, end, box.halfEdges[i].face,
                              box.halfEdges[j].face};
      }
    }
  }
  return box;
}

constexpr BoxTopology kBox = makeTopology();

}  // namespace

BoxHullView::BoxHullView(const Box& box) {
  const Vector3& h = box.halfExtents;
  for (int i = 0; i < 8; ++i) {
    x_[i] = (i & 1) != 0 ? h.x() : -h.x();
    y_[i] = (i & 2) != 0 ? h.y() : -h.y();
    z_[i] = (i & 4) != 0 ? h.z() : -h.z();
    vertices_[i] = {x_[i], y_[i], z_[i]};
  }
  for (int f = 0; f < 6; ++f) {
    faces_[f].normal = Vector3::Zero();
    faces_[f].normal[f / 2] = f % 2 == 0 ? -1 : 1;
    faces_[f].offset = h[f / 2];
    faces_[f].firstHalfEdge = 4 * f;
    faces_[f].count = 4;
  }
  radius_ = h.norm();
}

HullView BoxHullView::view() const {
  return {vertices_.data(),
          x_.data(),
          y_.data(),
          z_.data(),
          faces_.data(),
          kBox.halfEdges.data(),
          kBox.edges.data(),
          kBox.anyHalfEdge.data(),
          8,
          6,
          12,
          Vector3::Zero(),
          radius_};
}

}  // namespace carom::detail

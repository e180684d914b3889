#include "carom/motion/neighbor_list.hpp"

#include <algorithm>

namespace carom {

void NeighborList::collect(CellGrid& cells, const ParticleBox& box,
                           std::span<const Vector3> positions, Real reach) {
  rows_.clear();
  rows_.reserve(3 * positions.size());  // two or so for each; so that later lists take no memory
  used_ = 0;
  const Real reachSquared = reach * reach;

  // Appends those of a run of particles that are near; every one is written, and only counted if it
  // is near: a branch would be guessed wrong too often.
  const auto append = [&](const Vector3& from, std::int32_t begin, std::int32_t end) {
    const std::size_t room = used_ + static_cast<std::size_t>(std::max(0, end - begin)) + 1;
    if (partners_.size() < room) partners_.resize(2 * room);
    std::int32_t* next = partners_.data() + used_;
    for (std::int32_t j = begin; j < end; ++j) {
      *next = j;
      const Vector3 d = positions[static_cast<std::size_t>(j)] - from;
      next += d.squaredNorm() < reachSquared;
    }
    used_ = static_cast<std::size_t>(next - partners_.data());
  };
  const auto endRow = [&](std::int32_t particle, std::size_t first, int image) {
    if (used_ == first) return;
    rows_.push_back({first, used_ - first, particle, image});
  };

  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    if (cells.start(cell) == cells.start(cell + 1)) continue;
    const std::span<const CellGrid::Neighbor> neighbors = cells.forward(cell);
    for (std::int32_t i = cells.start(cell); i < cells.start(cell + 1); ++i) {
      const Vector3& here = positions[static_cast<std::size_t>(i)];
      std::size_t first = used_;
      int image = kUnshifted;
      Vector3 from = here;
      append(from, i + 1, cells.start(cell + 1));
      for (const CellGrid::Neighbor& next : neighbors) {
        if (next.image != image) {
          endRow(i, first, image);
          first = used_;
          image = next.image;
          from = here - imageShift(box, image);
        }
        append(from, cells.start(next.cell), cells.start(next.cell + 1));
      }
      endRow(i, first, image);
    }
  }
}

}  // namespace carom

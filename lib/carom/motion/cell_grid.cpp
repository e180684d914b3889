#include "carom/motion/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t at(int axis) {
  return static_cast<std::size_t>(axis);
}

}  // namespace

Vector3 imageShift(const ParticleBox& box, int image) {
  const Vector3 steps(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
  return steps.cwiseProduct(box.size);
}

CellGrid::CellGrid(const ParticleBox& box, Real reach, std::size_t particles) : box_(box) {
  // A limit on the cells, lest a large and nearly empty box takes all memory.
  const Real most = 4 * static_cast<Real>(particles) + 64;
  Real edge = reach;
  for (;; edge *= 1.25) {
    Real cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (box.edges[at(axis)] == Edge::Flat) continue;
      cells *= std::max(Real(1), std::floor(box.size[axis] / edge));
    }
    if (cells <= most) break;
  }
  std::size_t cells = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.edges[at(axis)] == Edge::Flat) continue;
    counts_[at(axis)] = std::max(1, static_cast<int>(box.size[axis] / edge));
    cells *= at(counts_[at(axis)]);
  }
  starts_.assign(cells + 1, 0);
  order_.resize(particles);
  cellOf_.resize(particles);
}

std::size_t CellGrid::cellAt(const Vector3& position) const {
  std::array<int, 3> place = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const int count = counts_[at(axis)];
    if (count == 1) continue;
    // A particle on the far edge is still in the last cell.
    place[at(axis)] =
        std::min(count - 1, static_cast<int>(position[axis] / box_.size[axis] * count));
  }
  return at((place[2] * counts_[1] + place[1]) * counts_[0] + place[0]);
}

std::span<const std::int32_t> CellGrid::sort(std::span<const Vector3> positions) {
  // Count, add up, and put each where its cell has come to.
  std::fill(starts_.begin(), starts_.end(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t cell = cellAt(positions[i]);
    cellOf_[i] = static_cast<std::int32_t>(cell);
    if (cell + 2 < starts_.size()) ++starts_[cell + 2];
  }
  for (std::size_t cell = 2; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto cell = static_cast<std::size_t>(cellOf_[i]);
    order_[static_cast<std::size_t>(starts_[cell + 1]++)] = static_cast<std::int32_t>(i);
  }
  return order_;
}

std::span<const CellGrid::Neighbor> CellGrid::forward(std::size_t cell) {
  const int index = static_cast<int>(cell);
  const std::array<int, 3> place = {index % counts_[0], index / counts_[0] % counts_[1],
                                    index / counts_[0] / counts_[1]};
  // Of the 26 steps to a neighbour those after the middle are the opposites of those before it.
  std::size_t found = 0;
  for (int step = 14; step < 27; ++step) {
    const std::array<int, 3> steps = {step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1};
    std::array<int, 3> next = {}, image = {};
    bool exists = true;
    for (int axis = 0; axis < 3; ++axis) {
      const int count = counts_[at(axis)];
      next[at(axis)] = place[at(axis)] + steps[at(axis)];
      image[at(axis)] = next[at(axis)] < 0 ? -1 : next[at(axis)] >= count ? 1 : 0;
      next[at(axis)] -= image[at(axis)] * count;
      exists = exists && (image[at(axis)] == 0 || box_.edges[at(axis)] == Edge::Periodic);
    }
    if (!exists) continue;
    neighbors_[found++] = {at((next[2] * counts_[1] + next[1]) * counts_[0] + next[0]),
                           kUnshifted + image[0] + 3 * image[1] + 9 * image[2]};
  }
  // Those of one image together, the unshifted first; no two have the same image and cell.
  const auto rank = [](const Neighbor& n) {
    return std::pair(n.image == kUnshifted ? -1 : n.image, n.cell);
  };
  std::sort(neighbors_.begin(), neighbors_.begin() + static_cast<std::ptrdiff_t>(found),
            [&](const Neighbor& a, const Neighbor& b) { return rank(a) < rank(b); });
  return {neighbors_.data(), found};
}

}  // namespace carom

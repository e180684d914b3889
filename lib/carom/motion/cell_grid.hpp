#pragma once
// Which particles can be near each other?
//
// Method: the box is divided into cells, none shorter than the reach of the force. Who is within
// reach is in the same cell or in one next to it. Particles are counted into their cells and put in
// the order of the cells (a counting sort), so that those of a cell, and nearly those of its
// neighbours, lie side by side in memory.
// Why only half of the neighbours: each pair of cells, and so each pair of particles, is met once.
// A periodic box continues at its edges: the neighbour of the last cell is the first, a box length
// further. This also holds in a box of one or two cells, where a cell is its own neighbour.
// Source: Hockney and Eastwood, Computer Simulation Using Particles, 1981, chapter 8;
// Quentrec and Brot, Journal of Computational Physics 13, 1973.
// Not handled: crowds with empty regions much larger than the box is full; the cells are at most
// about four times as many as the particles, and get larger instead.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/motion/particle_box.hpp"

namespace carom {

/// How far the image of a box, one of the 27 around and including itself, is shifted. 13 is the box
/// itself.
/// \param box any box
/// \param image 0 to 26
/// \return a whole number of edges along each axis: -1, 0 or 1 [m, world]
/// \ingroup motion
Vector3 imageShift(const ParticleBox& box, int image);

/// The number of the image that is not shifted. \ingroup motion
inline constexpr int kUnshifted = 13;

/// The cells of a box, and who is in them. \ingroup motion
class CellGrid {
 public:
  /// A cell next to another, seen from there.
  struct Neighbor {
    std::size_t cell = 0;    ///< its number
    int image = kUnshifted;  ///< in which image of the box it lies, see imageShift()
  };

  /// Divides a box.
  /// \param box that passes requireUsable()
  /// \param reach least length of a cell's edges [m], positive
  /// \param particles how many there will be, for the number of cells
  CellGrid(const ParticleBox& box, Real reach, std::size_t particles);

  /// Counts particles into cells.
  /// \param positions in the box, edges included [m, world]
  /// \return the order of the cells: the index of the particle that comes first, second, ...; those
  /// of one cell in the order in which they were given. Valid until the next call
  std::span<const std::int32_t> sort(std::span<const Vector3> positions);

  /// The number of cells. \return at least 1
  std::size_t count() const {
    return starts_.size() - 1;
  }

  /// Where a cell begins in the sorted order. \param cell its number, or count() for the end of the
  /// last \return how many particles come before
  std::int32_t start(std::size_t cell) const {
    return starts_[cell];
  }

  /// The cells next to one, each pair of cells once: of two neighbours, only one lists the other.
  /// \param cell its number \return at most 13, those of one image together; valid until the next
  /// call
  std::span<const Neighbor> forward(std::size_t cell);

 private:
  std::size_t cellAt(const Vector3& position) const;

  ParticleBox box_;
  std::array<int, 3> counts_ = {1, 1, 1};
  std::vector<std::int32_t> starts_, order_, cellOf_;
  std::array<Neighbor, 13> neighbors_;
};

}  // namespace carom

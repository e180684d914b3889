#pragma once
// Which pairs of particles must be looked at in every step?
//
// Method: from the cells, all pairs that are nearer than the cut-off and a bit more, the skin. As
// long as no particle has moved by half the skin, no other pair can have come within the cut-off,
// so one list serves for several steps. A list is made of rows: a particle, an image of the box in
// which it is seen, and its partners. In most rows the box itself is the image; only near the edges
// of a periodic box there are others. So the inner loop knows nothing of periodic boxes.
// Why not look at the cells in every step: they hold nearly seven times as many pairs as there are
// within the cut-off.
// Source: Verlet, Physical Review 159, 1967; Allen and Tildesley, Computer Simulation of Liquids,
// 1987, section 5.3.
// Not handled: knowing when the list is too old. Who moves the particles does (particles.hpp).

#include "carom/motion/cell_grid.hpp"

namespace carom {

/// Pairs of particles, each pair once. \ingroup motion
class NeighborList {
 public:
  /// A particle and some of its partners.
  struct Row {
    std::size_t first = 0;      ///< where its partners begin among all
    std::size_t count = 0;      ///< how many they are
    std::int32_t particle = 0;  ///< its index
    std::int32_t image = 0;     ///< the partners are seen shifted by imageShift() of this
  };

  /// Collects all pairs within reach; what was there before is forgotten.
  /// \param cells in which the particles have been sorted
  /// \param box that of the cells
  /// \param positions in the order of the cells [m, world]
  /// \param reach greatest distance of a pair [m], no more than that of the cells
  void collect(CellGrid& cells, const ParticleBox& box, std::span<const Vector3> positions,
               Real reach);

  /// All rows. \return valid until the next call of collect()
  std::span<const Row> rows() const {
    return rows_;
  }

  /// The partners of a row. \param row one of rows() \return indices of particles
  std::span<const std::int32_t> partners(const Row& row) const {
    return {partners_.data() + row.first, row.count};
  }

  /// The number of pairs. \return of all rows together
  std::size_t pairs() const {
    return used_;
  }

 private:
  std::vector<Row> rows_;
  std::vector<std::int32_t> partners_;
  std::size_t used_ = 0;
};

}  // namespace carom

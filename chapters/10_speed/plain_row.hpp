#pragma once
// What is done with one row, one number at a time?
//
// A row of chapter 9, with everything that does not change while it is solved computed before: how
// the twelve speeds of two bodies add up to the speed at which they part, and what one newton second
// does to each of them. This is the specification: whoever solves four rows at once has to add in
// the same order, and comes to the same bits.
// A body that cannot be moved has no speeds and no number: it is nobody.

#include <array>
#include <cstdint>
#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// The number of a body that is none, or that cannot be moved. \ingroup solver
inline constexpr std::int32_t kNobody = -1;

/// The speeds of a body: x, y, z [m/s, world], then about x, y, z [rad/s, world]. \ingroup solver
struct BodySpeeds {
  std::array<Real, 6> x = {};  ///< as above
};

/// A row that is ready to be solved. \ingroup solver
struct PlainRow {
  std::int32_t bodyA = kNobody;      ///< number of body A
  std::int32_t bodyB = kNobody;      ///< number of body B
  std::array<Real, 6> alongA = {};   ///< of A's speeds in the speed of parting [1, m]
  std::array<Real, 6> alongB = {};   ///< of B's [1, m]
  std::array<Real, 6> changeA = {};  ///< what a unit of impulse adds to A's [1/kg, 1/(kg m)]
  std::array<Real, 6> changeB = {};  ///< to B's [1/kg, 1/(kg m)]
  Real mass = 0;                     ///< effective [kg]
  Real target = 0;                   ///< at least this fast they have to part [m/s]
  Real impulse = 0;                  ///< the sum so far [N s]
};

/// Visits a row. \param row its impulse changes \param speeds of all bodies; those of the two
/// change \ingroup solver
inline void solveRow(PlainRow& row, std::span<BodySpeeds> speeds) {
  //! [row]
  BodySpeeds nobody;
  const auto of = [&](std::int32_t body) -> BodySpeeds& {
    return body == kNobody ? nobody : speeds[body];
  };
  BodySpeeds &a = of(row.bodyA), &b = of(row.bodyB);
  Real parting = 0;
  for (std::size_t i = 0; i < 6; ++i) parting += row.alongA[i] * a.x[i];
  for (std::size_t i = 0; i < 6; ++i) parting += row.alongB[i] * b.x[i];
  const Real wanted = row.impulse + row.mass * (row.target - parting);
  // A contact does not pull, and what is no number is no impulse.
  const Real total = wanted > 0 ? wanted : 0;
  const Real more = total - row.impulse;
  row.impulse = total;
  for (std::size_t i = 0; i < 6; ++i) a.x[i] += more * row.changeA[i];
  for (std::size_t i = 0; i < 6; ++i) b.x[i] += more * row.changeB[i];
  //! [row]
}

}  // namespace carom

#include "carom/solver/hold_block.hpp"

#include <array>

namespace carom {

namespace {

constexpr int kMost = 6;
using Numbers = std::array<Real, kMost>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// The rows of a block that does as it likes: planes of pressure, then friction.
struct Rows {
  int pressures = 0, count = 0;
  std::array<PushRow, kMost> rows;
};

Vector3 placeOf(const ContactBlock& block, int point) {
  return block.count == 1 ? Vector3(Vector3::UnitX()) : block.places[at(point)];
}

// One plane for a point, two for an edge, three for a face.
int pressuresOf(const ContactBlock& block) {
  if (block.count == 1) return 1;
  for (int i = 0; i < block.count; ++i) {
    if (block.places[at(i)].z() != 0) return 3;
  }
  return 2;
}

PushRow planeOf(const ContactBlock& block, int plane) {
  PushRow sum;
  for (int i = 0; i < block.count; ++i) {
    const PushRow& row = block.normals[at(i)];
    const Real part = placeOf(block, i)[plane];
    sum.direction += part * row.direction;
    sum.turnA += part * row.turnA;
    sum.turnB += part * row.turnB;
    sum.spinA += part * row.spinA;
    sum.spinB += part * row.spinB;
    sum.drift += part * (row.drift - block.targets[at(i)]);
  }
  return sum;
}

Rows rowsOf(const ContactBlock& block) {
  Rows all;
  all.pressures = pressuresOf(block);
  for (int k = 0; k < all.pressures; ++k) all.rows[at(all.count++)] = planeOf(block, k);
  for (int k = 0; k < block.rubs; ++k) all.rows[at(all.count++)] = block.tangents[at(k)];
  return all;
}

// A symmetric matrix, taken apart: below the diagonal L, on it D.
class Factors {
 public:
  Factors(const Rows& rows, Real inverseMasses) : count_(rows.count) {
    for (int i = 0; i < count_; ++i) {
      for (int j = 0; j <= i; ++j) {
        const PushRow &p = rows.rows[at(i)], &q = rows.rows[at(j)];
        m_[at(i)][at(j)] = inverseMasses * p.direction.dot(q.direction) + p.turnA.dot(q.spinA) +
                           p.turnB.dot(q.spinB);
      }
    }
    takeApart();
  }

  bool positive() const {
    return positive_;
  }

  Numbers solve(Numbers b) const {
    for (int i = 0; i < count_; ++i) {
      for (int j = 0; j < i; ++j) b[at(i)] -= m_[at(i)][at(j)] * b[at(j)];
    }
    for (int i = count_; i-- > 0;) {
      b[at(i)] /= m_[at(i)][at(i)];
      for (int j = i + 1; j < count_; ++j) b[at(i)] -= m_[at(j)][at(i)] * b[at(j)];
    }
    return b;
  }

 private:
  void takeApart() {
    constexpr Real kNothing = 1e-9;  // of a row is left by those before it
    for (int i = 0; i < count_; ++i) {
      const Real whole = m_[at(i)][at(i)];
      for (int j = 0; j < i; ++j) {
        Real& here = m_[at(i)][at(j)];
        for (int k = 0; k < j; ++k) here -= m_[at(i)][at(k)] * m_[at(j)][at(k)];
      }
      for (int j = 0; j < i; ++j) {
        const Real scaled = m_[at(i)][at(j)] / m_[at(j)][at(j)];
        m_[at(i)][at(i)] -= scaled * m_[at(i)][at(j)];
        m_[at(i)][at(j)] = scaled;
      }
      positive_ = positive_ && m_[at(i)][at(i)] > kNothing * whole;
    }
  }

  std::array<Numbers, kMost> m_;
  int count_ = 0;
  bool positive_ = true;
};

// Adds to what the block holds. Returns whether it may hold that.
bool addTo(ContactBlock& block, const Rows& rows, const Numbers& added) {
  Real pressed = 0;
  bool presses = true;
  for (int i = 0; i < block.count; ++i) {
    const Vector3 place = placeOf(block, i);
    for (int k = 0; k < rows.pressures; ++k) block.impulses[at(i)] += place[k] * added[at(k)];
    presses = presses && block.impulses[at(i)] >= 0;
    pressed += block.impulses[at(i)];
  }
  for (int k = 0; k < block.rubs; ++k) block.rub[k] += added[at(rows.pressures + k)];
  const Real limit = block.friction * pressed;
  return presses && (block.rubs == 0 || block.rub.squaredNorm() <= limit * limit);
}

}  // namespace

bool holdBlock(std::span<MovingBody> bodies, ContactBlock& block) {
  MovingBody &a = bodies[at(block.bodyA)], &b = bodies[at(block.bodyB)];
  const bool isPoint = block.count == 1 && block.masses[0] > 0;
  if (block.slips || !(isPoint || block.evenMass > 0)) return false;
  const Rows rows = rowsOf(block);
  const Factors factors(rows, a.mass.inverseMass + b.mass.inverseMass);
  if (!factors.positive()) return false;
  const Velocity beforeA = a.velocity, beforeB = b.velocity;
  const std::array<Real, 4> impulses = block.impulses;
  const Vector3 rub = block.rub;
  bool may = true;
  // The second round takes away what rounding has left.
  for (int round = 0; round < 2 && may; ++round) {
    Numbers missing = {};
    for (int k = 0; k < rows.count; ++k) missing[at(k)] = -speedAtEnd(rows.rows[at(k)], a, b);
    const Numbers added = factors.solve(missing);
    for (int k = 0; k < rows.count; ++k) pushAlong(rows.rows[at(k)], added[at(k)], a, b);
    may = addTo(block, rows, added);
  }
  if (may) return true;
  a.velocity = beforeA;
  b.velocity = beforeB;
  block.impulses = impulses;
  block.rub = rub;
  return false;
}

}  // namespace carom

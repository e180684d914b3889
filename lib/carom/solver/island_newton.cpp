#include "carom/solver/island_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/impulse/positive_solve.hpp"

namespace carom {

namespace {

// How much softer than its bodies a row's spring is: the smaller, the fewer repetitions, and the
// fewer digits of the masses are left beside the springs. Here half of the digits are each one's.
constexpr Real kSoftness = 1e-8;

// What of the speeds that impulses add up to and take away again may be left [1].
constexpr Real kRoundings = 32 * std::numeric_limits<Real>::epsilon();

constexpr int kMostRows = 7;
constexpr int kFirstRub = 4;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

bool isMovable(const MovingBody& body) {
  return body.mass.inverseMass > 0;
}

// Mass and inertia of a body as one block.
BodyBlock massOf(const BodyMass& mass) {
  BodyBlock M = BodyBlock::Zero();
  for (int i = 0; i < 3; ++i) M(i, i) = 1 / mass.inverseMass;
  // What cannot be turned about some axis is very hard to turn about it here; the rows, which know
  // better, correct it.
  constexpr Real kHard = 1e-9;
  PositiveSolve solve(mass.inverseInertia);
  if (!solve.positive()) {
    const Real most = mass.inverseInertia.trace();
    const Real least = most > 0 ? kHard * most : mass.inverseMass * kHard;
    solve = PositiveSolve(mass.inverseInertia + least * Matrix3::Identity());
  }
  M.bottomRightCorner<3, 3>() = solve.inverse();
  return M;
}

// How a velocity of a body changes the speed of a row.
void sideA(const PushRow& row, Real* J) {
  for (int k = 0; k < 3; ++k) {
    J[k] = -row.direction[k];
    J[3 + k] = -row.turnA[k];
  }
}

void sideB(const PushRow& row, Real* J) {
  for (int k = 0; k < 3; ++k) {
    J[k] = row.direction[k];
    J[3 + k] = row.turnB[k];
  }
}

Real alongRow(const Real* J, const BodyVector& velocity) {
  Real sum = 0;
  for (int k = 0; k < 6; ++k) sum += J[k] * velocity[k];
  return sum;
}

const PushRow& rowOf(const ContactBlock& block, int row) {
  return row < kFirstRub ? block.normals[at(row)] : block.tangents[at(row - kFirstRub)];
}

bool hasRow(const ContactBlock& block, int row) {
  if (row < kFirstRub) return row < block.count && block.masses[at(row)] > 0;
  return row - kFirstRub < block.rubs;
}

Real pressureOf(const ContactBlock& block) {
  Real pressed = 0;
  for (int i = 0; i < block.count; ++i) pressed += block.impulses[at(i)];
  return pressed;
}

}  // namespace

void IslandNewton::reserve(int bodies, int blocks) {
  const std::size_t n = at(bodies), m = at(blocks);
  matrix_.reserve(bodies, blocks);
  work_.reserve(m);
  nodes_.reserve(n);
  links_.reserve(m);
  masses_.reserve(n);
  velocity_.reserve(n);
  step_.reserve(n);
  loads_.reserve(n);
  kept_.reserve(m);
  free_.reserve(n);
  keptVelocity_.reserve(n);
}

IslandError IslandNewton::errorOf(std::span<const MovingBody> bodies,
                                  std::span<const ContactBlock> blocks, Real speed) {
  // What the impulses on a body come to without regard to their directions: roundings of that are
  // in its velocity.
  loads_.assign(bodies.size(), speed);
  for (const ContactBlock& block : blocks) {
    Real sum = block.rub.cwiseAbs().sum();
    for (int i = 0; i < block.count; ++i) sum += std::abs(block.impulses[at(i)]);
    loads_[at(block.bodyA)] += sum * bodies[at(block.bodyA)].mass.inverseMass;
    loads_[at(block.bodyB)] += sum * bodies[at(block.bodyB)].mass.inverseMass;
  }
  IslandError error{0, true};
  for (const ContactBlock& block : blocks) {
    const MovingBody &a = bodies[at(block.bodyA)], &b = bodies[at(block.bodyB)];
    Real here = 0;
    for (int i = 0; i < block.count; ++i) {
      if (!(block.masses[at(i)] > 0)) continue;
      const Real missing = block.targets[at(i)] - speedAtEnd(block.normals[at(i)], a, b);
      const Real most = block.impulses[at(i)] / block.masses[at(i)];  // that can be taken away
      here = std::max(here,
                      block.holds[at(i)] ? std::abs(missing) : std::abs(std::max(missing, -most)));
    }
    if (block.rubs > 0) {
      const Real limit = block.friction * pressureOf(block);
      const Vector3 slip = slipOf(block, bodies);
      const FrictionLaw law = frictionLaw(block, slip - block.matrix * block.rub, limit);
      Vector3 wanted;
      if (law.given) {
        wanted = -limit / law.before.norm() * law.before;
      } else {
        wanted = block.rub - block.lightest * (law.before + slip);
        const Real size = wanted.norm();
        if (size > limit) wanted *= limit / size;
      }
      here = std::max(here, (wanted - block.rub).norm() / block.lightest);
    }
    const Real rounding = kRoundings * (loads_[at(block.bodyA)] + loads_[at(block.bodyB)]);
    error.speed = std::max(error.speed, here);
    // Not a number is not small.
    if (!(here <= rounding)) error.small = false;
  }
  return error;
}

void IslandNewton::dropRounding(std::span<MovingBody> bodies) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!isMovable(bodies[i])) {
      if (bodies[i].velocity.linear != Vector3::Zero()) return;
      if (bodies[i].velocity.angular != Vector3::Zero()) return;
      continue;
    }
    // An inertia is a mass times the square of a length: so its rate is comparable with a speed.
    const Real length =
        std::sqrt(bodies[i].mass.inverseMass / bodies[i].mass.inverseInertia.trace());
    const Real least = kRoundings * loads_[i];
    if (!(bodies[i].velocity.linear.norm() <= least)) return;
    if (!(bodies[i].velocity.angular.norm() * length <= least)) return;
  }
  for (MovingBody& body : bodies) body.velocity = Velocity();
}

bool IslandNewton::prepare(std::span<const MovingBody> bodies,
                           std::span<const ContactBlock> blocks) {
  constexpr int kNone = -1;
  nodes_.assign(bodies.size(), kNone);
  masses_.clear();
  links_.clear();
  work_.assign(blocks.size(), Work());
  const auto nodeOf = [&](int body) {
    if (!isMovable(bodies[at(body)])) return kNone;
    if (nodes_[at(body)] == kNone) {
      nodes_[at(body)] = static_cast<int>(masses_.size());
      masses_.push_back(massOf(bodies[at(body)].mass));
    }
    return nodes_[at(body)];
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const ContactBlock& block = blocks[i];
    Work& work = work_[i];
    work.nodeA = nodeOf(block.bodyA);
    work.nodeB = nodeOf(block.bodyB);
    if (work.nodeA == work.nodeB && work.nodeA != kNone) return false;
    if (work.nodeA != kNone && work.nodeB != kNone) {
      work.link = static_cast<int>(links_.size());
      links_.push_back({work.nodeA, work.nodeB});
    }
    for (int k = 0; k < block.count; ++k) work.stiff[at(k)] = block.masses[at(k)] / kSoftness;
    work.stiffRub = block.lightest / kSoftness;
  }
  if (masses_.empty()) return false;
  matrix_.analyse(static_cast<int>(masses_.size()), links_);
  velocity_.assign(masses_.size(), BodyVector::Zero());
  step_.assign(masses_.size(), BodyVector::Zero());
  hasFactors_ = false;
  return true;
}

// Speeds of the rows with the impulses that the blocks hold, and the law that friction obeys.
void IslandNewton::readSpeeds(std::span<const MovingBody> bodies,
                              std::span<const ContactBlock> blocks) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const ContactBlock& block = blocks[i];
    Work& work = work_[i];
    const MovingBody &a = bodies[at(block.bodyA)], &b = bodies[at(block.bodyB)];
    for (int k = 0; k < block.count; ++k) {
      work.speeds[at(k)] = speedAtEnd(block.normals[at(k)], a, b) - block.targets[at(k)];
    }
    if (block.rubs == 0) continue;
    const Vector3 slip = slipOf(block, bodies);
    const Real limit = block.friction * pressureOf(block);
    work.law = frictionLaw(block, slip - block.matrix * block.rub, limit);
    const Vector3 against = work.law.before + slip;
    for (int k = 0; k < block.rubs; ++k) work.speeds[at(kFirstRub + k)] = against[k];
  }
}

// The impulses of a block's springs, a part t further in the direction that is searched.
void IslandNewton::evaluate(const ContactBlock& block, Real t, Work& work) const {
  Real pressed = 0;
  work.carries = 0;
  for (int i = 0; i < block.count; ++i) {
    work.presses[at(i)] = block.impulses[at(i)];
    if (block.masses[at(i)] > 0) {
      const Real speed = work.speeds[at(i)] + t * work.along[at(i)];
      const Real press = block.impulses[at(i)] - work.stiff[at(i)] * speed;
      const bool carries = press >= 0 || block.holds[at(i)];
      work.presses[at(i)] = carries ? press : 0;
      if (carries) work.carries = static_cast<std::uint8_t>(work.carries | (1u << i));
    }
    pressed += work.presses[at(i)];
  }
  work.mode = Rub::none;
  if (block.rubs == 0) return;
  if (!coupled_) pressed = pressureOf(block);
  const Real limit = block.friction * std::max(pressed, Real(0));
  if (work.law.given) {
    work.mode = Rub::given;
    work.heading = -work.law.before / work.law.before.norm();
    work.rub = limit * work.heading;
    return;
  }
  if (glued_ && work.loose) {
    work.rub = Vector3::Zero();
    return;
  }
  Vector3 rub = block.rub;
  for (int k = 0; k < block.rubs; ++k) {
    rub[k] -= work.stiffRub * (work.speeds[at(kFirstRub + k)] + t * work.along[at(kFirstRub + k)]);
  }
  const Real size = rub.norm();
  if (glued_ || size <= limit) {
    work.mode = glued_ || limit > 0 ? Rub::sticks : Rub::none;
    work.rub = rub;
    return;
  }
  work.mode = limit > 0 ? Rub::slips : Rub::none;
  work.heading = rub / size;
  work.share = limit / size;
  work.rub = limit * work.heading;
}

// What the springs of a block push its bodies with, beside what they were pushed with before.
void IslandNewton::unbalance(const ContactBlock& block, const Work& work,
                             std::span<BodyVector> force) {
  const auto push = [&](int row, Real impulse) {
    Real J[6];
    if (work.nodeA >= 0) {
      sideA(rowOf(block, row), J);
      for (int k = 0; k < 6; ++k) force[at(work.nodeA)][k] += impulse * J[k];
    }
    if (work.nodeB >= 0) {
      sideB(rowOf(block, row), J);
      for (int k = 0; k < 6; ++k) force[at(work.nodeB)][k] += impulse * J[k];
    }
  };
  for (int i = 0; i < block.count; ++i) push(i, work.presses[at(i)] - block.impulses[at(i)]);
  for (int k = 0; k < block.rubs; ++k) push(kFirstRub + k, work.rub[k] - block.rub[k]);
}

// Adds J^T D J, where D says how the impulses fall as the speeds grow.
void IslandNewton::addBlock(const ContactBlock& block, const Work& work) {
  std::array<std::array<Real, 6>, kMostRows> A = {}, B = {};
  std::array<std::array<Real, kMostRows>, kMostRows> D = {};
  std::array<bool, kMostRows> used = {};
  for (int i = 0; i < block.count; ++i) {
    if ((work.carries >> i & 1u) == 0) continue;
    used[at(i)] = true;
    D[at(i)][at(i)] = work.stiff[at(i)];
  }
  if (work.mode != Rub::none) {
    for (int p = 0; p < block.rubs; ++p) {
      const std::size_t row = at(kFirstRub + p);
      used[row] = true;
      if (work.mode == Rub::sticks) {
        D[row][row] = work.stiffRub;
        continue;
      }
      // At its limit friction is the pressure's, in a direction that turns with the slip.
      for (int i = 0; i < block.count && coupled_; ++i) {
        D[row][at(i)] = block.friction * work.heading[p] * D[at(i)][at(i)];
      }
      if (work.mode == Rub::given) continue;
      for (int q = 0; q < block.rubs; ++q) {
        const Real turns = (p == q ? 1.0 : 0.0) - work.heading[p] * work.heading[q];
        D[row][at(kFirstRub + q)] = work.share * work.stiffRub * turns;
      }
    }
  }
  for (int row = 0; row < kMostRows; ++row) {
    if (!used[at(row)]) continue;
    if (work.nodeA >= 0) sideA(rowOf(block, row), A[at(row)].data());
    if (work.nodeB >= 0) sideB(rowOf(block, row), B[at(row)].data());
  }
  // K += left^T D right.
  const auto add = [&](const auto& left, const auto& right, BodyBlock& K) {
    for (std::size_t p = 0; p < kMostRows; ++p) {
      if (!used[p]) continue;
      std::array<Real, 6> sum = {};
      for (std::size_t q = 0; q < kMostRows; ++q) {
        if (!used[q] || D[p][q] == 0) continue;
        for (std::size_t k = 0; k < 6; ++k) sum[k] += D[p][q] * right[q][k];
      }
      for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 6; ++i) K(i, j) += left[p][at(i)] * sum[at(j)];
      }
    }
  };
  if (work.nodeA >= 0) add(A, A, matrix_.diagonal(work.nodeA));
  if (work.nodeB >= 0) add(B, B, matrix_.diagonal(work.nodeB));
  if (work.link < 0) return;
  const BodyMatrix::Sides sides = matrix_.between(work.link);
  add(A, B, sides.firstSecond);
  add(B, A, sides.secondFirst);
}

bool IslandNewton::factor(std::span<const ContactBlock> blocks) {
  matrix_.clear();
  symmetric_ = true;
  for (std::size_t n = 0; n < masses_.size(); ++n) {
    matrix_.diagonal(static_cast<int>(n)) = masses_[n];
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    Work& work = work_[i];
    addBlock(blocks[i], work);
    work.factoredCarries = work.carries;
    work.factoredMode = work.mode;
    if (coupled_ && (work.mode == Rub::slips || work.mode == Rub::given)) symmetric_ = false;
  }
  hasFactors_ = matrix_.factor(symmetric_);
  return hasFactors_;
}

// How much force is left over along the direction of the search; where springs are pressed no
// further by going on it is zero.
Real IslandNewton::slope(std::span<const ContactBlock> blocks, Real t) {
  ++looks_;
  Real sum = 0;
  for (std::size_t n = 0; n < masses_.size(); ++n) {
    const BodyVector moved = velocity_[n] + t * step_[n];
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) sum += step_[n][i] * masses_[n](i, j) * moved[j];
    }
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const ContactBlock& block = blocks[i];
    Work& work = work_[i];
    evaluate(block, t, work);
    for (int k = 0; k < block.count; ++k) {
      sum -= work.along[at(k)] * (work.presses[at(k)] - block.impulses[at(k)]);
    }
    for (int k = 0; k < block.rubs; ++k) {
      sum -= work.along[at(kFirstRub + k)] * (work.rub[k] - block.rub[k]);
    }
  }
  return sum;
}

// How far to go: all the way, or to where the force along the way is gone.
Real IslandNewton::searchLine(std::span<const ContactBlock> blocks, Real start) {
  const Real end = slope(blocks, 1);
  constexpr Real kLittle = 0.1;
  if (!(start < 0) || !(end > -kLittle * start)) return 1;
  Real low = 0, high = 1, atLow = start, atHigh = end;
  constexpr int kMost = 30;
  for (int i = 0; i < kMost; ++i) {
    // A false position in which an end that stays counts for less and less (Illinois), because the
    // slopes at both ends may be very unlike.
    const Real t = low + (high - low) * atLow / (atLow - atHigh);
    const Real here = slope(blocks, t);
    if (std::abs(here) <= -kLittle * start) return t;
    if (here < 0) {
      low = t;
      atLow = here;
      atHigh /= 2;
    } else {
      high = t;
      atHigh = here;
      atLow /= 2;
    }
  }
  return low > 0 ? low : high;
}

// The impulses found are the ones to go on from.
void IslandNewton::accept(std::span<MovingBody> bodies, std::span<ContactBlock> blocks) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    ContactBlock& block = blocks[i];
    const Work& work = work_[i];
    MovingBody &a = bodies[at(block.bodyA)], &b = bodies[at(block.bodyB)];
    for (int k = 0; k < block.count; ++k) {
      pushAlong(block.normals[at(k)], work.presses[at(k)] - block.impulses[at(k)], a, b);
      block.impulses[at(k)] = work.presses[at(k)];
    }
    for (int k = 0; k < block.rubs; ++k) {
      pushAlong(block.tangents[at(k)], work.rub[k] - block.rub[k], a, b);
      block.rub[k] = work.rub[k];
    }
  }
  for (BodyVector& velocity : velocity_) velocity.setZero();
}

// Back to the impulses that the blocks came with, or to none at all.
void IslandNewton::begin(std::span<MovingBody> bodies, std::span<ContactBlock> blocks, bool cold) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].velocity = cold ? free_[i].velocity : keptVelocity_[i];
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    blocks[i].impulses = cold ? std::array<Real, 4>() : kept_[i].impulses;
    blocks[i].rub = cold ? Vector3(Vector3::Zero()) : kept_[i].rub;
  }
  for (BodyVector& velocity : velocity_) velocity.setZero();
  readSpeeds(bodies, blocks);
}

// What rubs without the pressure for it does not rub at all from now on. Returns whether there was
// any.
bool IslandNewton::loosen(std::span<const ContactBlock> blocks) {
  constexpr Real kMore = 1 + 1e-9;
  bool any = false;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const ContactBlock& block = blocks[i];
    if (block.rubs == 0 || work_[i].loose) continue;
    work_[i].loose = block.rub.norm() > kMore * block.friction * pressureOf(block);
    any = any || work_[i].loose;
  }
  return any;
}

// Rounds until only rounding is left; whether that was reached.
bool IslandNewton::iterate(std::span<MovingBody> bodies, std::span<ContactBlock> blocks,
                           const NewtonLimits& limits, NewtonResult& result) {
  const bool rubs = std::any_of(blocks.begin(), blocks.end(),
                                [](const ContactBlock& block) { return block.rubs > 0; });
  glued_ = rubs && std::none_of(blocks.begin(), blocks.end(), [](const ContactBlock& block) {
             return block.rubs > 0 && block.slips;
           });
  // A small error is mended where it is: of many answers the next one to that of the last step.
  constexpr Real kSmall = 1e-6;
  begin(bodies, blocks,
        glued_ && !(errorOf(bodies, blocks, limits.speed).speed < kSmall * limits.speed));
  bool solved = false;  // but for rounding
  bool wasSmall = false;
  int triesGlued = 0;
  coupled_ = rubs && !glued_;
  int roundsHere = 0;
  Real tried = std::numeric_limits<Real>::infinity();  // error when friction was coupled last
  std::int64_t worked = 0;
  Real best = std::numeric_limits<Real>::infinity();
  Real first = 0, before = 0;  // work of the forces left over, of the first and the last round
  Real most = 0;               // the same of all rounds
  const auto beginAnew = [&](bool cold) {
    hasFactors_ = false;
    best = std::numeric_limits<Real>::infinity();
    first = before = most = 0;
    begin(bodies, blocks, cold);
  };
  const auto unglue = [&] {
    glued_ = false;
    coupled_ = true;
    roundsHere = 0;
    beginAnew(false);
  };
  while (result.rounds < limits.rounds) {
    if (glued_ && result.rounds >= limits.rounds / 2) unglue();
    // Forces left over, and whether the factors are still those of these springs.
    for (std::size_t n = 0; n < masses_.size(); ++n) {
      step_[n].setZero();
      for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 6; ++i) step_[n][i] -= masses_[n](i, j) * velocity_[n][j];
      }
    }
    bool same = hasFactors_;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      Work& work = work_[i];
      work.along = {};
      evaluate(blocks[i], 0, work);
      unbalance(blocks[i], work, step_);
      same = same && work.carries == work.factoredCarries && work.mode == work.factoredMode &&
             work.mode != Rub::slips;
    }
    if (!same) {
      worked += matrix_.work() * (symmetric_ ? 1 : 2);
      if (worked > limits.work) break;
      ++result.factorisations;
      if (!factor(blocks)) break;
    }
    matrix_.solve(step_);
    ++result.rounds;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      Work& work = work_[i];
      Real J[6];
      for (int row = 0; row < kMostRows; ++row) {
        if (!hasRow(blocks[i], row)) continue;
        Real change = 0;
        if (work.nodeA >= 0) {
          sideA(rowOf(blocks[i], row), J);
          change += alongRow(J, step_[at(work.nodeA)]);
        }
        if (work.nodeB >= 0) {
          sideB(rowOf(blocks[i], row), J);
          change += alongRow(J, step_[at(work.nodeB)]);
        }
        work.along[at(row)] = change;
      }
    }
    const Real start = slope(blocks, 0);
    first = std::min(first, start);
    // What is left is rounding: the direction means nothing any more.
    constexpr Real kNothing = 1e-24;
    most = std::min(most, start);
    // Of the first forces, in springs that much stiffer than the bodies, roundings are left.
    constexpr Real kNothingOfAll = kRoundings * kRoundings * kSoftness * kSoftness;
    const bool nothing =
        std::abs(start) <= -kNothing * first || std::abs(start) <= -kNothingOfAll * most;
    const Real t = nothing ? 1 : searchLine(blocks, start);
    bool stays = t == 1;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      Work& work = work_[i];
      for (std::size_t row = 0; row < kMostRows; ++row) work.speeds[row] += t * work.along[row];
      work.along = {};
      evaluate(blocks[i], 0, work);
      stays = stays && work.carries == work.factoredCarries && work.mode == work.factoredMode;
    }
    for (std::size_t n = 0; n < masses_.size(); ++n) velocity_[n] += t * step_[n];
    // The springs are far stiffer than the masses: a first solution has half of the digits only.
    constexpr Real kBalanced = 1e-16;
    // Friction whose limit grows with the pressure has no energy that would have to fall, and
    // rounds may wander. With the limit of the impulses held so far there is one.
    constexpr int kPatience = 8;
    if (coupled_ && !nothing && (start > 0 || ++roundsHere > kPatience)) {
      coupled_ = hasFactors_ = false;
      tried = result.error;
      first = before = 0;
      for (BodyVector& velocity : velocity_) velocity.setZero();
      readSpeeds(bodies, blocks);
      continue;
    }
    const bool balanced = nothing || start >= kBalanced * first || start <= before / 2;
    before = start;
    if (!(stays || nothing) || !balanced) {
      if (solved) return true;  // what is left is rounding
      continue;
    }
    first = before = 0;
    roundsHere = 0;
    accept(bodies, blocks);
    const IslandError error = errorOf(bodies, blocks, limits.speed);
    result.error = error.speed;
    // A round costs little while the factors serve: on, until the digits are used up.
    solved = error.small;
    if (error.small && !(error.speed < best / 2)) return true;
    wasSmall = wasSmall || error.small;
    const bool nearer = error.speed < best / 2;
    best = std::min(best, error.speed);
    if (glued_ && !nearer && !wasSmall) {
      // Something has to give way: first what holds on to more than it may, and then anew, with the
      // limits.
      constexpr int kFewTries = 4;
      if (++triesGlued > kFewTries || !loosen(blocks)) {
        unglue();
        continue;
      }
      beginAnew(true);
      continue;
    }
    if (glued_) {
      readSpeeds(bodies, blocks);
      continue;
    }
    constexpr Real kNearer = 0.1;
    if (rubs && !coupled_ && !(error.speed > kNearer * tried)) {
      coupled_ = true;
      hasFactors_ = false;
    }
    readSpeeds(bodies, blocks);
  }
  return solved;
}

// Energy of the bodies that move [J].
Real IslandNewton::energyOf(std::span<const MovingBody> bodies) const {
  Real sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (nodes_[i] < 0) continue;
    const BodyBlock& M = masses_[at(nodes_[i])];
    const Velocity& velocity = bodies[i].velocity;
    for (int k = 0; k < 3; ++k) {
      sum += velocity.linear[k] * M(k, k) * velocity.linear[k] / 2;
      for (int j = 0; j < 3; ++j) {
        sum += velocity.angular[k] * M(3 + k, 3 + j) * velocity.angular[j] / 2;
      }
    }
  }
  return sum;
}

NewtonResult IslandNewton::solve(std::span<MovingBody> bodies, std::span<ContactBlock> blocks,
                                 const NewtonLimits& limits) {
  NewtonResult result;
  if (blocks.empty() || !prepare(bodies, blocks)) return result;
  kept_.clear();
  for (const ContactBlock& block : blocks) kept_.push_back({block.impulses, block.rub});
  keptVelocity_.clear();
  for (const MovingBody& body : bodies) keptVelocity_.push_back(body.velocity);
  free_.assign(bodies.begin(), bodies.end());
  for (const ContactBlock& block : blocks) {
    MovingBody &a = free_[at(block.bodyA)], &b = free_[at(block.bodyB)];
    for (int k = 0; k < block.count; ++k) {
      pushAlong(block.normals[at(k)], -block.impulses[at(k)], a, b);
    }
    for (int k = 0; k < block.rubs; ++k) pushAlong(block.tangents[at(k)], -block.rub[k], a, b);
  }
  looks_ = 0;
  result.solved = iterate(bodies, blocks, limits, result);
  // A look takes as long as four visits of its rows, and those of a round and of its matrix more.
  constexpr std::int64_t kLook = 4, kRound = 8, kMatrix = 20, kProduct = 10;
  std::int64_t rows = 0;
  for (const ContactBlock& block : blocks) rows += block.count + block.rubs;
  result.work = rows * (kLook * looks_ + kRound * result.rounds + kMatrix * result.factorisations) +
                kProduct * result.factorisations * matrix_.work();
  if (result.solved) {
    // Points that turn within the step do a little work; what moves of itself does any.
    constexpr Real kLittle = 1e-3;
    const bool driven = std::any_of(bodies.begin(), bodies.end(), [](const MovingBody& body) {
      return !isMovable(body) &&
             (body.velocity.linear != Vector3::Zero() || body.velocity.angular != Vector3::Zero());
    });
    if (driven || energyOf(bodies) <= (1 + kLittle) * energyOf(free_)) return result;
    result.solved = false;
  }
  begin(bodies, blocks, false);
  return result;
}

}  // namespace carom

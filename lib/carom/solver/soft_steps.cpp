#include "carom/solver/soft_steps.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "carom/core/reserve_ahead.hpp"
#include "carom/solver/soft_rows.hpp"

namespace carom {

namespace {

// The bodies and blocks of one kind of numbers.
template <class T>
struct RowMemory {
  std::vector<BodyRow<T>> velocity, way, gain, push, before;
  std::vector<InertiaRow<T>> inertia;
  std::vector<SoftBlock<T>> blocks;

  SoftBodies<T> bodies(std::size_t movable) {
    return {velocity.data(),
            way.data(),
            gain.data(),
            push.data(),
            before.data(),
            inertia.data(),
            static_cast<std::int32_t>(movable)};
  }
};

void resize(auto& memory, std::size_t bodies) {
  memory.velocity.resize(bodies);
  memory.way.resize(bodies);
  memory.gain.resize(bodies);
  memory.push.resize(bodies);
  memory.before.resize(bodies);
  memory.inertia.resize(bodies);
}

template <class T>
void put(const Vector3& linear, const Vector3& angular, Real sixth, BodyRow<T>& row) {
  for (int i = 0; i < 3; ++i) {
    row.x[i] = static_cast<T>(linear[i]);
    row.x[3 + i] = static_cast<T>(angular[i]);
  }
  row.x[6] = static_cast<T>(sixth);
  row.x[7] = 0;
}

template <class T>
void put(const Vector3& v, LaneRow<T> (&rows)[3], int lane) {
  for (int i = 0; i < 3; ++i) rows[i].x[lane] = static_cast<T>(v[i]);
}

template <class T>
Vector3 vectorOf(const T* x) {
  return {static_cast<Real>(x[0]), static_cast<Real>(x[1]), static_cast<Real>(x[2])};
}

template <class T>
void setBodyRow(RowMemory<T>& m, std::size_t i, const MovingBody& body, const Velocity& gain,
                int shortSteps) {
  const Real part = Real(1) / shortSteps;
  put(body.velocity.linear, body.velocity.angular, body.mass.inverseMass, m.velocity[i]);
  put(part * gain.linear, part * gain.angular, 0, m.gain[i]);
  m.way[i] = m.push[i] = m.before[i] = {};
  const Matrix3& I = body.mass.inverseInertia;
  const Real inertia[6] = {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
  for (int k = 0; k < 6; ++k) m.inertia[i].x[k] = static_cast<T>(inertia[k]);
}

template <class T>
void clearLane(SoftBlock<T>& block, int lane, std::int32_t nobody) {
  block.bodyA[lane] = block.bodyB[lane] = nobody;
  put(Vector3::UnitZ(), block.normal, lane);
  put(Vector3::Zero(), block.tangent[0], lane);
  block.friction.x[lane] = block.restitution.x[lane] = block.twist.x[lane] = 0;
  for (PointRows<T>& point : block.point) {
    put(Vector3::Zero(), point.turns.turnA, lane);
    put(Vector3::Zero(), point.turns.turnB, lane);
    point.mass.x[lane] = point.gap.x[lane] = point.impulse.x[lane] = 0;
  }
}

template <class T>
void setLane(SoftBlock<T>& block, int lane, const PileContact& contact, Real duration) {
  put(contact.normal, block.normal, lane);
  put(duration * contact.rub, block.tangent[0], lane);
  block.friction.x[lane] = static_cast<T>(contact.friction);
  block.restitution.x[lane] = static_cast<T>(contact.restitution);
  const bool mayTwist = contact.count > 1;  // where a face became a corner nothing is left to twist
  block.twist.x[lane] = mayTwist ? static_cast<T>(duration * contact.twist) : T(0);
  for (int i = 0; i < block.points; ++i) {
    PointRows<T>& point = block.point[i];
    const bool used = i < contact.count;
    const SoftPoint& from = contact.points[static_cast<std::size_t>(used ? i : 0)];
    put(used ? from.armA : Vector3::Zero(), point.turns.turnA, lane);
    put(used ? from.armB : Vector3::Zero(), point.turns.turnB, lane);
    point.mass.x[lane] = used ? 1 : 0;
    point.gap.x[lane] = used ? static_cast<T>(from.separation) : 0;
    point.impulse.x[lane] = used ? static_cast<T>(duration * from.force) : 0;
  }
}

template <class T>
SoftForces forcesOf(const SoftBlock<T>& block, int lane, Real duration) {
  SoftForces forces;
  Real pressed = 0;
  for (int i = 0; i < block.points; ++i) {
    const Real impulse = static_cast<Real>(block.point[i].impulse.x[lane]);
    forces.normal[static_cast<std::size_t>(i)] = impulse / duration;
    pressed += impulse;
  }
  const Real rub[2] = {static_cast<Real>(block.rub[0].x[lane]),
                       static_cast<Real>(block.rub[1].x[lane])};
  for (int i = 0; i < 3; ++i) {
    forces.rub[i] = (rub[0] * static_cast<Real>(block.tangent[0][i].x[lane]) +
                     rub[1] * static_cast<Real>(block.tangent[1][i].x[lane])) /
                    duration;
  }
  forces.twist = static_cast<Real>(block.twist.x[lane]) / duration;
  constexpr Real kAlmost = 0.999;  // what is on the cone but for the rounding of floats slips
  const Real limit = kAlmost * static_cast<Real>(block.friction.x[lane]) * pressed;
  forces.sticks = rub[0] * rub[0] + rub[1] * rub[1] < limit * limit;
  return forces;
}

}  // namespace

struct SoftSteps::Memory {
  RowNumbers numbers = RowNumbers::floats;
  std::size_t bodies = 0, movable = 0;
  RowMemory<float> floats;
  RowMemory<double> doubles;
  GraphColors graph;
  std::vector<std::int32_t> colors;      // of the contacts
  std::vector<std::int32_t> order;       // contact at each place, or -1
  std::vector<std::int32_t> firstBlock;  // of each colour, and the end
  std::vector<std::int32_t> heads;       // of the bins of the sort
  std::int64_t rowsOnce = 0;
};

namespace {

// Calls with the rows in use.
auto withRows(auto& memory, auto&& work) {
  return memory.numbers == RowNumbers::floats ? work(memory.floats) : work(memory.doubles);
}

}  // namespace

SoftSteps::SoftSteps() : memory_(std::make_unique<Memory>()) {}
SoftSteps::~SoftSteps() = default;
SoftSteps::SoftSteps(SoftSteps&&) noexcept = default;
SoftSteps& SoftSteps::operator=(SoftSteps&&) noexcept = default;

void SoftSteps::begin(std::size_t bodies, std::size_t movable, RowNumbers numbers) {
  Memory& m = *memory_;
  m.numbers = numbers;
  m.bodies = bodies;
  m.movable = movable;
  // One more, whom nothing moves: for the empty places of blocks.
  withRows(m, [&](auto& rows) {
    resize(rows, bodies + 1);
    setBodyRow(rows, bodies, {}, {}, 1);
  });
}

void SoftSteps::setBody(std::size_t i, const MovingBody& body, const Velocity& gain,
                        int shortSteps) {
  withRows(*memory_, [&](auto& rows) { setBodyRow(rows, i, body, gain, shortSteps); });
}

void SoftSteps::place(std::span<const ColorEdge> contacts, std::span<const std::uint8_t> counts) {
  Memory& m = *memory_;
  const int colors = m.graph.color(contacts, static_cast<std::int32_t>(m.movable), m.colors);
  // Sorted by colour, and within a colour by points, those with most first: the contacts of a block
  // then have about as many.
  constexpr std::size_t kMost = 4;
  const auto bin = [&](std::size_t c) {
    return static_cast<std::size_t>(m.colors[c]) * kMost + (kMost - counts[c]);
  };
  const std::size_t bins = static_cast<std::size_t>(colors) * kMost;
  reserveAhead(m.heads, bins);
  reserveAhead(m.firstBlock, bins);
  m.heads.assign(bins, 0);
  m.rowsOnce = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    ++m.heads[bin(c)];
    m.rowsOnce += counts[c];
  }
  m.firstBlock.clear();
  std::int32_t blocks = 0;
  for (std::size_t color = 0; color < static_cast<std::size_t>(colors); ++color) {
    m.firstBlock.push_back(blocks);
    std::int32_t next = blocks * kBlockWidth;
    for (std::size_t i = color * kMost; i < (color + 1) * kMost; ++i) {
      const std::int32_t size = m.heads[i];
      m.heads[i] = next;
      next += size;
    }
    blocks = (next + kBlockWidth - 1) / kBlockWidth;
  }
  m.firstBlock.push_back(blocks);
  reserveAhead(m.order, static_cast<std::size_t>(blocks * kBlockWidth));
  m.order.assign(static_cast<std::size_t>(blocks * kBlockWidth), -1);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    m.order[static_cast<std::size_t>(m.heads[bin(c)]++)] = static_cast<std::int32_t>(c);
  }
  withRows(m, [&](auto& rows) {
    reserveAhead(rows.blocks, static_cast<std::size_t>(blocks));
    rows.blocks.resize(static_cast<std::size_t>(blocks));
    for (std::size_t b = 0; b < rows.blocks.size(); ++b) {
      auto& block = rows.blocks[b];
      block.points = block.bounces = 0;
      for (int lane = 0; lane < kBlockWidth; ++lane) {
        const std::int32_t c = m.order[b * kBlockWidth + static_cast<std::size_t>(lane)];
        if (c < 0) {
          clearLane(block, lane, static_cast<std::int32_t>(m.bodies));
          continue;
        }
        const std::size_t contact = static_cast<std::size_t>(c);
        block.bodyA[lane] = contacts[contact].a;
        block.bodyB[lane] = contacts[contact].b;
        block.points = std::max<std::int32_t>(block.points, counts[contact]);
      }
    }
  });
}

std::int32_t SoftSteps::contactAt(std::size_t place) const {
  return memory_->order[place];
}

std::size_t SoftSteps::places() const {
  return memory_->order.size();
}

void SoftSteps::setContact(std::size_t place, const PileContact& contact, Real duration) {
  const int lane = static_cast<int>(place % kBlockWidth);
  withRows(*memory_,
           [&](auto& rows) { setLane(rows.blocks[place / kBlockWidth], lane, contact, duration); });
}

namespace {

template <class T>
SoftNumbers<T> numbersOf(const SoftSettings& settings, Real duration) {
  SoftNumbers<T> numbers;
  const Real part = duration / settings.shortSteps;
  numbers.duration = static_cast<T>(part);
  numbers.perDuration = static_cast<T>(1 / part);
  numbers.pull = static_cast<T>(settings.pull / part);
  numbers.massScale = 1;
  numbers.impulseScale = static_cast<T>(settings.give);
  numbers.slowestPull = static_cast<T>(settings.slowestPull);
  numbers.rise = static_cast<T>(settings.rise);
  numbers.fastestPull = static_cast<T>(settings.fastestPull);
  numbers.slowestBounce = static_cast<T>(settings.slowestBounce);
  numbers.little = static_cast<T>(1e-30);
  return numbers;
}

template <class T>
const SoftKernel<T>& kernelOf(RowWidth width) {
  if (width == RowWidth::plain) return plainKernel<T>();
  return width == RowWidth::narrow ? narrowKernel<T>() : widestKernel<T>();
}

// Whether a contact of a block bounces is known when all are described. Returns whether any does.
template <class T>
bool markBounces(SoftBlock<T>* begin, SoftBlock<T>* end) {
  bool any = false;
  for (SoftBlock<T>* block = begin; block != end; ++block) {
    block->bounces = 0;
    for (const T e : block->restitution.x) block->bounces |= e > 0 ? 1 : 0;
    any = any || block->bounces != 0;
  }
  return any;
}

template <class T>
void runSteps(RowMemory<T>& memory, std::size_t bodyCount, std::size_t movable,
              std::span<const std::int32_t> firstBlock, const SoftSettings& settings, Real duration,
              KeptThreads& threads) {
  const SoftKernel<T>& kernel = kernelOf<T>(settings.width);
  const SoftBodies<T> bodies = memory.bodies(movable);
  const SoftNumbers<T> numbers = numbersOf<T>(settings, duration);
  SoftBlock<T>* const blocks = memory.blocks.data();

  // Fewer than these are not worth a second thread.
  constexpr std::size_t kBlocks = 4, kBodies = 128;
  const auto eachBlock = [&](auto&& work) {
    threads.loop(memory.blocks.size(), kBlocks,
                 [&](std::size_t begin, std::size_t end) { work(blocks + begin, blocks + end); });
  };
  const auto eachColor = [&](auto&& work) {
    for (std::size_t color = 0; color + 1 < firstBlock.size(); ++color) {
      SoftBlock<T>* const first = blocks + firstBlock[color];
      const std::size_t count = static_cast<std::size_t>(firstBlock[color + 1] - firstBlock[color]);
      threads.loop(count, kBlocks,
                   [&](std::size_t begin, std::size_t end) { work(first + begin, first + end); });
    }
  };
  const auto eachBody = [&](auto&& work) {
    threads.loop(bodyCount, kBodies, [&](std::size_t begin, std::size_t end) {
      work(static_cast<int>(begin), static_cast<int>(end));
    });
  };

  std::atomic<bool> bounces{false};
  eachBlock([&](auto* begin, auto* end) {
    if (markBounces(begin, end)) bounces.store(true, std::memory_order_relaxed);
    kernel.prepare(begin, end, bodies);
  });
  for (int step = 0; step < settings.shortSteps; ++step) {
    eachBody([&](int begin, int end) {
      if (step > 0) kernel.note(bodies, begin, end);
      kernel.kick(bodies, begin, end);
    });
    if (step == 0) eachColor([&](auto* begin, auto* end) { kernel.warm(begin, end, bodies); });
    eachColor([&](auto* begin, auto* end) { kernel.press(begin, end, bodies, numbers); });
    eachBody([&](int begin, int end) { kernel.drift(bodies, begin, end, numbers); });
    eachColor([&](auto* begin, auto* end) { kernel.relax(begin, end, bodies, numbers); });
  }
  eachBody([&](int begin, int end) { kernel.note(bodies, begin, end); });
  if (bounces) {
    eachColor([&](auto* begin, auto* end) { kernel.bounce(begin, end, bodies, numbers); });
  }
}

template <class T>
SoftMotion motionOf(const RowMemory<T>& memory, std::size_t i) {
  const BodyRow<T>&v = memory.velocity[i], &way = memory.way[i];
  return {{vectorOf(v.x), vectorOf(v.x + 3)}, vectorOf(way.x), vectorOf(way.x + 3), way.x[6] > 0};
}

}  // namespace

SoftCounts SoftSteps::run(const SoftSettings& settings, Real duration, KeptThreads& threads) {
  Memory& m = *memory_;
  withRows(m, [&](auto& rows) {
    runSteps(rows, m.bodies, m.movable, m.firstBlock, settings, duration, threads);
  });
  SoftCounts counts;
  counts.colors = static_cast<int>(m.firstBlock.size()) - 1;
  counts.blocks = m.firstBlock.back();
  counts.rows = m.rowsOnce * settings.shortSteps * 2;
  return counts;
}

SoftMotion SoftSteps::body(std::size_t i) const {
  return withRows(*memory_, [&](const auto& rows) { return motionOf(rows, i); });
}

SoftForces SoftSteps::contact(std::size_t place, Real duration) const {
  const int lane = static_cast<int>(place % kBlockWidth);
  return withRows(*memory_, [&](const auto& rows) {
    return forcesOf(rows.blocks[place / kBlockWidth], lane, duration);
  });
}

}  // namespace carom

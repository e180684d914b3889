// What is done with a block of contacts, for any width of lanes.
//
// Included by a file for each width, compiled with the flags of that width; everything is in an
// unnamed namespace, so that no other file can end up with code that its machine does not know.
// The functions of a block are over a type S that is a number or lanes of them.
// Source: Catto 2024 (Solver2D: soft contacts in short steps with relaxation), Box3D 2025; rows and
// not arms after measuring: 22 against 30 ns for a contact of four points.

#include "carom/core/lanes.hpp"
#include "carom/solver/soft_rows.hpp"

namespace carom {
namespace {

template <class S>
struct V3 {
  S x, y, z;
};

template <class S>
CAROM_LANES_INLINE S dot(const V3<S>& a, const V3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class S>
CAROM_LANES_INLINE V3<S> crossed(const V3<S>& a, const V3<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class S>
CAROM_LANES_INLINE void addTo(V3<S>& a, S s, const V3<S>& b) {
  a.x += s * b.x;
  a.y += s * b.y;
  a.z += s * b.z;
}

template <class S>
CAROM_LANES_INLINE void takeFrom(V3<S>& a, S s, const V3<S>& b) {
  a.x -= s * b.x;
  a.y -= s * b.y;
  a.z -= s * b.z;
}

template <class S, class T>
CAROM_LANES_INLINE S get(const LaneRow<T>& row, int k) {
  return loaded<S>(&row.x[k]);
}

template <class S, class T>
CAROM_LANES_INLINE V3<S> get3(const LaneRow<T> (&rows)[3], int k) {
  return {loaded<S>(&rows[0].x[k]), loaded<S>(&rows[1].x[k]), loaded<S>(&rows[2].x[k])};
}

template <class S, class T>
CAROM_LANES_INLINE void put3(const V3<S>& v, LaneRow<T> (&rows)[3], int k) {
  store(v.x, &rows[0].x[k]);
  store(v.y, &rows[1].x[k]);
  store(v.z, &rows[2].x[k]);
}

// How a body of each lane moves: velocity, or way.
template <class S>
struct Motion {
  V3<S> linear, angular;
  S sixth, seventh;
};

template <class S, class T>
CAROM_LANES_INLINE Motion<S> gathered(const BodyRow<T>* rows, const std::int32_t* who) {
  constexpr int N = LaneTraits<S>::kCount;
  if constexpr (N == 1) {
    const T* x = rows[who[0]].x;
    return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6], x[7]};
  } else {
    S c[8];
    for (int half = 0; half < 8; half += N) {
      for (int i = 0; i < N; ++i) c[half + i] = loaded<S>(&rows[who[i]].x[half]);
      transposeLanes(c + half);
    }
    return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, c[6], c[7]};
  }
}

template <class S, class T>
CAROM_LANES_INLINE void scatter(const Motion<S>& m, BodyRow<T>* rows, const std::int32_t* who,
                                std::int32_t movable) {
  constexpr int N = LaneTraits<S>::kCount;
  if constexpr (N == 1) {
    if (who[0] >= movable) return;
    T* x = rows[who[0]].x;
    x[0] = m.linear.x, x[1] = m.linear.y, x[2] = m.linear.z;
    x[3] = m.angular.x, x[4] = m.angular.y, x[5] = m.angular.z;
  } else {
    S c[8] = {m.linear.x,  m.linear.y,  m.linear.z, m.angular.x,
              m.angular.y, m.angular.z, m.sixth,    m.seventh};
    for (int half = 0; half < 8; half += N) {
      transposeLanes(c + half);
      for (int i = 0; i < N; ++i) {
        if (who[i] < movable) store(c[half + i], &rows[who[i]].x[half]);
      }
    }
  }
}

// Speed along a row.
template <class S, class T>
CAROM_LANES_INLINE S along(const V3<S>& direction, const TurnRows<T>& turns, int k,
                           const Motion<S>& a, const Motion<S>& b) {
  const V3<S> apart{b.linear.x - a.linear.x, b.linear.y - a.linear.y, b.linear.z - a.linear.z};
  return dot(direction, apart) +
         (dot(get3<S>(turns.turnB, k), b.angular) - dot(get3<S>(turns.turnA, k), a.angular));
}

template <class S, class T>
CAROM_LANES_INLINE void pushBoth(S impulse, const V3<S>& direction, const TurnRows<T>& turns, int k,
                                 Motion<S>& a, Motion<S>& b) {
  takeFrom(a.linear, impulse * a.sixth, direction);
  addTo(b.linear, impulse * b.sixth, direction);
  takeFrom(a.angular, impulse, get3<S>(turns.spinA, k));
  addTo(b.angular, impulse, get3<S>(turns.spinB, k));
}

template <class S>
struct Inertia {
  S xx, yy, zz, xy, xz, yz;
};

template <class S, class T>
CAROM_LANES_INLINE Inertia<S> inertiaOf(const InertiaRow<T>* rows, const std::int32_t* who) {
  constexpr int N = LaneTraits<S>::kCount;
  if constexpr (N == 1) {
    const T* x = rows[who[0]].x;
    return {x[0], x[1], x[2], x[3], x[4], x[5]};
  } else {
    S c[6];
    for (int j = 0; j < 6; ++j) {
      c[j] = everywhere<S>(rows[who[0]].x[j]);
      for (int i = 1; i < N; ++i) c[j].v[i] = rows[who[i]].x[j];
    }
    return {c[0], c[1], c[2], c[3], c[4], c[5]};
  }
}

template <class S>
CAROM_LANES_INLINE V3<S> spun(const Inertia<S>& m, const V3<S>& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

// 1 / x, or zero where x is not positive.
template <class S>
CAROM_LANES_INLINE S inverseOf(S x) {
  using T = typename LaneTraits<S>::Number;
  const S zero = everywhere<S>(T(0)), one = everywhere<S>(T(1));
  const auto positive = x > zero;
  return select(positive, one / select(positive, x, one), zero);
}

// Arms become rows. Returns how a unit impulse changes the speed by turning the bodies.
template <class S, class T>
CAROM_LANES_INLINE S prepareTurns(const V3<S>& direction, const V3<S>& armA, const V3<S>& armB,
                                  const Inertia<S>& inertiaA, const Inertia<S>& inertiaB,
                                  TurnRows<T>& turns, int k) {
  const V3<S> turnA = crossed(armA, direction), turnB = crossed(armB, direction);
  const V3<S> spinA = spun(inertiaA, turnA), spinB = spun(inertiaB, turnB);
  put3(turnA, turns.turnA, k);
  put3(turnB, turns.turnB, k);
  put3(spinA, turns.spinA, k);
  put3(spinB, turns.spinB, k);
  return dot(turnA, spinA) + dot(turnB, spinB);
}

template <class S, class T>
CAROM_LANES_INLINE void prepareLanes(SoftBlock<T>& block, int k, const SoftBodies<T>& bodies) {
  const Motion<S> a = gathered<S>(bodies.velocity, block.bodyA + k);
  const Motion<S> b = gathered<S>(bodies.velocity, block.bodyB + k);
  const Inertia<S> inertiaA = inertiaOf<S>(bodies.inertia, block.bodyA + k);
  const Inertia<S> inertiaB = inertiaOf<S>(bodies.inertia, block.bodyB + k);
  const S zero = everywhere<S>(T(0)), one = everywhere<S>(T(1));
  const V3<S> n = get3<S>(block.normal, k);
  const S masses = a.sixth + b.sixth;
  store(masses, &block.masses.x[k]);
  // The centre of pressure, by the impulses to start with, or the middle of the points.
  S pressed = zero, there = zero;
  for (int i = 0; i < block.points; ++i) {
    pressed += get<S>(block.point[i].impulse, k);
    there += get<S>(block.point[i].mass, k);
  }
  // What is next to nothing says nothing: its inverse would be infinite.
  const auto known = pressed > everywhere<S>(T(1e-30));
  const S share = inverseOf(select(known, pressed, there));
  V3<S> centreA{zero, zero, zero}, centreB{zero, zero, zero};
  const auto weightOf = [&](int i) {
    return share * select(known, get<S>(block.point[i].impulse, k), get<S>(block.point[i].mass, k));
  };
  for (int i = 0; i < block.points; ++i) {
    const S weight = weightOf(i);
    addTo(centreA, weight, get3<S>(block.point[i].turns.turnA, k));
    addTo(centreB, weight, get3<S>(block.point[i].turns.turnB, k));
  }
  S radius = zero;
  for (int i = 0; i < block.points; ++i) {
    const V3<S> arm = get3<S>(block.point[i].turns.turnB, k);
    const V3<S> off{arm.x - centreB.x, arm.y - centreB.y, arm.z - centreB.z};
    radius += weightOf(i) * squareRoot(dot(off, off));
  }
  // About a single point nothing holds, whatever the others of its block have.
  store(select(there > one, radius, zero), &block.radius.x[k]);

  for (int i = 0; i < block.points; ++i) {
    PointRows<T>& point = block.point[i];
    const V3<S> armA = get3<S>(point.turns.turnA, k), armB = get3<S>(point.turns.turnB, k);
    const S turning = prepareTurns(n, armA, armB, inertiaA, inertiaB, point.turns, k);
    store(get<S>(point.mass, k) * inverseOf(masses + turning), &point.mass.x[k]);
    store(along(n, point.turns, k, a, b), &point.approach.x[k]);
    store(zero, &point.most.x[k]);
  }

  // Two directions across the normal (Duff and others 2017).
  const S sign = select(zero > n.z, -one, one);
  const S p = -(one / (sign + n.z)), q = n.x * n.y * p;
  const V3<S> t[2] = {{one + sign * n.x * n.x * p, sign * q, -(sign * n.x)},
                      {q, sign + n.y * n.y * p, -n.y}};
  const V3<S> rub = get3<S>(block.tangent[0], k);
  S matrix[2];
  for (int j = 0; j < 2; ++j) {
    put3(t[j], block.tangent[j], k);
    store(dot(t[j], rub), &block.rub[j].x[k]);
    matrix[j] = masses + prepareTurns(t[j], centreA, centreB, inertiaA, inertiaB, block.rubs[j], k);
  }
  const S across = dot(get3<S>(block.rubs[0].turnA, k), get3<S>(block.rubs[1].spinA, k)) +
                   dot(get3<S>(block.rubs[0].turnB, k), get3<S>(block.rubs[1].spinB, k));
  const S share2 = inverseOf(matrix[0] * matrix[1] - across * across);
  store(share2 * matrix[1], &block.stick[0].x[k]);
  store(-(share2 * across), &block.stick[1].x[k]);
  store(share2 * matrix[0], &block.stick[2].x[k]);
  const V3<S> twistA = spun(inertiaA, n), twistB = spun(inertiaB, n);
  put3(twistA, block.twistA, k);
  put3(twistB, block.twistB, k);
  store(inverseOf(dot(n, twistA) + dot(n, twistB)), &block.twistMass.x[k]);
}

template <class S, class T>
CAROM_LANES_INLINE void warmLanes(SoftBlock<T>& block, int k, const SoftBodies<T>& bodies) {
  Motion<S> a = gathered<S>(bodies.velocity, block.bodyA + k);
  Motion<S> b = gathered<S>(bodies.velocity, block.bodyB + k);
  const V3<S> n = get3<S>(block.normal, k);
  for (int j = 0; j < 2; ++j) {
    pushBoth(get<S>(block.rub[j], k), get3<S>(block.tangent[j], k), block.rubs[j], k, a, b);
  }
  const S twist = get<S>(block.twist, k);
  takeFrom(a.angular, twist, get3<S>(block.twistA, k));
  addTo(b.angular, twist, get3<S>(block.twistB, k));
  for (int i = 0; i < block.points; ++i) {
    pushBoth(get<S>(block.point[i].impulse, k), n, block.point[i].turns, k, a, b);
  }
  scatter(a, bodies.velocity, block.bodyA + k, bodies.movable);
  scatter(b, bodies.velocity, block.bodyB + k, bodies.movable);
}

// Friction of the whole contact: first the turning, then the two directions within the cone.
template <class S, class T>
CAROM_LANES_INLINE void rubLanes(SoftBlock<T>& block, int k, const V3<S>& n,
                                 const SoftNumbers<T>& numbers, Motion<S>& a, Motion<S>& b) {
  S pressed = everywhere<S>(T(0));
  for (int i = 0; i < block.points; ++i) pressed += get<S>(block.point[i].impulse, k);
  const S limit = get<S>(block.friction, k) * pressed;
  if (block.points > 1) {
    const S most = limit * get<S>(block.radius, k);
    const V3<S> turning{b.angular.x - a.angular.x, b.angular.y - a.angular.y,
                        b.angular.z - a.angular.z};
    const S old = get<S>(block.twist, k);
    const S wanted = old - get<S>(block.twistMass, k) * dot(n, turning);
    const S twist = larger(-most, smaller(wanted, most));
    store(twist, &block.twist.x[k]);
    takeFrom(a.angular, twist - old, get3<S>(block.twistA, k));
    addTo(b.angular, twist - old, get3<S>(block.twistB, k));
  }
  const V3<S> t0 = get3<S>(block.tangent[0], k), t1 = get3<S>(block.tangent[1], k);
  const S slip0 = along(t0, block.rubs[0], k, a, b), slip1 = along(t1, block.rubs[1], k, a, b);
  const S old0 = get<S>(block.rub[0], k), old1 = get<S>(block.rub[1], k);
  const S xy = get<S>(block.stick[1], k);
  S rub0 = old0 - (get<S>(block.stick[0], k) * slip0 + xy * slip1);
  S rub1 = old1 - (xy * slip0 + get<S>(block.stick[2], k) * slip1);
  const S size = squareRoot(rub0 * rub0 + rub1 * rub1);
  const S scale = limit / larger(size, everywhere<S>(numbers.little));
  const S held = smaller(scale, everywhere<S>(T(1)));
  rub0 = rub0 * held;
  rub1 = rub1 * held;
  store(rub0, &block.rub[0].x[k]);
  store(rub1, &block.rub[1].x[k]);
  pushBoth(rub0 - old0, t0, block.rubs[0], k, a, b);
  pushBoth(rub1 - old1, t1, block.rubs[1], k, a, b);
}

template <class S, bool kPulls, class T>
CAROM_LANES_INLINE void visitLanes(SoftBlock<T>& block, int k, const SoftBodies<T>& bodies,
                                   const SoftNumbers<T>& numbers) {
  Motion<S> a = gathered<S>(bodies.velocity, block.bodyA + k);
  Motion<S> b = gathered<S>(bodies.velocity, block.bodyB + k);
  const Motion<S> wayA = gathered<S>(bodies.way, block.bodyA + k);
  const Motion<S> wayB = gathered<S>(bodies.way, block.bodyB + k);
  const V3<S> n = get3<S>(block.normal, k);
  const S zero = everywhere<S>(T(0)), one = everywhere<S>(T(1));
  const S perDuration = everywhere<S>(numbers.perDuration);
  const S pull = everywhere<S>(numbers.pull), fastest = everywhere<S>(-numbers.fastestPull);
  const S rise = everywhere<S>(numbers.rise), slowest = everywhere<S>(numbers.slowestPull);
  const S massScale = everywhere<S>(numbers.massScale);
  const S impulseScale = everywhere<S>(numbers.impulseScale);
  for (int i = 0; i < block.points; ++i) {
    PointRows<T>& point = block.point[i];
    const S gap = get<S>(point.gap, k) + along(n, point.turns, k, wayA, wayB);
    const S speed = along(n, point.turns, k, a, b);
    const S mass = get<S>(point.mass, k), old = get<S>(point.impulse, k);
    // What is apart may come as near as it is; what overlaps is pulled apart, or left.
    const auto apart = gap > zero;
    S wanted;
    if constexpr (kPulls) {
      // What is deep is lifted out at leisure.
      const S lift = larger(gap * rise - slowest, fastest);
      const S bias = larger(gap * select(apart, perDuration, pull), lift);
      const S scaled = mass * select(apart, one, massScale);
      wanted = old - scaled * (speed + bias) - select(apart, zero, impulseScale) * old;
    } else {
      wanted = old - mass * (speed + select(apart, gap * perDuration, zero));
    }
    const S impulse = larger(wanted, zero);
    store(impulse, &point.impulse.x[k]);
    if (block.bounces != 0) {
      store(larger(get<S>(point.most, k), impulse), &point.most.x[k]);
    }
    pushBoth(impulse - old, n, point.turns, k, a, b);
  }
  if constexpr (!kPulls) rubLanes(block, k, n, numbers, a, b);
  scatter(a, bodies.velocity, block.bodyA + k, bodies.movable);
  scatter(b, bodies.velocity, block.bodyB + k, bodies.movable);
}

template <class S, class T>
CAROM_LANES_INLINE void bounceLanes(SoftBlock<T>& block, int k, const SoftBodies<T>& bodies,
                                    const SoftNumbers<T>& numbers) {
  Motion<S> a = gathered<S>(bodies.velocity, block.bodyA + k);
  Motion<S> b = gathered<S>(bodies.velocity, block.bodyB + k);
  const V3<S> n = get3<S>(block.normal, k);
  const S zero = everywhere<S>(T(0));
  const S restitution = get<S>(block.restitution, k);
  for (int i = 0; i < block.points; ++i) {
    PointRows<T>& point = block.point[i];
    const S approach = get<S>(point.approach, k), old = get<S>(point.impulse, k);
    const S speed = along(n, point.turns, k, a, b);
    const S wanted = larger(old - get<S>(point.mass, k) * (speed + restitution * approach), zero);
    // What did approach fast enough, and has met.
    const S fast = select(-approach > everywhere<S>(numbers.slowestBounce), wanted, old);
    const S impulse = select(restitution * get<S>(point.most, k) > zero, fast, old);
    store(impulse, &point.impulse.x[k]);
    pushBoth(impulse - old, n, point.turns, k, a, b);
  }
  scatter(a, bodies.velocity, block.bodyA + k, bodies.movable);
  scatter(b, bodies.velocity, block.bodyB + k, bodies.movable);
}

// --- The kernel: the above over ranges.

template <class S, class T>
void prepare(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies) {
  for (SoftBlock<T>* block = begin; block != end; ++block) {
    for (int k = 0; k < kBlockWidth; k += LaneTraits<S>::kCount) {
      prepareLanes<S>(*block, k, bodies);
    }
  }
}

template <class S, class T>
void warm(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies) {
  for (SoftBlock<T>* block = begin; block != end; ++block) {
    for (int k = 0; k < kBlockWidth; k += LaneTraits<S>::kCount) warmLanes<S>(*block, k, bodies);
  }
}

template <class S, bool kPulls, class T>
void visit(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies,
           const SoftNumbers<T>& numbers) {
  for (SoftBlock<T>* block = begin; block != end; ++block) {
    for (int k = 0; k < kBlockWidth; k += LaneTraits<S>::kCount) {
      visitLanes<S, kPulls>(*block, k, bodies, numbers);
    }
  }
}

template <class S, class T>
void bounce(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies,
            const SoftNumbers<T>& numbers) {
  for (SoftBlock<T>* block = begin; block != end; ++block) {
    if (block->bounces == 0) continue;
    for (int k = 0; k < kBlockWidth; k += LaneTraits<S>::kCount) {
      bounceLanes<S>(*block, k, bodies, numbers);
    }
  }
}

template <class T>
void kick(const SoftBodies<T>& bodies, int begin, int end) {
  for (int i = begin; i < end; ++i) {
    for (int j = 0; j < 8; ++j) {
      const T free = bodies.velocity[i].x[j] + bodies.gain[i].x[j];
      bodies.before[i].x[j] = free;
      bodies.velocity[i].x[j] = free + bodies.push[i].x[j];
    }
  }
}

template <class T>
void drift(const SoftBodies<T>& bodies, int begin, int end, const SoftNumbers<T>& numbers) {
  for (int i = begin; i < end; ++i) {
    for (int j = 0; j < 6; ++j) {
      bodies.way[i].x[j] += numbers.duration * bodies.velocity[i].x[j];
    }
  }
}

template <class T>
void note(const SoftBodies<T>& bodies, int begin, int end) {
  for (int i = begin; i < end; ++i) {
    bool touched = false;
    for (int j = 0; j < 6; ++j) {
      const T push = bodies.velocity[i].x[j] - bodies.before[i].x[j];
      bodies.push[i].x[j] = push;
      touched = touched || push != 0;
    }
    if (touched) bodies.way[i].x[6] = 1;
  }
}

template <class S>
SoftKernel<typename LaneTraits<S>::Number> kernelOf() {
  using T = typename LaneTraits<S>::Number;
  return {LaneTraits<S>::kCount,
          prepare<S, T>,
          warm<S, T>,
          visit<S, true, T>,
          visit<S, false, T>,
          bounce<S, T>,
          kick<T>,
          drift<T>,
          note<T>};
}

}  // namespace
}  // namespace carom

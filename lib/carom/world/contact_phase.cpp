#include "carom/world/contact_phase.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/solver/solve_island.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// What of a body is at a point: the names of points say so (manifold/contact_ids.hpp).
FeatureKind kindAt(std::uint32_t half) {
  return static_cast<FeatureKind>((half >> 14) & 3u);
}

// An arm after a while: turned with its body.
Vector3 turnedArm(const Vector3& arm, const Vector3& rate, Real duration) {
  return quaternionToMatrix(integrateOrientation(Quaternion{}, rate, duration)) * arm;
}

// Two round surfaces that touch: the normal turns as their middles go round each other, and arms
// stay on it. Impulses act along that of the middle of the time; that of the end is met by the
// drift.
void turnNormal(const Vector3& parting, Real duration, PatchPoint& point, Vector3& normal) {
  const Vector3 apart = point.armA - point.armB;  // from A's centre to B's
  const auto normalAt = [&](Real time) { return Vector3((apart + time * parting).normalized()); };
  const Vector3 middle = normalAt(duration / 2), end = normalAt(duration);
  point.armA = point.armA.norm() * middle;
  point.armB = -point.armB.norm() * middle;
  point.drift = parting.dot(end - middle) * middle;
  normal = middle;
}

// Arms at the middle of the time, and what they will add to the velocity until its end.
void moveArms(const WorldState& state, const PairSlot& pair, std::uint32_t id,
              const PhaseTask& task, PatchPoint& point, Vector3& normal) {
  const Real duration = task.end - task.start;
  const BodySlot &a = state.bodies[at(pair.bodyA)], &b = state.bodies[at(pair.bodyB)];
  const Vector3 &wA = a.velocity.angular, &wB = b.velocity.angular;
  if (wA == Vector3::Zero() && wB == Vector3::Zero() && !(a.mass.inverseMass > 0)) return;
  // A corner that turns far is somewhere else by then, and is no contact there: its speed at the end
  // is not what anything has to stop.
  if (task.speculative && std::max(wA.norm(), wB.norm()) * duration > kFastTurn) return;
  const FeatureKind onA = kindAt(id >> 16), onB = kindAt(id);
  const bool cornerA = onA == FeatureKind::vertex, cornerB = onB == FeatureKind::vertex;
  const bool roundA = onA == FeatureKind::surface, roundB = onB == FeatureKind::surface;
  if (!cornerA && !cornerB && !roundA && !roundB) return;
  const Vector3 parting = b.velocity.linear - a.velocity.linear;
  if (isCentredBall(state.shapes[at(pair.shapeA)]) &&
      isCentredBall(state.shapes[at(pair.shapeB)])) {
    // What is still apart must not come nearer along the normal of the start.
    if (!task.speculative) turnNormal(parting, duration, point, normal);
    return;
  }
  // The point moves with the body whose corner it is, or below the middle of the round one.
  const bool withB = cornerB || (roundB && !cornerA);
  const Vector3 between = point.armB - point.armA;  // from B's centre to A's
  const auto arms = [&](Real time) {
    PatchPoint then;
    const Vector3 apart = between - time * parting;
    if (withB) {
      then.armB = cornerB ? turnedArm(point.armB, wB, time) : point.armB;
      then.armA = then.armB - apart;
    } else {
      then.armA = cornerA ? turnedArm(point.armA, wA, time) : point.armA;
      then.armB = then.armA + apart;
    }
    return then;
  };
  const PatchPoint middle = arms(duration / 2), end = arms(duration);
  point.before =
      cross(wB, Vector3(middle.armB - point.armB)) - cross(wA, Vector3(middle.armA - point.armA));
  point.armA = middle.armA;
  point.armB = middle.armB;
  point.drift =
      cross(wB, Vector3(end.armB - middle.armB)) - cross(wA, Vector3(end.armA - middle.armA));
}

}  // namespace

bool solveBlocks(WorldState& state, Real scale, bool strikes) {
  const Real fall = state.settings.gravity.norm() * state.lastStep;
  Workspace& work = state.work;
  const IslandLimits limits{.sweeps = {.least = state.settings.iterations,
                                       .rowBudget = static_cast<int>(std::min<std::int64_t>(
                                           state.settings.rowBudget, work.rowsLeft)),
                                       .speed = scale},
                            .direct = state.settings.directIslands,
                            .newton = work.mayFactor,
                            .moves = strikes || scale > fall,
                            .directWork = state.settings.directWork};
  const IslandSolution done = solveIsland(work.newton, work.moving, work.blocks, limits);
  state.counters.rowsSolved += done.rows;
  // Many events of one step share what one may cost, and what cannot be solved directly is not
  // tried at the next event.
  work.rowsLeft -= std::min(done.rows, work.rowsLeft);
  const bool gaveUp = done.factorisations > 0 && !done.direct;
  if (gaveUp) work.mayFactor = false;
  state.counters.islandsDirect += done.direct ? 1 : 0;
  state.counters.islandsGivenUp += gaveUp ? 1 : 0;
  state.counters.factorisations += done.factorisations;
  state.counters.directWork += done.directWork;
  if (done.looked) work.newton.dropRounding(work.moving);
  return done.settled;
}

Real fastestOf(const Workspace& work, Real least) {
  Real speed = least;
  for (const MovingBody& body : work.moving) {
    speed = std::max(speed, body.velocity.linear.norm());
    const Real turning = body.mass.inverseInertia.trace();
    if (!(turning > 0)) continue;
    // An inertia is a mass times the square of a length.
    const Real length = std::sqrt(3 * body.mass.inverseMass / turning);
    speed = std::max(speed, length * body.velocity.angular.norm());
  }
  return std::max(speed, std::numeric_limits<Real>::min());
}

Real slowSpeed(const WorldState& state) {
  return state.slowestImpact;
}

Real partingSpeed(const WorldState& state, const PairSlot& pair, int point) {
  const BodySlot &a = state.bodies[at(pair.bodyA)], &b = state.bodies[at(pair.bodyB)];
  const PatchPoint arms = armsOf(state, pair, point);
  return pair.manifold.normal.dot(b.velocity.linear + cross(b.velocity.angular, arms.armB) -
                                  a.velocity.linear - cross(a.velocity.angular, arms.armA));
}

bool isHeld(const WorldState& state, const PairSlot& pair) {
  for (int i = 0; i < pair.manifold.count; ++i) {
    if (isClosed(state, pair, i) && partingSpeed(state, pair, i) <= slowSpeed(state)) return true;
  }
  return false;
}

PatchPoint armsOf(const WorldState& state, const PairSlot& pair, int point) {
  const Vector3& where = pair.manifold.points[at(point)].position;
  PatchPoint arms;
  arms.armA = where - state.bodies[at(pair.bodyA)].position;
  arms.armB = where - state.bodies[at(pair.bodyB)].position;
  return arms;
}

void gather(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs) {
  Workspace& work = state.work;
  work.moving.clear();
  work.members.clear();
  const auto take = [&](Index index) {
    BodySlot& body = state.bodies[at(index)];
    body.local = static_cast<Index>(work.moving.size());
    work.moving.push_back({body.mass, body.velocity});
    work.members.push_back(index);
  };
  for (const Index body : bodies) take(body);
  const auto isTaken = [&](Index index) {
    const Index local = state.bodies[at(index)].local;
    return local >= 0 && at(local) < work.members.size() && work.members[at(local)] == index;
  };
  for (const Index pair : pairs) {
    for (const Index body : {state.pairs[at(pair)].bodyA, state.pairs[at(pair)].bodyB}) {
      if (!isTaken(body)) take(body);
    }
  }
}

WorkPatch patchOf(const WorldState& state, Index index) {
  const PairSlot& pair = state.pairs[at(index)];
  WorkPatch work;
  work.pair = index;
  ContactPatch& patch = work.patch;
  patch.bodyA = state.bodies[at(pair.bodyA)].local;
  patch.bodyB = state.bodies[at(pair.bodyB)].local;
  patch.normal = pair.manifold.normal;
  patch.friction = pair.friction;
  patch.count = 0;
  return work;
}

void addPoint(WorkPatch& work, int pointOfManifold, const PatchPoint& point) {
  work.pointOf[at(work.patch.count)] = pointOfManifold;
  work.patch.points[at(work.patch.count++)] = point;
}

namespace {

// On ground of many pieces each point rubs by itself. One body may stand on several pieces, and the
// centre of pressure on each of them changes as soon as a corner goes from one to the next.
void addPoints(WorldState& state, const WorkPatch& work) {
  Real sum = 0;
  for (int k = 0; k < work.patch.count; ++k) sum += work.patch.points[at(k)].impulse;
  for (int k = 0; k < work.patch.count; ++k) {
    const PatchPoint& point = work.patch.points[at(k)];
    WorkPatch one = work;
    one.patch.count = 0;
    one.patch.twist = 0;
    one.patch.rub *= sum > 0 ? point.impulse / sum : Real(1) / work.patch.count;
    addPoint(one, work.pointOf[at(k)], point);
    state.work.patches.push_back(one);
  }
}

// The rows of one pair, with the forces of the last solution to start from.
void addPatch(WorldState& state, const PhaseTask& task, Index index) {
  const PairSlot& pair = state.pairs[at(index)];
  const Real duration = task.end - task.start;
  WorkPatch work = patchOf(state, index);
  ContactPatch& patch = work.patch;
  const Real slow = slowSpeed(state);
  for (int i = 0; i < pair.manifold.count; ++i) {
    const ManifoldPoint& made = pair.manifold.points[at(i)];
    if (!task.speculative) {
      if (!isClosed(state, pair, i) || partingSpeed(state, pair, i) > slow) continue;
    }
    PatchPoint point = armsOf(state, pair, i);
    if (state.settings.trapezoidal) {
      moveArms(state, pair, made.id, task, point, patch.normal);
    }
    if (task.speculative && made.separation > 0) point.target = -made.separation / duration;
    if (state.settings.warmStarting) point.impulse = pair.force[at(i)] * duration;
    addPoint(work, i, point);
  }
  if (patch.count == 0) return;
  if (state.settings.warmStarting) {
    patch.rub = pair.rub * duration;
    patch.twist = pair.twist * duration;
  }
  // A contact that stuck starts to slip only if it must; one that slips does so down to rounding.
  constexpr Real kStuck = 1e-3, kNone = 1e-10;
  const Real step = state.settings.gravity.norm() * state.lastStep;
  patch.slowest = (pair.sticks ? kStuck : kNone) * step + 1e-12;
  // A slip whose end nobody looks for must not be driven beyond it.
  if (task.speculative) patch.slowest = std::numeric_limits<Real>::infinity();
  if (state.shapes[at(pair.shapeA)].data->ground && patch.count > 1) {
    addPoints(state, work);
  } else {
    state.work.patches.push_back(work);
  }
}

// External forces, and what a body's own turning does to its rate. If the end is known the solver
// has the inertia of there.
void accelerate(WorldState& state, Real duration, bool endKnown = false) {
  Workspace& work = state.work;
  for (std::size_t i = 0; i < work.members.size(); ++i) {
    const BodySlot& body = state.bodies[at(work.members[i])];
    if (!isDynamic(body)) continue;
    MovingBody& moving = work.moving[i];
    moving.velocity.linear += duration * freeAcceleration(state, body);
    if (nutates(state, body)) {
      const Matrix3& R = body.pose.R_WB;
      moving.velocity.angular =
          endKnown ? Vector3(moving.mass.inverseInertia *
                             (R * body.moments.cwiseProduct(R.transpose() * body.velocity.angular)))
                   : turnedRate(body, duration);
    }
    if (body.torque != Vector3::Zero()) {
      moving.velocity.angular += duration * (moving.mass.inverseInertia * body.torque);
    }
  }
}

// All bodies as they were at the start.
void goBack(WorldState& state) {
  for (std::size_t i = 0; i < state.work.members.size(); ++i) {
    state.work.moving[i].velocity = state.bodies[at(state.work.members[i])].velocity;
  }
}

// The sum over all rows of their impulses times the speed that `speed` gives for (row, block).
template <typename Speed>
Real sumOverRows(const Workspace& work, const Speed& speed) {
  Real sum = 0;
  for (const ContactBlock& block : work.blocks) {
    const auto add = [&](const PushRow& row, Real impulse) {
      if (impulse != 0) sum += impulse * speed(row, block);
    };
    for (int i = 0; i < block.count; ++i) add(block.normals[at(i)], block.impulses[at(i)]);
    for (int k = 0; k < block.rubs; ++k) add(block.tangents[at(k)], block.rub[k]);
  }
  return sum;
}

// What the contacts do for the bodies if these move by the mean of their velocities [J].
Real workOf(const WorldState& state) {
  const Workspace& work = state.work;
  const auto before = [&](int local) {
    return MovingBody{{}, state.bodies[at(work.members[at(local)])].velocity};
  };
  return sumOverRows(work, [&](const PushRow& row, const ContactBlock& block) {
    return (speedAtEnd(row, before(block.bodyA), before(block.bodyB)) +
            speedAtEnd(row, work.moving[at(block.bodyA)], work.moving[at(block.bodyB)])) /
           2;
  });
}

// What the impulses of all contacts do for bodies that move as they do now [J].
Real pushOf(const Workspace& work) {
  return sumOverRows(work, [&](const PushRow& row, const ContactBlock& block) {
    return speedAtEnd(row, work.moving[at(block.bodyA)], work.moving[at(block.bodyB)]);
  });
}

// Blocks of all patches, of the bodies as they move at the start; then what acts on these, and the
// impulses to begin with. Contacts take energy or leave it: impulses that would make some are those
// of another moment, such as a knock, and sweeps that end before they have gone throw bodies away.
void prepareBlocks(WorldState& state, Real duration, bool endKnown = false) {
  Workspace& work = state.work;
  work.blocks.clear();
  for (const WorkPatch& one : work.patches) {
    work.blocks.push_back(prepareBlock(one.patch, work.moving));
  }
  accelerate(state, duration, endKnown);
  const Real before = pushOf(work);
  for (const ContactBlock& block : work.blocks) warmStart(block, work.moving);
  if (!(before + pushOf(work) > 0)) return;
  for (ContactBlock& block : work.blocks) {
    block.impulses = {};
    block.rub = Vector3::Zero();
  }
  goBack(state);
  accelerate(state, duration, endKnown);
}

// Whether a body nutates by more than nobody would see, and not so far that a torque that seems to
// hold it at the end would push it on the way there.
bool turnsByPart(const WorldState& state, const BodySlot& body, Real duration) {
  constexpr Real kUnseen = 1e-6, kFar = 0.1;  // [rad]
  const Real turn = body.velocity.angular.norm() * duration;
  return nutates(state, body) && turn > kUnseen && turn < kFar;
}

// A torque turns a body a little farther than it turns by itself, and the inertia with it. That is
// known only when the contacts have been solved; without it a top is right to the first power of
// the step. So they are solved once more, with the inertia of the end.
bool solveWithEnd(WorldState& state, const PhaseTask& task, Real scale) {
  Workspace& work = state.work;
  const Real duration = task.end - task.start;
  for (std::size_t i = 0; i < work.members.size(); ++i) {
    const BodySlot& body = state.bodies[at(work.members[i])];
    MovingBody& moving = work.moving[i];
    if (nutates(state, body)) {
      const Vector3 mean = (body.velocity.angular + moving.velocity.angular) / 2;
      const Quaternion end = integrateOrientation(body.orientation, mean, duration);
      moving.mass.inverseInertia = inverseInertiaOf(body, quaternionToMatrix(end));
    }
    moving.velocity = body.velocity;
  }
  prepareBlocks(state, duration, true);
  return solveBlocks(state, scale);
}

void storeForces(WorldState& state, Real start, Real duration) {
  Workspace& work = state.work;
  for (std::size_t i = 0; i < work.patches.size(); ++i) {
    WorkPatch& one = work.patches[i];
    PairSlot& pair = state.pairs[at(one.pair)];
    storeImpulses(work.blocks[i], one.patch);
    for (int k = 0; k < one.patch.count; ++k) {
      pair.force[at(one.pointOf[at(k)])] = one.patch.points[at(k)].impulse / duration;
    }
    const Real stop = start + stopTime(work.blocks[i], work.moving, duration);
    const bool sticks = !atLimit(work.blocks[i]);
    // A pair may have several patches, one after the other.
    const bool first = i == 0 || work.patches[i - 1].pair != one.pair;
    pair.rub = one.patch.rub / duration + (first ? Vector3(Vector3::Zero()) : pair.rub);
    pair.twist = one.patch.twist / duration + (first ? 0 : pair.twist);
    pair.sticks = sticks && (first || pair.sticks);
    pair.stop = first ? stop : std::min(stop, pair.stop);
  }
}

// Whether something slides whose friction does not act where its pressure is centred, and would
// turn it. Then the patches hold the solution, to begin again with.
bool takeCentres(WorldState& state) {
  constexpr Real kOff = 1e-6;
  Workspace& work = state.work;
  bool off = false;
  for (std::size_t i = 0; i < work.blocks.size(); ++i) {
    const ContactBlock& block = work.blocks[i];
    off = off || (block.slips && centreShift(block, work.patches[i].patch) > kOff);
  }
  for (std::size_t i = 0; off && i < work.blocks.size(); ++i) {
    storeImpulses(work.blocks[i], work.patches[i].patch);
  }
  return off;
}

// What is watched and not pushed turns by itself, and gets no energy by it, though its rate is only
// nearly that of a body which turns freely.
void keepEnergyOfTurn(BodySlot& body, Real duration, bool byMean) {
  const Vector3 &before = body.velocity.angular, &after = body.atEnd.angular;
  const Vector3 rate = byMean ? Vector3((before + after) / 2) : after;
  const Matrix3 end = quaternionToMatrix(integrateOrientation(body.orientation, rate, duration));
  const Real energy = turningEnergy(body, body.pose.R_WB, before);
  const Real now = turningEnergy(body, end, after);
  if (now > energy) body.atEnd.angular *= std::sqrt(energy / now);
}

// Flags the bodies that contacts push.
void flagPushed(Workspace& work) {
  std::fill(work.flags.begin(), work.flags.end(), 0);
  for (const ContactBlock& block : work.blocks) {
    bool pushes = block.rub != Vector3::Zero();
    for (int i = 0; i < block.count; ++i) pushes = pushes || block.impulses[at(i)] != 0;
    if (pushes) work.flags[at(block.bodyA)] = work.flags[at(block.bodyB)] = 1;
  }
}

}  // namespace

bool solvePhase(WorldState& state, const PhaseTask& task) {
  Workspace& work = state.work;
  const Real duration = task.end - task.start;
  gather(state, task.bodies, task.pairs);
  work.patches.clear();
  work.blocks.clear();
  for (const Index pair : task.pairs) addPatch(state, task, pair);
  for (const Index pair : task.pairs) {
    state.pairs[at(pair)].force = {};
    state.pairs[at(pair)].rub = Vector3::Zero();
    state.pairs[at(pair)].twist = 0;
  }

  // Bodies that nothing touches are on their own.
  work.flags.assign(work.members.size(), 0);
  for (const WorkPatch& one : work.patches) {
    work.flags[at(one.patch.bodyA)] = work.flags[at(one.patch.bodyB)] = 1;
  }
  // Inertia as it will be in the middle of the time.
  for (std::size_t i = 0; i < task.bodies.size(); ++i) {
    BodySlot& body = state.bodies[at(task.bodies[i])];
    body.isFree = work.flags[i] == 0;
    body.byEnd = false;
    body.acceleration = freeAcceleration(state, body);
    body.turning = Vector3::Zero();
    if (body.isFree) continue;
    dropAnchor(state, body);
    if (body.turnsEvenly || body.velocity.angular == Vector3::Zero()) continue;
    work.moving[i].mass.inverseInertia = inverseInertiaOf(body, middleOf(body, duration));
  }
  if (work.patches.empty()) return true;

  const Real scale = fastestOf(work, state.settings.gravity.norm() * duration);
  prepareBlocks(state, duration);
  for (const ContactBlock& block : work.blocks) {
    state.counters.normalRows += block.count;
    state.counters.frictionRows += block.rubs;
  }
  bool settled = solveBlocks(state, scale);
  // Friction acts at the centre of the pressure, which only the solution tells. Among many bodies
  // the next step is soon enough, and to begin anew what hardly settles may drive it apart.
  constexpr int kRounds = 3;
  const bool alone = task.bodies.size() == 1 && !task.speculative;
  for (int round = 0; round < kRounds && alone && settled && takeCentres(state); ++round) {
    goBack(state);
    prepareBlocks(state, duration);
    settled = solveBlocks(state, scale);
  }
  // In usual steps only for who turns about a point: elsewhere there are larger errors.
  const bool onTip = alone && work.patches.size() == 1 && work.patches.front().patch.count == 1 &&
                     state.pairs[at(work.patches.front().pair)].sticks;
  const auto asksForEnd = [&](Index index) {
    const BodySlot& body = state.bodies[at(index)];
    return state.longSteps ? nutates(state, body) : turnsByPart(state, body, duration);
  };
  if ((state.longSteps || onTip) &&
      std::any_of(task.bodies.begin(), task.bodies.end(), asksForEnd)) {
    settled = solveWithEnd(state, task, scale);
  }
  // A point that parts and is held at its end moves on by the mean of both, against the force that
  // holds it. Where such points are no events this makes energy, and the end alone counts.
  const bool byEnd = task.speculative && workOf(state) > 0;

  if (task.speculative) flagPushed(work);
  for (std::size_t i = 0; i < task.bodies.size(); ++i) {
    BodySlot& body = state.bodies[at(task.bodies[i])];
    if (body.isFree) continue;
    body.byEnd = byEnd;
    body.atEnd = work.moving[i].velocity;
    if (task.speculative && work.flags[i] == 0 && nutates(state, body)) {
      keepEnergyOfTurn(body, duration, state.settings.trapezoidal && !byEnd);
    }
    body.acceleration = (body.atEnd.linear - body.velocity.linear) / duration;
    body.turning = (body.atEnd.angular - body.velocity.angular) / duration;
  }
  storeForces(state, task.start, duration);
  return settled;
}

}  // namespace carom::world

#pragma once
// What does a world keep from one step to the next?
//
// Plain arrays. A body, a shape and a pair each have a place in one, and are named by its number
// everywhere inside; only at the door do numbers become ids. What is awake stands in lists of its
// own, so that a step never looks at what sleeps. A compound is as many shapes here as it has
// parts: each pair of shapes has one manifold.
// Not handled: who may change what (world.cpp and the stages it calls).

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "carom/broadphase/broad_phase.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/simultaneous_impacts.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/manifold_cache.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/solver/contact_patch.hpp"
#include "carom/solver/island_newton.hpp"
#include "carom/world/body.hpp"
#include "carom/world/counters.hpp"
#include "carom/world/events.hpp"
#include "carom/world/ground.hpp"
#include "carom/world/ids.hpp"
#include "carom/world/kept_manifold.hpp"
#include "carom/world/list_pool.hpp"
#include "carom/world/pile.hpp"
#include "carom/world/settings.hpp"

namespace carom::world {

/// Number of a body, shape, pair or island inside a world. \ingroup world
using Index = std::int32_t;

/// The time of what does not happen [s]. \ingroup world
inline constexpr Real kNever = std::numeric_limits<Real>::infinity();

/// A shape that never changes; worlds and snapshots share it. \ingroup world
struct ShapeData {
  Shape whole;                       ///< for distances, rays and times of impact
  ConvexShape convex;                ///< the same for manifolds; of a half-space nothing
  Vector3 middle = Vector3::Zero();  ///< of its volume; of balls and boxes zero [m, shape]
  Real reach = 0;  ///< of a ball its radius: a ball that turns about its middle goes nowhere [m]
  bool isBall = false;       ///< a ball
  bool isHalfSpace = false;  ///< a half-space
  bool usesAxes = false;     ///< manifolds with its like come from separating axes
  std::shared_ptr<const Ground> ground =
      {};  ///< if there is one, what `whole` says is of no account
};

/// Hulls by a number made of each. \ingroup world
using HullList = std::multimap<std::uint64_t, std::weak_ptr<const ShapeData>>;

/// A shape's place in a world. \ingroup world
struct ShapeSlot {
  std::uint32_t generation = 0;           ///< of its ids
  bool alive = false;                     ///< whether the place is taken
  Index body = kNone;                     ///< whose it is
  std::shared_ptr<const ShapeData> data;  ///< the shape
  Index item = 0;                         ///< of its ground, if it is a piece of one
  bool isAsked = false;                   ///< the tree for queries knows it
  bool isStale = false;                   ///< and has to be told where it is
  bool centred = false;                   ///< stands in the middle of its body, unturned
  Pose pose;                              ///< body's inner frame from shape
  Material material;                      ///< friction and bounce
  Filter filter;                          ///< what it meets
  Aabb<3> swept;                          ///< where it can be in this step [m, world]
};

/// How a body moved freely since the last time that something changed its rotation.
/// \ingroup world
struct RotorAnchor {
  FreeRotor rotor;  ///< from the state at the anchor
  Real since = 0;   ///< time since then [s]
  Real lost = 0;    ///< what rounding took from `since` [s]
};

/// A body's place in a world. Inside a body stands at its centre of mass, and along its principal
/// axes unless its inertia is that of a ball. \ingroup world
struct BodySlot {
  std::uint32_t generation = 0;       ///< of its ids
  bool alive = false;                 ///< whether the place is taken
  BodyKind kind = BodyKind::dynamic;  ///< what may move it
  bool maySleep = true;               ///< whether its island may
  bool asleep = false;                ///< whether it does
  bool turnsEvenly = true;            ///< three equal moments, or the switch says so
  bool isFree = false;                ///< nothing touches it in this part of the step
  Real struck = 0;        ///< how far it may be thrown in this step by what strikes it [m]
  Real way = 0;           ///< how far its speed takes it in this step [m]
  Real straight = 0;      ///< how far it and what acts on it takes each of its points [m]
  Real round = 0;         ///< and how far its turning at most [m]
  bool mayTurn = false;   ///< something may strike it in this step, and turn it aside
  bool byEnd = false;     ///< moves by its velocity at the end of the step
  bool kept = false;      ///< its island is still, and its boxes are those of the last step
  Index island = kNone;   ///< where it belongs; none: alone, or not dynamic
  Index awakeAt = kNone;  ///< its place in the list of those awake
  Index local = kNone;    ///< its number while an island is worked on
  Index cluster = kNone;  ///< smallest body that it touches in this part of the step
  Real clock = 0;         ///< time in this step at which the state below holds [s]
  Real reach = 0;         ///< no point is farther from the centre [m]
  Vector3 position = Vector3::Zero();      ///< centre of mass [m, world]
  Quaternion orientation;                  ///< inner frame to world
  Velocity velocity;                       ///< [world]
  Pose pose;                               ///< the same as position and orientation
  BodyMass mass;                           ///< inverse mass and inertia [world]
  Real weight = 0;                         ///< its mass; zero unless dynamic [kg]
  Vector3 moments = Vector3::Zero();       ///< principal moments [kg m^2]
  Vector3 force = Vector3::Zero();         ///< beside gravity [N, world]
  Vector3 torque = Vector3::Zero();        ///< [N m, world]
  Vector3 centre = Vector3::Zero();        ///< centre of mass [m, the user's frame]
  Quaternion turned;                       ///< inner frame to the user's frame
  std::vector<Index> shapes;               ///< its shapes
  std::optional<std::size_t> anchor;       ///< of its free rotation, in WorldState::anchors
  Vector3 lost = Vector3::Zero();          ///< of its position, by rounding in free flight [m]
  Vector3 acceleration = Vector3::Zero();  ///< from then on [m/s^2, world]
  Vector3 turning = Vector3::Zero();       ///< from then on [rad/s^2, world]
  Velocity atEnd;                          ///< velocity at the end of the step, if nothing happens
  Real restTime = 0;                       ///< how long it has been watched for rest [s]
  Pose restStart;                          ///< where it was then [world]
  Pose restMiddle;                         ///< and half way [world]
  bool restHalf = false;                   ///< the middle has been passed
  Real restSpeed = 0;                      ///< the fastest of its points since then [m/s]
};

/// A pair of shapes that are near each other. First comes what loops over all pairs ask, so that it
/// lies in one line of a cache. \ingroup world
struct PairSlot {
  bool alive = false;              ///< whether the place is taken
  Index shapeA = kNone;            ///< one shape; that of the immovable body, if there is one
  Index shapeB = kNone;            ///< the other
  Index bodyA = kNone;             ///< body of shapeA
  Index bodyB = kNone;             ///< body of shapeB
  Index awakeAt = kNone;           ///< its place in the list of those awake
  Index island = kNone;            ///< that it holds together, or that of its movable body
  Index islandAt = kNone;          ///< its place in the island's list
  Real madeAt = -1;                ///< when its manifold is of; negative: not in this step [s]
  std::uint64_t order = 0;         ///< the lists of islands rise with it
  bool touches = false;            ///< some point is closed, at the end of the last step
  bool sticks = false;             ///< friction held it in the last part of a step
  bool known = false;              ///< has been looked at in some step
  bool carried = false;            ///< its manifold is that of an earlier step, carried along
  bool narrow = false;             ///< its manifold reaches only as far as a pile asks for
  bool leftOut = false;            ///< nothing can touch in this step, and no manifold was made
  bool bySoftSteps = false;        ///< its forces are those of a pile, and no event came since
  Real friction = 0;               ///< of the two materials [1]
  Real restitution = 0;            ///< of the two materials [1]
  ManifoldCache cache;             ///< hints
  Manifold manifold;               ///< as of `madeAt`
  std::array<Real, 4> force = {};  ///< along the normal, of each point [N]
  Vector3 rub = Vector3::Zero();   ///< friction on B [N, world]
  Real twist = 0;                  ///< its torque about the normal [N m]
  Real next = kNever;              ///< when it may meet, in this step [s]
  Real stop = kNever;              ///< when it stops slipping, in this step [s]
  Real renew = kNever;             ///< when its forces are found anew [s]
};

/// Bodies that are joined by pairs. \ingroup world
struct IslandSlot {
  bool alive = false;      ///< whether the place is taken
  bool awake = true;       ///< whether it is stepped
  bool mustSplit = false;  ///< a pair has ended: it may be two by now
  int hardFor = 0;        ///< steps for which it is not tried by events: its contacts do not settle
  int knocks = 0;         ///< impacts, and phases that did not settle, in this step
  int pileFor = 0;        ///< steps for which it is a pile: anything else took too much
  bool isPile = false;    ///< its last step was one of soft steps
  int strayFor = 0;       ///< steps for which it is not solved directly: that found nothing
  bool unsorted = false;  ///< something was added
  bool still = false;     ///< its last step changed nothing, so neither will the next
  Real subStep = 0;       ///< what its error asks for while the world advances; 0: not known [s]
  bool energyKept = false;               ///< no energy can come into it in this step
  Vector3 frame = Vector3::Zero();       ///< velocity of whom its energy is seen by [m/s, world]
  Vector3 frameFalls = Vector3::Zero();  ///< and how that changes [m/s^2, world]
  Real motion = 0;                       ///< energy of motion at the start of the step, seen so [J]
  Real lent = 0;                         ///< what bodies may be lifted by though nobody pays [J]
  Real lifted = 0;        ///< what they could not pay themselves of their ways out of others [J]
  Real mayLift = 0;       ///< what it may still cost to move them out of others [J]
  Index awakeAt = kNone;  ///< its place in the list of those awake
  std::vector<Index> bodies;  ///< dynamic ones, ascending
  std::vector<Index> pairs;   ///< pairs that hold it together, and those with immovable bodies
};

/// A patch that is being solved, and whose it is. \ingroup world
struct WorkPatch {
  Index pair = kNone;               ///< whose
  ContactPatch patch;               ///< as the solver wants it
  std::array<int, 4> pointOf = {};  ///< numbers of its points in the manifold
};

/// Of a body what a step may change. \ingroup world
struct BodyBefore {
  Vector3 position = Vector3::Zero();  ///< centre of mass [m, world]
  Quaternion orientation;              ///< inner frame to world
  Velocity velocity;                   ///< [world]
  Vector3 turning = Vector3::Zero();   ///< by which phases are divided [rad/s^2, world]
};

/// Of a pair what one step hands on to the next. \ingroup world
struct PairBefore {
  std::array<Real, 4> force = {};  ///< along the normal, of each point [N]
  Vector3 rub = Vector3::Zero();   ///< friction on B [N, world]
  Real twist = 0;                  ///< its torque about the normal [N m]
  bool sticks = false;             ///< friction held it
};

/// What of a body a try changes that may be taken back. \ingroup world
struct SavedBody {
  Vector3 position = Vector3::Zero();  ///< [m, world]
  Vector3 lost = Vector3::Zero();      ///< of that by rounding [m]
  Quaternion orientation;              ///< inner frame to world
  Velocity velocity;                   ///< [world]
  Real clock = 0;                      ///< time in this step [s]
  std::optional<RotorAnchor> anchor;   ///< of its free rotation, itself
};

/// A pair and its place in the order of an island. \ingroup world
struct OrderedPair {
  std::uint64_t order = 0;  ///< of the pair
  Index pair = kNone;       ///< which
};

/// How a body goes on as long as nothing can have touched it. \ingroup world
struct QuietBody {
  Vector3 ahead = Vector3::Zero();  ///< where its velocity takes it in the step [m, world]
  Vector3 bent = Vector3::Zero();   ///< and what acts on it [m, world]
  Real round = 0;                   ///< how far its turning takes its points [m]
  Real way = 0;                     ///< how far all that takes a point at most [m]
  Real room = 0;                    ///< around it in its boxes, at least [m]
  Real until = 1;                   ///< share of the step before it can be touched [1]
  bool isDynamic = false;           ///< whether what touches it changes its way
};

/// A pair and how near its bodies can come in the step. \ingroup world
struct QuietPair {
  Index pair = kNone;   ///< which
  Index bodyA = kNone;  ///< its bodies
  Index bodyB = kNone;  ///< as in the pair
  Real gap = 0;         ///< that of their boxes, less what counts as none [m]
  Real part = 0;        ///< from when one is touched until it touches the other, at least [1]
  bool byWall = false;  ///< the first one cannot be moved
};

/// Memory that stages use again in each step. \ingroup world
struct Workspace {
  std::vector<MovingBody> moving;     ///< bodies as the solver sees them
  std::vector<Index> members;         ///< whose they are
  std::vector<WorkPatch> patches;     ///< what touches
  std::vector<ContactBlock> blocks;   ///< the same, prepared
  std::vector<Index> set;             ///< bodies that something has happened to
  std::vector<Index> setPairs;        ///< pairs of these
  std::vector<Index> toMake;          ///< pairs that want a manifold at the start of the step
  std::vector<QuietBody> quiet;       ///< by body, those that are in `toMake`
  bool knowsQuiet = false;            ///< of this step; else nothing is a pile, or nobody goes far
  std::vector<QuietPair> quietPairs;  ///< of these
  std::vector<Index> innerPairs;      ///< of these, pairs whose bodies are all in the set
  std::vector<OrderedPair> sorted;    ///< pairs of an island
  std::vector<OrderedPair> aside;     ///< of these, what is out of order
  std::vector<Index> labels;          ///< of bodies, while islands are looked for
  std::vector<IndexPair> links;       ///< pairs of local numbers
  std::vector<std::uint8_t> flags;    ///< one per local body
  std::vector<std::uint8_t> seen;     ///< what threads have seen of each of a list
  std::vector<std::uint8_t> asleep;   ///< the same, while an island wakes
  bool mayFactor = true;              ///< the island at hand may be solved directly
  std::int64_t rowsLeft = 0;  ///< rows that sweeps over this island may still visit in this step
  IslandNewton newton;        ///< for islands that are solved directly
  std::vector<BodyContact> contacts;     ///< of impacts
  std::vector<Index> contactPairs;       ///< whose
  std::vector<int> contactPoints;        ///< numbers of their points in the manifolds
  std::vector<Velocity> bounced;         ///< after bounces that ask for too much
  std::vector<Velocity> stopped;         ///< and without any
  std::vector<Real> approaches;          ///< speeds of these before the impact [m/s]
  ImpactMemory impactMemory;             ///< of impacts in several places at once
  SimultaneousImpacts impactRounds;      ///< what came of them
  std::vector<Pose> starts;              ///< of bodies at the start of their step [world]
  std::vector<BodyBefore> bodiesBefore;  ///< of an island that may be still
  std::vector<PairBefore> pairsBefore;   ///< of the same
  std::vector<SavedBody> tryBodies;      ///< bodies before a try
  std::vector<PairSlot> tryPairs;        ///< pairs before a try
  std::vector<SavedBody> macroBodies;    ///< bodies before a long step
  std::vector<PairSlot> macroPairs;      ///< pairs before a long step
  std::vector<SavedBody> ends;           ///< where tries have ended
  Shape thin = ConvexHull();             ///< a face of a ground, to search first contacts with
};

/// The shapes as queries find them: brought up to date by the first query after a change.
/// \ingroup world
struct AskedShapes {
  Tree<3> tree;              ///< boxes of the shapes, with room for rounding
  std::vector<Index> stale;  ///< shapes that were added, placed or removed since
  Real builtAt = -1;         ///< time of the world when it was brought up to date [s]
  QueryCounters counters;    ///< of the last query
};

/// Everything. \ingroup world
struct WorldState {
  WorldSettings settings;                    ///< switches and limits
  std::vector<BodySlot> bodies;              ///< all bodies, with free places between
  std::vector<ShapeSlot> shapes;             ///< all shapes
  std::vector<PairSlot> pairs;               ///< by slot of the broad phase
  std::vector<KeptManifold> kept;            ///< of each of these, what a pile carries along
  std::vector<IslandSlot> islands;           ///< all islands
  ListPool islandLists;                      ///< memory for their bodies and pairs
  std::vector<RotorAnchor> anchors;          ///< of bodies that turn freely
  HullList hulls;                            ///< that shapes share
  std::size_t hullsAtMost = 0;               ///< if there are more, those of no shape are forgotten
  std::vector<Index> freeBodies;             ///< places that can be used again
  std::vector<Index> freeShapes;             ///< places that can be used again
  std::vector<Index> freeIslands;            ///< places that can be used again
  std::vector<std::size_t> freeAnchors;      ///< places that can be used again
  std::vector<Index> awakeBodies;            ///< dynamic and kinematic bodies that are awake
  std::vector<Index> awakePairs;             ///< pairs of which a body is awake
  std::vector<Index> awakeIslands;           ///< islands that are awake
  BroadPhase broadPhase{{.stepsAhead = 0}};  ///< by shapes
  int bodyCount = 0;                         ///< bodies that are alive
  int kinematicCount = 0;                    ///< of these: kinematic ones
  int sleeping = 0;                          ///< bodies that sleep
  int islandCount = 0;                       ///< islands that are alive
  Real time = 0;                             ///< since the beginning [s]
  Real lostTime = 0;                         ///< what rounding took from it [s]
  Real lastStep = 0;                         ///< length of the last step, or of a part of it [s]
  Real partStart = 0;                ///< when the part began that is gone now, in its step [s]
  Real slowestImpact = 0;            ///< points that approach more slowly just touch [m/s]
  Real slowestBounce = 0;            ///< what parts more slowly does not part [m/s]
  bool longSteps = false;            ///< what is struck may go farther than a few neighbours
  Real macroStep = 0;                ///< of the last advance; 0: none yet [s]
  Counters counters;                 ///< of the last step
  std::vector<ContactEvent> begun;   ///< of the last step
  std::vector<ContactEvent> ended;   ///< of the last step
  std::vector<ImpactEvent> impacts;  ///< of the last step
  std::size_t endedBefore = 0;       ///< events in `ended` that a user has had a step to read
  AskedShapes asked;                 ///< for queries
  Workspace work;                    ///< nothing that lasts
  Pile pile;                         ///< threads, and memory of piles
};

/// The number of points, bodies and so on as an index of an array. \param i any number
/// \return the same \ingroup world
constexpr std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// Whether forces move a body. \param body any \return true for a dynamic one \ingroup world
inline bool isDynamic(const BodySlot& body) {
  return body.kind == BodyKind::dynamic;
}

/// Whether the last step of a body or a pair was one of a pile. \param state of the world
/// \param one of its bodies or pairs \return true if so \ingroup world
template <class Slot>
bool isOfPile(const WorldState& state, const Slot& one) {
  return one.island != kNone && state.islands[at(one.island)].isPile;
}

/// Whether a shape is a ball about the middle of its body: turning takes it nowhere.
/// \param shape any \return true for such a ball \ingroup world
inline bool isCentredBall(const ShapeSlot& shape) {
  return shape.centred && shape.data->isBall;
}

/// Whether a shape touches others in one point, or a half-space does. \param shape any
/// \return true for a ball and for a half-space \ingroup world
inline bool isRound(const ShapeSlot& shape) {
  return shape.data->isBall || shape.data->isHalfSpace;
}

/// Where a shape is if its body is somewhere. \param body world from body
/// \param shape one of its shapes \return world from shape \ingroup world
inline Pose placed(const Pose& body, const ShapeSlot& shape) {
  return shape.centred ? body : composed(body, shape.pose);
}

/// Where a shape of a body is. \param body whose \param shape one of its shapes
/// \return world from shape \ingroup world
inline Pose poseOfShape(const BodySlot& body, const ShapeSlot& shape) {
  return placed(body.pose, shape);
}

/// Lets queries find a shape where it is now. \param state of the world \param shape its number
/// \ingroup world
inline void makeStale(WorldState& state, Index shape) {
  if (state.shapes[at(shape)].isStale) return;
  state.shapes[at(shape)].isStale = true;
  state.asked.stale.push_back(shape);
}

/// Asks memory for a pair that a loop will come to: pairs lie far apart. \param state of the world
/// \param pairs numbers of those the loop goes through \param i where it is \ingroup world
inline void fetchAhead(const WorldState& state, std::span<const Index> pairs, std::size_t i) {
  constexpr std::size_t kAhead = 8;
  if (i + kAhead >= pairs.size()) return;
  const PairSlot& pair = state.pairs[at(pairs[i + kAhead])];
  __builtin_prefetch(&pair);
  __builtin_prefetch(&pair.manifold.count);
}

/// Runs the turns of a loop on the threads of a world. \param state of the world \param count turns
/// \param few so many are not worth a second thread; positive \param work called with the number of
/// each turn; different turns change different things \ingroup world
template <class Work>
void shareOut(WorldState& state, std::size_t count, std::size_t few, Work&& work) {
  threadsOf(state.pile, state.settings.threads)
      .loop(count, few, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) work(i);
      });
}

/// The id of a body. \param state of the world \param body its number \return its id
/// \ingroup world
inline BodyId idOfBody(const WorldState& state, Index body) {
  return {static_cast<std::uint32_t>(body), state.bodies[at(body)].generation};
}

/// The id of a shape. \param state of the world \param shape its number \return its id
/// \ingroup world
inline ShapeId idOfShape(const WorldState& state, Index shape) {
  return {static_cast<std::uint32_t>(shape), state.shapes[at(shape)].generation};
}

}  // namespace carom::world

#include "carom/world/add_body.hpp"

#include <cmath>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/detection/bounds.hpp"
#include "carom/detection/limits.hpp"
#include "carom/mass/principal_axes.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/world/islands.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/shared_hulls.hpp"
#include "carom/world/update_contacts.hpp"
#include "carom/world/weigh_shapes.hpp"

namespace carom::world {

namespace {

bool isHalfSpace(const ShapeDescription& shape) {
  return !shape.ground && std::holds_alternative<HalfSpace>(shape.shape);
}

void requireShape(const ShapeDescription& shape, BodyKind kind) {
  if (shape.ground) {
    if (kind != BodyKind::immovable) {
      throw InvalidInput("ground made of triangles must belong to an immovable body");
    }
  } else {
    carom::requireUsable(shape.shape);
  }
  carom::requireUsable(shape.pose, "pose of a shape");
  requireNonNegative(shape.material.friction, "friction");
  requireRestitution(shape.material.restitution);
  requirePositive(shape.density, "density");
  if (isHalfSpace(shape) && kind == BodyKind::dynamic) {
    throw InvalidInput("a half-space cannot be a shape of a dynamic body: it has no end");
  }
}

// Mass and inertia along the inner axes, and where the inner frame is in the user's.
struct InnerFrame {
  Real mass = 0;
  Vector3 centre = Vector3::Zero();
  Matrix3 axes = Matrix3::Identity();  // columns: inner axes in the user's frame
  Vector3 moments = Vector3::Zero();
  bool isRound = true;
};

InnerFrame innerFrameOf(const BodyDescription& description) {
  InnerFrame frame;
  if (description.kind != BodyKind::dynamic) return frame;
  const MassProperties mass =
      description.mass ? *description.mass : weighShapes(description.shapes);
  frame.mass = mass.mass;
  frame.centre = mass.center;
  const Vector3 diagonal = mass.inertia.diagonal();
  // Products of inertia below this share of the largest moment are rounding.
  constexpr Real kRounding = 1e-15;
  Real off = 0;
  for (int i = 0; i < 3; ++i) off = std::max(off, std::abs(mass.inertia(i, (i + 1) % 3)));
  frame.moments = diagonal;
  if (off > kRounding * diagonal.maxCoeff()) {
    const PrincipalAxes principal = principalAxes(mass.inertia);
    frame.moments = principal.moments;
    frame.axes = principal.axes;
  }
  // Moments that agree but for rounding are those of a ball: whichever way it turns, it goes on so.
  constexpr Real kEqual = 1e-14;
  frame.isRound =
      frame.moments.maxCoeff() - frame.moments.minCoeff() <= kEqual * frame.moments.maxCoeff();
  if (frame.isRound) frame.axes = Matrix3::Identity();
  return frame;
}

// The farthest that a shape reaches from the body's centre.
Real reachOf(const ShapeSlot& shape) {
  if (shape.data->isHalfSpace || shape.data->ground) return 0;
  if (shape.data->isBall) return shape.pose.p_WB.norm() + shape.data->reach;
  if (const auto* hull = std::get_if<ConvexHull>(&shape.data->whole)) {
    Real far = 0;
    for (const Vector3& vertex : hull->vertices) {
      far = std::max(far, pointToWorld(shape.pose, vertex).norm());
    }
    return far;
  }
  // Of the others a box around them is not much larger.
  const Aabb<3> box = boundsOf(shape.data->whole, Pose{});
  const Vector3 far = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs());
  return shape.pose.p_WB.norm() + far.norm();
}

template <class Kind>
std::shared_ptr<const ShapeData> dataOf(WorldState& state, const Kind& kind) {
  if constexpr (std::is_same_v<Kind, ConvexHull>) return sharedHull(state, kind);
  auto data = std::make_shared<ShapeData>();
  data->whole = kind;
  if constexpr (std::is_same_v<Kind, HalfSpace>) {
    data->isHalfSpace = true;
  } else {
    data->convex = kind;
  }
  if constexpr (std::is_same_v<Kind, Ball>) {
    data->isBall = true;
    data->reach = kind.radius;
  }
  data->usesAxes = std::is_same_v<Kind, Box>;
  return data;
}

Index placeFor(std::vector<Index>& free, std::size_t count) {
  if (free.empty()) return static_cast<Index>(count);
  const Index index = free.back();
  free.pop_back();
  return index;
}

void addShape(WorldState& state, Index body, std::shared_ptr<const ShapeData> data,
              const Pose& pose, const ShapeDescription& description, Index item = 0) {
  const Index index = placeFor(state.freeShapes, state.shapes.size());
  if (at(index) == state.shapes.size()) state.shapes.emplace_back();
  ShapeSlot& shape = state.shapes[at(index)];
  const ShapeSlot before = std::move(shape);
  shape = ShapeSlot();
  shape.generation = before.generation + 1;
  shape.isAsked = before.isAsked;
  shape.isStale = before.isStale;
  shape.alive = true;
  shape.body = body;
  shape.item = item;
  shape.data = std::move(data);
  shape.pose = pose;
  shape.centred = pose.p_WB == Vector3::Zero() && pose.R_WB == Matrix3::Identity();
  shape.material = description.material;
  shape.filter = description.filter;
  BodySlot& owner = state.bodies[at(body)];
  owner.shapes.push_back(index);
  owner.reach = std::max(owner.reach, reachOf(shape));
  shape.swept = boundsOfShape(shape, poseOfShape(owner, shape));
  makeStale(state, index);
  Aabb<3> box = shape.swept;
  std::uint32_t family = shape.filter.family;
  if (state.settings.pairFinding == PairFinding::allPairs) {
    const Vector3 everywhere = Vector3::Constant(std::numeric_limits<Real>::infinity());
    box = {-everywhere, everywhere};
    family = 0;
  }
  const bool moves = owner.kind != BodyKind::immovable;
  state.broadPhase.add(index, box, moves ? Mobility::moving : Mobility::immovable, family);
}

using Grounds = std::span<const std::shared_ptr<const Ground>>;

// Takes a ground from the front of the list if the shape is one.
void addShapes(WorldState& state, Index body, const ShapeDescription& description,
               const InnerFrame& frame, Grounds& grounds) {
  // Inner frame from shape.
  const Pose inner{frame.axes.transpose(), -(frame.axes.transpose() * frame.centre)};
  if (description.ground) {
    auto data = std::make_shared<ShapeData>();
    data->ground = grounds.front();
    grounds = grounds.subspan(1);
    const Pose pose = composed(inner, description.pose);
    for (Index item = 0; item < data->ground->items(); ++item) {
      addShape(state, body, data, pose, description, item);
    }
    return;
  }
  const auto addKind = [&](const auto& kind) {
    using Kind = std::decay_t<decltype(kind)>;
    if constexpr (std::is_same_v<Kind, Compound>) {
      for (const CompoundPart& part : kind.parts) {
        const Pose pose = composed(inner, composed(description.pose, part.pose));
        const auto makeData = [&](const auto& convex) { return dataOf(state, convex); };
        addShape(state, body, std::visit(makeData, part.shape), pose, description);
      }
    } else {
      addShape(state, body, dataOf(state, kind), composed(inner, description.pose), description);
    }
  };
  std::visit(addKind, description.shape);
}

}  // namespace

Quaternion requireUnit(const Quaternion& q, const char* name) {
  const Vector4 numbers(q.w, q.x, q.y, q.z);
  constexpr Real kUnit = 1e-6;
  if (!(std::abs(numbers.norm() - 1) <= kUnit)) {
    reject(name, toText(numbers), "must be a quaternion of norm one");
  }
  return renormalize(q);
}

void requireUsable(const WorldState& state, const BodyDescription& description) {
  if (state.bodyCount >= state.settings.maxBodies) {
    reject("number of bodies", std::to_string(state.bodyCount + 1),
           "must be at most the " + std::to_string(state.settings.maxBodies) + " of the settings");
  }
  requireCoordinates(description.position, "position");
  requireUnit(description.orientation, "orientation");
  requireFinite(description.velocity, "velocity");
  requireFinite(description.angularVelocity, "angularVelocity");
  for (const ShapeDescription& shape : description.shapes) {
    requireShape(shape, description.kind);
    if (isHalfSpace(shape) && description.angularVelocity != Vector3::Zero()) {
      reject("angularVelocity", toText(description.angularVelocity),
             "must be zero for a body with a half-space");
    }
  }
  if (description.kind == BodyKind::immovable &&
      (description.velocity != Vector3::Zero() || description.angularVelocity != Vector3::Zero())) {
    reject("velocity", toText(description.velocity), "must be zero for an immovable body");
  }
  if (description.kind != BodyKind::dynamic) return;
  if (description.mass) {
    requirePositive(description.mass->mass, "mass");
    requireFinite(description.mass->center, "centre of mass");
    requireInertia(description.mass->inertia);
  } else {
    const MassProperties mass = weighShapes(description.shapes);
    requirePositive(mass.mass, "mass of the shapes");
    requireInertia(mass.inertia);
  }
}

namespace {

// Memory to solve islands of so many bodies.
void makeRoom(Workspace& work, std::size_t bodies, std::size_t pairs, std::size_t points) {
  work.members.reserve(bodies);
  for (std::vector<Velocity>* ofBodies : {&work.bounced, &work.stopped}) ofBodies->reserve(bodies);
  work.moving.reserve(bodies);
  work.bodiesBefore.reserve(bodies);
  work.patches.reserve(pairs);
  work.blocks.reserve(pairs);
  work.sorted.reserve(pairs);
  work.aside.reserve(pairs);
  work.pairsBefore.reserve(pairs);
  work.contacts.reserve(points);
  work.contactPairs.reserve(points);
  work.contactPoints.reserve(points);
  work.approaches.reserve(points);
  constexpr int kGroup = 16;  // contacts that act at the same time
  reserve(work.impactMemory, work.impactRounds, static_cast<int>(bodies + pairs),
          static_cast<int>(points), kGroup);
  work.newton.reserve(static_cast<int>(bodies + pairs), static_cast<int>(pairs));
}

// Memory for the first few bodies as if they all met: small scenes need none later. In larger ones
// there is enough for islands of a few hundred; larger ones are mostly piles, and lists grow to
// what the largest yet has needed.
void makeRoom(WorldState& state) {
  constexpr std::size_t kMost = 32, kMostOfIsland = 512;
  const std::size_t now = state.bodies.size(), bodies = 2 * now;
  const bool isPower = (now & (now - 1)) == 0;
  if (!isPower || bodies > kMostOfIsland) return;
  const std::size_t pairs = 2 * bodies, points = 4 * pairs;
  makeRoom(state.work, bodies, pairs, points);
  makeRoomForLists(state, bodies, pairs);
  if (bodies > kMost) return;
  state.pairs.reserve(pairs);
  state.kept.reserve(pairs);
  state.islands.reserve(bodies);
  state.freeIslands.reserve(bodies);
  state.awakeIslands.reserve(bodies);
  state.islandLists.provide(2 * bodies);
  state.islandLists.reserve(bodies + pairs);
  state.impacts.reserve(points);
  state.broadPhase.reserve(static_cast<std::int32_t>(bodies), static_cast<std::int32_t>(pairs));
}

}  // namespace

BodyId addBody(WorldState& state, const BodyDescription& description) {
  requireUsable(state, description);
  const InnerFrame frame = innerFrameOf(description);
  // Broken meshes are refused here, before anything has changed.
  std::vector<std::shared_ptr<const Ground>> made;
  for (const ShapeDescription& shape : description.shapes) {
    if (shape.ground) made.push_back(std::make_shared<Ground>(makeGround(*shape.ground)));
  }

  const Index index = placeFor(state.freeBodies, state.bodies.size());
  if (at(index) == state.bodies.size()) {
    state.bodies.emplace_back();
    makeRoom(state);
  }
  BodySlot& body = state.bodies[at(index)];
  const std::uint32_t generation = body.generation + 1;
  body = BodySlot();
  body.generation = generation;
  body.alive = true;
  body.kind = description.kind;
  body.maySleep = description.maySleep;
  body.turnsEvenly = frame.isRound;
  body.isFree = true;
  body.centre = frame.centre;
  body.turned = frame.axes == Matrix3::Identity() ? Quaternion{} : matrixToQuaternion(frame.axes);
  const Quaternion q_WB = requireUnit(description.orientation, "orientation");
  body.orientation =
      frame.axes == Matrix3::Identity() ? q_WB : renormalize(hamiltonProduct(q_WB, body.turned));
  body.position = description.position + quaternionToMatrix(q_WB) * frame.centre;
  body.velocity = {description.velocity, description.angularVelocity};
  if (frame.mass > 0) {
    body.weight = frame.mass;
    body.moments = frame.moments;
    body.mass.inverseMass = 1 / frame.mass;
    body.mass.inverseInertia = frame.moments.cwiseInverse().asDiagonal();
  }
  refreshPose(body);
  body.restStart = body.pose;
  ++state.bodyCount;
  state.kinematicCount += body.kind == BodyKind::kinematic ? 1 : 0;
  Grounds grounds = made;
  for (const ShapeDescription& shape : description.shapes) {
    addShapes(state, index, shape, frame, grounds);
  }
  if (body.kind != BodyKind::immovable) listBody(state, index);
  return idOfBody(state, index);
}

void removeBody(WorldState& state, Index index) {
  BodySlot& body = state.bodies[at(index)];
  wakeBody(state, index);
  for (const Index shape : body.shapes) {
    state.broadPhase.pairs().forEachOf(shape, [&](std::int32_t pair, std::int32_t) {
      const PairSlot& slot = state.pairs[at(pair)];
      wakeBody(state, slot.bodyA == index ? slot.bodyB : slot.bodyA);
      endPair(state, pair);
    });
    state.broadPhase.remove(shape);
    state.shapes[at(shape)].alive = false;
    state.shapes[at(shape)].data.reset();
    makeStale(state, shape);
    state.freeShapes.push_back(shape);
  }
  leaveIsland(state, index);
  if (body.awakeAt != kNone) unlistBody(state, index);
  dropAnchor(state, body);
  body.alive = false;
  body.shapes.clear();
  state.freeBodies.push_back(index);
  --state.bodyCount;
  state.kinematicCount -= body.kind == BodyKind::kinematic ? 1 : 0;
}

}  // namespace carom::world

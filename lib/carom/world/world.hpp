#pragma once
// Many bodies, and one step that moves them all.
//
// The step reads as a table (world.cpp): find pairs, make manifolds, join and split islands, step
// each island that is awake, let islands sleep. Everything that a scene does not ask for is left
// out, and what was done is counted. Accuracy: free flight is exact; impacts happen at their time
// inside the step; a contact that does not change is integrated by the mean of its velocities;
// slipping that ends, ends at its time.
// Bad input is refused with InvalidInput, and the world is as it was.
// Not handled: joints; threads (one world belongs to one thread at a time).

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/aabb.hpp"
#include "carom/detection/cast_ray.hpp"
#include "carom/world/body.hpp"
#include "carom/world/counters.hpp"
#include "carom/world/events.hpp"
#include "carom/world/ids.hpp"
#include "carom/world/settings.hpp"

namespace carom::world {

struct WorldState;

/// Everything a world knows at one moment. Made by World::save(). \ingroup world
class Snapshot {
 private:
  friend class World;
  std::shared_ptr<const WorldState> state_;
};

/// Where a ray or a moving shape first meets a shape of the world. \ingroup world
struct QueryHit {
  BodyId body;                       ///< whose it is
  ShapeId shape;                     ///< what was met
  Real time = 0;                     ///< along the ray in units of its direction; of a sweep in s
  Vector3 point = Vector3::Zero();   ///< where [m, world]
  Vector3 normal = Vector3::Zero();  ///< out of the shape that was met, unit [1, world]
};

/// Two shapes that touch, as the last step left them. \ingroup world
struct TouchingPair {
  BodyId bodyA;                      ///< body of one shape
  BodyId bodyB;                      ///< body of the other
  Vector3 normal = Vector3::Zero();  ///< unit, from A to B [1, world]
  int points = 0;                    ///< points of the manifold
  Real separation = 0;               ///< the least of them; negative: overlap [m]
  Real normalForce = 0;              ///< of the last step, along the normal [N]
};

/// A world of rigid bodies. \ingroup world
class World {
 public:
  /// An empty world. \param settings gravity, switches and limits
  /// \throws InvalidInput if a setting is out of its range
  explicit World(const WorldSettings& settings = {});
  /// Releases everything.
  ~World();
  /// Moves a world; the old one may only be destroyed. \param other is emptied
  World(World&& other) noexcept;
  /// Moves a world; the old one may only be destroyed. \param other is emptied \return this world
  World& operator=(World&& other) noexcept;

  /// The settings. \return as they are now
  const WorldSettings& settings() const;
  /// Changes the settings; wakes all bodies. \param settings new ones
  /// \throws InvalidInput if a setting is out of its range
  void change(const WorldSettings& settings);

  /// Adds a body. \param description of it
  /// \return its id
  /// \throws InvalidInput naming what is wrong: numbers that are not finite, a quaternion not of
  /// norm one, a mass or inertia no body has, a shape of no size, a material out of its range, a
  /// half-space or ground on a body that moves, more bodies than the settings allow
  BodyId add(const BodyDescription& description);
  /// Removes a body; what rested on it wakes. \param body its id
  /// \throws InvalidInput for an id that names no body
  void remove(BodyId body);
  /// Whether an id names a body of this world. \param body any id
  /// \return false if it is null, or its body was removed
  bool contains(BodyId body) const;
  /// All bodies. \return their ids, ascending
  std::vector<BodyId> bodies() const;
  /// How many bodies there are. \return dynamic, kinematic and immovable ones together
  int bodyCount() const;
  /// The shapes of a body. \param body its id \return ids in the order of the description
  /// \throws InvalidInput for an id that names no body
  std::vector<ShapeId> shapesOf(BodyId body) const;

  /// Where a body is. \param body its id \return origin of its frame [m, world]
  /// \throws InvalidInput for an id that names no body
  Vector3 position(BodyId body) const;
  /// How a body lies. \param body its id \return body to world, of norm one
  /// \throws InvalidInput for an id that names no body
  Quaternion orientation(BodyId body) const;
  /// Where the centre of mass of a body is. \param body its id \return [m, world]
  /// \throws InvalidInput for an id that names no body
  Vector3 centre(BodyId body) const;
  /// How fast the centre of mass of a body moves. \param body its id \return [m/s, world]
  /// \throws InvalidInput for an id that names no body
  Vector3 velocity(BodyId body) const;
  /// How fast a body turns. \param body its id \return [rad/s, world]
  /// \throws InvalidInput for an id that names no body
  Vector3 angularVelocity(BodyId body) const;
  /// The mass of a body. \param body its id \return infinite unless it is dynamic [kg]
  /// \throws InvalidInput for an id that names no body
  Real mass(BodyId body) const;
  /// The inertia of a body. \param body its id
  /// \return about the centre of mass; zero unless it is dynamic [kg m^2, world]
  /// \throws InvalidInput for an id that names no body
  Matrix3 inertia(BodyId body) const;

  /// Puts a body elsewhere, and wakes it and what it touched. \param body its id
  /// \param position origin of its frame [m, world] \param orientation body to world, of norm one
  /// \throws InvalidInput for an id that names no body, or numbers that make no pose
  void place(BodyId body, const Vector3& position, const Quaternion& orientation);
  /// Gives a body another velocity, and wakes it. \param body its id, not immovable
  /// \param velocity of its centre of mass [m/s, world] \param angularVelocity [rad/s, world]
  /// \throws InvalidInput for an id that names no body that can move, or numbers not finite
  void setVelocity(BodyId body, const Vector3& velocity, const Vector3& angularVelocity);
  /// Pushes a body, and wakes it. \param body its id, dynamic \param impulse [N s, world]
  /// \param point where it acts [m, world]
  /// \throws InvalidInput for an id that names no dynamic body, or numbers not finite
  void push(BodyId body, const Vector3& impulse, const Vector3& point);
  /// Lets a force act on a body from now on, beside gravity, and wakes it. \param body its id,
  /// dynamic \param force at the centre of mass [N, world] \param torque [N m, world]
  /// \throws InvalidInput for an id that names no dynamic body, or numbers not finite
  void setForce(BodyId body, const Vector3& force, const Vector3& torque = Vector3::Zero());
  /// Wakes a body and its island. \param body its id
  /// \throws InvalidInput for an id that names no body
  void wake(BodyId body);
  /// Whether a body sleeps. \param body its id \return false also for what never moves
  /// \throws InvalidInput for an id that names no body
  bool asleep(BodyId body) const;

  /// Moves everything on. \param dt positive [s]
  /// \throws InvalidInput if dt is not positive and finite
  void step(Real dt);
  /// Moves everything on by steps chosen so that the error stays below a tolerance: each island
  /// takes its own. Counters and events are those of the whole time; impacts count from its start.
  /// \param duration positive [s]
  /// \param tolerance of positions, and of points at a metre from the centre by orientations, at
  /// the end; positive [m]
  /// \throws InvalidInput if one of them is not positive and finite
  void advance(Real duration, Real tolerance);
  /// Time since the world was made. \return [s]
  Real time() const;

  /// What the last step did. \return counters
  const Counters& counters() const;
  /// What the last query looked at. \return counters
  const QueryCounters& queryCounters() const;
  /// What happened in the last step. \return events, valid until the next step
  Events events() const;
  /// The pairs that touch. \return in the order of their ids
  std::vector<TouchingPair> touching() const;
  /// Energy of all dynamic bodies: of motion, and of height against gravity above the origin.
  /// \return [J]
  Real energy() const;
  /// Momentum of all dynamic bodies. \return [kg m/s, world]
  Vector3 momentum() const;
  /// Angular momentum of all dynamic bodies about the origin. \return [kg m^2/s, world]
  Vector3 angularMomentum() const;

  /// The first shape on a ray. \param ray with a direction that is not zero
  /// \param mask only shapes with a bit of it in their group
  /// \return nothing if no shape is met; of equally near ones that with the smallest id
  /// \throws InvalidInput as castRay()
  std::optional<QueryHit> rayCast(const Ray& ray, std::uint32_t mask = 0xFFFF'FFFFu) const;
  /// The bodies that overlap or touch a shape. \param shape usable \param pose where it is
  /// \param mask only shapes with a bit of it in their group \return ids, ascending
  /// \throws InvalidInput if shape or pose is not usable
  std::vector<BodyId> overlap(const Shape& shape, const Pose& pose,
                              std::uint32_t mask = 0xFFFF'FFFFu) const;
  /// The first shape that a moving shape meets, all bodies standing still. \param shape usable, no
  /// half-space \param pose where it starts \param velocity [m/s, world] \param duration [s]
  /// \param mask only shapes with a bit of it in their group
  /// \return nothing if no shape is met; of equally early ones that with the smallest id
  /// \throws InvalidInput if shape, pose, velocity or duration is not usable
  std::optional<QueryHit> sweep(const Shape& shape, const Pose& pose, const Vector3& velocity,
                                Real duration, std::uint32_t mask = 0xFFFF'FFFFu) const;

  /// Keeps everything. \return a snapshot, from which a run goes on bit by bit as from here
  Snapshot save() const;
  /// Goes back. \param snapshot of this world or another
  /// \throws InvalidInput if the snapshot is empty
  void restore(const Snapshot& snapshot);
  /// A number made of the state of all bodies: equal states, equal numbers. It does not depend on
  /// the order in which bodies were added. \return hash of poses and velocities
  std::uint64_t hash() const;

 private:
  std::unique_ptr<WorldState> state_;
};

}  // namespace carom::world

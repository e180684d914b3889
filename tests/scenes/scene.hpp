#pragma once
// What is simulated, how long, and how wrong did it come out?
//
// A scene is told in words that every engine understands: solids with their mass, where they start
// and how they move, what they are made of, and gravity. An engine is whatever can be given a
// scene, stepped, and asked where the bodies are. A judge looks at the bodies from time to time and
// ends with figures: errors against a closed form, penetration, energy. It computes them from
// poses, velocities and the geometry of the scene, and never asks the engine what it thinks.
// Why one description: tests, benchmarks and chapters then speak of the same scene, and so does
// every other engine that is measured beside Carom.
//
// Conventions. SI units, z up unless a scene says otherwise. A body's origin is its centre of mass
// and its axes are its principal axes. Coefficients of a pair are the products of the two bodies'
// own, so a scene gives the floor 1 and the body what the pair shall have.
// Not handled: joints, motors, bodies that come and go.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/rotation/quaternion.hpp"

namespace carom::scenes {

/// Where a body is and how it moves.
struct State {
  Vector3 position = Vector3::Zero();         ///< of its centre of mass [m, world]
  Quaternion orientation;                     ///< body to world, unit norm
  Vector3 velocity = Vector3::Zero();         ///< of its centre of mass [m/s, world]
  Vector3 angularVelocity = Vector3::Zero();  ///< [rad/s, world]
};

/// A solid of a scene.
struct Body {
  Shape shape;                        ///< about its centre of mass; a half-space does not move
  bool moves = true;                  ///< false: nothing moves it
  Real mass = 1;                      ///< [kg]
  Vector3 moments = Vector3::Ones();  ///< principal moments of inertia, along its axes [kg m^2]
  Real friction = 1;                  ///< of a pair: the product of both [1]
  Real restitution = 1;               ///< of a pair: the product of both [1]
  State start = {};                   ///< at time zero
  Vector3 force = Vector3::Zero();    ///< acts all the time at its centre of mass [N, world]
};

/// A figure that a judge found, with its unit in the name.
struct Figure {
  std::string name;  ///< for example "stopping distance [m]"
  Real value = 0;    ///< in the unit that the name says
};

/// Looks at the bodies of a running scene.
class Judge {
 public:
  virtual ~Judge() = default;
  /// Looks once. Called at the start and then as often as the scene asks.
  /// \param time since the start [s] \param bodies in the order of the scene
  virtual void see(Real time, std::span<const State> bodies) = 0;
  /// What it found, after the last look.
  virtual std::vector<Figure> figures() const = 0;
};

/// What is simulated.
struct Scene {
  std::string name;                        ///< one word: "B_slide"
  std::string title;                       ///< for people
  Vector3 gravity = Vector3(0, 0, -9.81);  ///< [m/s^2, world]
  std::vector<Body> bodies;                ///< the numbers of the bodies are their places here
  Real duration = 1;                       ///< [s]
  Real lookEvery = 0;  ///< time between two looks of the judge; 0: after each step [s]
  Real untimed = 0;    ///< processor time counts from here on [s]
  Real reach = 20;     ///< no body gets farther than this from `middle` [m]
  Vector3 middle = Vector3::Zero();  ///< of where everything happens [m, world]
  bool bounces = false;              ///< restitution is what the scene is about
  bool sleeps = false;               ///< bodies may be put to sleep
  bool fast = false;                 ///< bodies cross others within a step: continuous detection
  bool tall = false;                 ///< loads pass through many contacts: stacks, mass ratios
  bool strangers = false;            ///< bodies that move do not meet each other
  std::function<std::unique_ptr<Judge>(const Scene&)> judge;  ///< makes the judge of a run
};

/// Whatever can simulate a scene.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Makes the bodies of a scene. Called once.
  virtual void build(const Scene& scene) = 0;
  /// Goes on by a time. \param dt [s]
  virtual void step(Real dt) = 0;
  /// Where a body is now. \param body its place in the scene
  virtual State state(int body) const = 0;
  /// What the engine counted, if it counts: pairs tested, rows solved, ...
  virtual std::vector<Figure> counters() const {
    return {};
  }
};

/// An engine with settings, ready to be made.
struct EngineKind {
  std::string name;                        ///< "bullet it50"
  std::string version;                     ///< of the engine
  std::string settings;                    ///< what differs from the engine's defaults, and why
  std::function<bool(const Scene&)> can;   ///< whether it can simulate a scene at all
  std::function<bool(const Scene&)> best;  ///< whether these are its best settings for the scene
  std::function<std::unique_ptr<Engine>()> make;  ///< makes one
  int threads = 1;  ///< who work; with more than one the time of a run is that of a watch
};

/// The mean density of water, for bodies whose mass does not matter [kg/m^3].
inline constexpr Real kDensity = 1000;

/// A solid ball. \param radius [m] \param mass [kg] \return body at the origin, at rest
Body ballBody(Real radius, Real mass);

/// A solid box. \param halfExtents [m] \param mass [kg] \return body at the origin, at rest
Body boxBody(const Vector3& halfExtents, Real mass);

/// A half-space that does not move. \param normal out of it \param point on its plane [m]
Body planeBody(const Vector3& normal, const Vector3& point);

/// A convex polyhedron of constant density, in its own principal axes: the points are moved and
/// turned so that its centre of mass is the origin. \param points at least 4 [m]
/// \param density [kg/m^3] \return body at the origin, at rest
Body hullBody(std::span<const Vector3> points, Real density);

/// The same, where its points are: it starts with the pose that puts every corner at its point.
/// \param points at least 4 [m, world] \param density [kg/m^3] \return body there, at rest
Body placedHull(std::span<const Vector3> points, Real density);

/// The six walls of a closed room. \param low its lowest corner \param high its highest corner [m]
std::vector<Body> room(const Vector3& low, const Vector3& high);

/// Where the bodies of a scene start, in its order.
std::vector<State> startOf(const Scene& scene);

/// Rotation matrix of a state. \param state its orientation of unit norm \return body to world
Pose poseOfState(const State& state);

/// Kinetic energy of the bodies that move [J].
Real kineticEnergy(const Scene& scene, std::span<const State> bodies);

/// Momentum of the bodies that move [kg m/s], and the sum of their sizes.
struct Momentum {
  Vector3 total = Vector3::Zero();  ///< sum of the bodies' own
  Real size = 0;                    ///< sum of the sizes of the bodies' own
};
/// Momentum of the bodies that move. \return [kg m/s, world]
Momentum momentum(const Scene& scene, std::span<const State> bodies);
/// Angular momentum of the bodies that move about the origin. \return [kg m^2/s, world]
Momentum angularMomentum(const Scene& scene, std::span<const State> bodies);

/// The bits of all numbers of the bodies that move, mixed: runs that differ anywhere differ here.
std::uint64_t hashOf(const Scene& scene, std::span<const State> bodies);

}  // namespace carom::scenes

#pragma once
// How are thousands of contacts that push on one another solved in a millisecond?
//
// Method: the step is cut into a few short ones. What contacts are is found once; in each short
// step every contact is visited twice. Forces change the velocities, and contacts the impulses of
// the short step before; a first visit pulls overlaps apart, as a stiff damped spring would; bodies
// move; a second visit takes away what speed the first gave beyond that, and then does friction.
// Bounces come at the end. How far points are apart follows from how their bodies have moved, along
// the same rows as the speeds.
// Why short steps and not more sweeps: an error of a stack shrinks with the square of the step, and
// with a root of the sweeps. Why a second visit: speed that was only to pull bodies apart would
// throw them.
// Contacts of one colour share no body that moves, and lie in blocks of eight: lanes and threads
// work on them at the same time, and the result is the same to the last bit for any number of both.
// Impulses of the short step before are not applied row by row: what they did to a body is what
// its velocity had changed by.
// Why contacts give: visits that carry impulses on are a spring that nothing damps. The slow swings
// of a tall wall, for which a visit does little, would go on for ever and take up what it gains by
// sinking. A contact that gives up a part of its impulse in each short step damps them; it settles
// where the pull of its overlap makes up for that, all the less deep the shorter the step. An
// overlap that is left alone would be room for a wall to sway in.
// Why friction does not pull back what has slipped: that shakes tall piles.
// Source: Catto 2024 (Solver2D, "Soft Step"); Macklin and others 2019 (small steps); Tan, Liu and
// Sumner 2022; friction of a contact as one block: Catto 2025 (Box3D).
// Not handled: impacts inside of the step and slip to the last digit (the world's events do), and
// tall stacks of unlike masses.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "carom/core/kept_threads.hpp"
#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/solver/graph_colors.hpp"
#include "carom/solver/row_width.hpp"

namespace carom {

/// What numbers the rows of soft steps are made of. \ingroup solver
enum class RowNumbers {
  floats,  ///< eight at once; speeds to seven digits
  doubles  ///< four at once
};

/// How soft steps are made. \ingroup solver
struct SoftSettings {
  int shortSteps = 8;      ///< in a step; positive
  Real pull = 1;           ///< share of an overlap that a short step takes away; 0 to 1 [1]
  Real give = 0;           ///< share of its impulse that a contact gives up: softness; 0 to 1 [1]
  Real slowestPull = 0.3;  ///< up to this speed it does; positive [m/s]
  Real rise = 5;           ///< a deep one is taken away by so much faster for each unit of it [1/s]
  Real fastestPull = 3;    ///< but never faster than this; positive [m/s]
  Real slowestBounce = 0;  ///< what approaches slower does not bounce [m/s]
  RowWidth width = RowWidth::widest;  ///< numbers at once
};

/// A point of a contact. \ingroup solver
struct SoftPoint {
  Vector3 armA = Vector3::Zero();  ///< from A's centre of mass [m, world]
  Vector3 armB = Vector3::Zero();  ///< from B's centre of mass [m, world]
  Real separation = 0;             ///< at the start, negative inside [m]
  Real force = 0;                  ///< along the normal: where to start; then the solution [N]
};

/// A contact. \ingroup solver
struct PileContact {
  Vector3 normal = Vector3::UnitZ();     ///< unit, from A to B [1, world]
  int count = 0;                         ///< points used, 1 to 4
  std::array<SoftPoint, 4> points = {};  ///< where they touch
  Real friction = 0;                     ///< mu [1]
  Real restitution = 0;                  ///< e [1]
  Vector3 rub = Vector3::Zero();         ///< friction on B: start, then solution [N, world]
  Real twist = 0;                        ///< its torque about the normal [N m]
};

/// What a contact has come to. \ingroup solver
struct SoftForces {
  std::array<Real, 4> normal = {};  ///< of each point [N]
  Vector3 rub = Vector3::Zero();    ///< friction on B [N, world]
  Real twist = 0;                   ///< its torque about the normal [N m]
  bool sticks = false;              ///< friction is within its limit
};

/// Where a body has come to. \ingroup solver
struct SoftMotion {
  Velocity velocity;               ///< at the end [world]
  Vector3 way = Vector3::Zero();   ///< of its centre [m, world]
  Vector3 turn = Vector3::Zero();  ///< as a rotation vector [rad, world]
  bool touched = false;            ///< whether a contact has changed its motion
};

/// What was done. \ingroup solver
struct SoftCounts {
  int colors = 0;           ///< of the contacts
  std::int64_t blocks = 0;  ///< of eight contacts
  std::int64_t rows = 0;    ///< visited in all, those of empty places not counted
};

/// Soft steps, with memory that is kept from one step to the next. \ingroup solver
class SoftSteps {
 public:
  /// Without memory as yet.
  SoftSteps();
  /// Releases everything.
  ~SoftSteps();
  /// Moves memory; the old one may only be destroyed. \param other is emptied
  SoftSteps(SoftSteps&& other) noexcept;
  /// Moves memory; the old one may only be destroyed. \param other is emptied \return this
  SoftSteps& operator=(SoftSteps&& other) noexcept;

  /// Begins anew. \param bodies how many there are \param movable so many of them, the first, can
  /// be moved by contacts \param numbers what rows are made of
  void begin(std::size_t bodies, std::size_t movable, RowNumbers numbers);
  /// Describes a body; from several threads at once for different bodies. \param i its number
  /// \param body its mass, and velocity at the start \param gain what forces add to the velocity
  /// within the whole step \param shortSteps in how many equal parts they do
  void setBody(std::size_t i, const MovingBody& body, const Velocity& gain, int shortSteps);
  /// Which bodies touch. \param contacts their numbers \param counts points of each
  void place(std::span<const ColorEdge> contacts, std::span<const std::uint8_t> counts);
  /// The contact that stands at a place in the order of memory, in which threads should go.
  /// \param place from zero, less than places() \return number of the contact, or -1 for none
  std::int32_t contactAt(std::size_t place) const;
  /// Places, eight to a block. \return how many
  std::size_t places() const;
  /// Describes a contact; from several threads at once for different contacts.
  /// \param place where it stands \param contact as it is \param duration of a short step [s]
  void setContact(std::size_t place, const PileContact& contact, Real duration);

  /// Solves, and moves the bodies. \param settings how \param duration of the whole step [s]
  /// \param threads who work; the result is the same for any number of them \return what was done
  SoftCounts run(const SoftSettings& settings, Real duration, KeptThreads& threads);

  /// A body afterwards. \param i its number \return motion
  SoftMotion body(std::size_t i) const;
  /// A contact afterwards. \param place where it stands \param duration of a short step [s]
  /// \return forces
  SoftForces contact(std::size_t place, Real duration) const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace carom

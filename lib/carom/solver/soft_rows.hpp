#pragma once
// How do the rows of many contacts lie in memory so that lanes can work on them?
//
// Method: eight contacts are a block; of each number a block has eight side by side, one per
// contact. No two contacts of a block move the same body (graph_colors.hpp), so that a lane may
// change its bodies without looking at the others. A body's velocity is a row of eight numbers, and
// eight such rows, turned over, are the velocities of a block.
// Why eight, whatever the machine has: a block is worked off in one go of eight lanes, two of four
// or eight of one, and the result is the same to the last bit.
// What a kernel does is written once (soft_rows_kernel.hpp) and compiled for each width.
// Not handled: what the rows mean (soft_steps.hpp).

#include <cstdint>

namespace carom {

/// Contacts in a block. \ingroup solver
inline constexpr int kBlockWidth = 8;

/// Eight numbers of a body: three of moving, three of turning, two others. \ingroup solver
template <class T>
struct alignas(8 * sizeof(T)) BodyRow {
  T x[8] = {};  ///< of velocities: linear, angular, inverse mass, nothing
};

/// A number of each contact of a block. \ingroup solver
template <class T>
struct alignas(kBlockWidth * sizeof(T)) LaneRow {
  T x[kBlockWidth] = {};  ///< one per contact
};

/// The inverse inertia of a body: xx, yy, zz, xy, xz, yz [1/(kg m^2), world]. \ingroup solver
template <class T>
struct InertiaRow {
  T x[6] = {};  ///< as above
};

/// A direction in which a contact pushes two bodies, as seen by their turning. \ingroup solver
template <class T>
struct TurnRows {
  LaneRow<T> turnA[3];  ///< arm x direction of A, before prepare() the arm itself [m]
  LaneRow<T> turnB[3];  ///< of B [m]
  LaneRow<T> spinA[3];  ///< what a unit of impulse does to A's rate [1/(kg m)]
  LaneRow<T> spinB[3];  ///< to B's [1/(kg m)]
};

/// A point of each contact of a block. \ingroup solver
template <class T>
struct PointRows {
  TurnRows<T> turns;    ///< of the normal
  LaneRow<T> mass;      ///< effective [kg]; before prepare() one, or zero where there is no point
  LaneRow<T> gap;       ///< at the start of the step, negative inside [m]
  LaneRow<T> impulse;   ///< of one short step [N s]
  LaneRow<T> approach;  ///< speed of parting at the start [m/s]
  LaneRow<T> most;      ///< largest impulse of a short step [N s]
};

/// Eight contacts. \ingroup solver
template <class T>
struct SoftBlock {
  std::int32_t bodyA[kBlockWidth] = {};  ///< number of body A
  std::int32_t bodyB[kBlockWidth] = {};  ///< number of body B
  std::int32_t points = 0;               ///< of the contact that has most
  std::int32_t bounces = 0;              ///< whether one of them does
  LaneRow<T> normal[3];                  ///< unit, from A to B [1, world]
  LaneRow<T> masses;                     ///< sum of the inverse masses [1/kg]
  LaneRow<T> friction;                   ///< mu [1]
  LaneRow<T> restitution;                ///< e [1]
  LaneRow<T> tangent[2]
                    [3];  ///< directions of friction [1]; before prepare() it itself [N s, world]
  TurnRows<T> rubs[2];    ///< of the two directions, at the centre of pressure
  LaneRow<T> stick[3];    ///< inverse of their matrix: xx, xy, yy [kg]
  LaneRow<T> twistA[3];   ///< what a unit of torque does to A's rate [1/(kg m^2)]
  LaneRow<T> twistB[3];   ///< to B's [1/(kg m^2)]
  LaneRow<T> twistMass;   ///< against turning about the normal [kg m^2]
  LaneRow<T> radius;      ///< mean distance from the centre of pressure [m]
  LaneRow<T> rub[2];      ///< friction, of one short step [N s]
  LaneRow<T> twist;       ///< its torque about the normal [N m s]
  PointRows<T> point[4];  ///< where they touch
};

/// The bodies, as rows. \ingroup solver
template <class T>
struct SoftBodies {
  BodyRow<T>* velocity = nullptr;  ///< linear and angular, inverse mass
  BodyRow<T>* way = nullptr;       ///< moved and turned since the start; then 1 if it was touched
  BodyRow<T>* gain = nullptr;      ///< what forces add to the velocity in a short step
  BodyRow<T>* push = nullptr;      ///< what contacts have added in the last short step
  BodyRow<T>* before = nullptr;    ///< velocity before the contacts
  const InertiaRow<T>* inertia = nullptr;  ///< inverse inertia
  std::int32_t movable = 0;                ///< the first so many can be moved by contacts
};

/// The numbers of a short step. \ingroup solver
template <class T>
struct SoftNumbers {
  T duration = 1;       ///< of a short step [s]
  T perDuration = 1;    ///< one by it [1/s]
  T pull = 0;           ///< how fast a unit of overlap is taken away [1/s]
  T massScale = 1;      ///< of a soft contact, at most one [1]
  T impulseScale = 0;   ///< share of its impulse that it gives up [1]
  T slowestPull = 1;    ///< up to this speed overlap is taken away as `pull` says [m/s]
  T rise = 0;           ///< and what is deep by so much faster for each unit of it [1/s]
  T fastestPull = 1;    ///< but at most so fast [m/s]
  T slowestBounce = 0;  ///< what approaches slower does not bounce [m/s]
  T little = 0;         ///< impulse below which there is no direction [N s]
};

/// What works on blocks and bodies, all for numbers of kind T; compiled for one width of lanes.
/// Each function works on a range and touches nothing else of the same array. \ingroup solver
template <class T>
struct SoftKernel {
  int lanes = 1;  ///< numbers at once
  /// Rows from arms, of blocks. \ingroup solver
  void (*prepare)(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies) = nullptr;
  /// Applies the impulses that blocks start with. \ingroup solver
  void (*warm)(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies) = nullptr;
  /// One visit that pulls overlaps apart. \ingroup solver
  void (*press)(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies,
                const SoftNumbers<T>& numbers) = nullptr;
  /// One visit that does not, with friction. \ingroup solver
  void (*relax)(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies,
                const SoftNumbers<T>& numbers) = nullptr;
  /// Lets what has approached part again. \ingroup solver
  void (*bounce)(SoftBlock<T>* begin, SoftBlock<T>* end, const SoftBodies<T>& bodies,
                 const SoftNumbers<T>& numbers) = nullptr;
  /// Forces, and the impulses of the short step before, on bodies. \ingroup solver
  void (*kick)(const SoftBodies<T>& bodies, int begin, int end) = nullptr;
  /// Bodies move. \ingroup solver
  void (*drift)(const SoftBodies<T>& bodies, int begin, int end,
                const SoftNumbers<T>& numbers) = nullptr;
  /// Notes what the contacts have done to bodies. \ingroup solver
  void (*note)(const SoftBodies<T>& bodies, int begin, int end) = nullptr;
};

/// The plain one: a number at a time. \return kernel \ingroup solver
template <class T>
const SoftKernel<T>& plainKernel();

/// The one for registers of 16 bytes. \return kernel \ingroup solver
template <class T>
const SoftKernel<T>& narrowKernel();

/// The widest one that this machine can run. \return kernel \ingroup solver
template <class T>
const SoftKernel<T>& widestKernel();

}  // namespace carom

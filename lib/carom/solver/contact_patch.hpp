#pragma once
// What does a solver keep of two bodies that touch over an area?
//
// Method: up to four rows along the normal, one per point of the manifold, and one block of
// friction for all of them together: two directions and a turn about the normal, at the centre of
// pressure. Friction of the whole is at most mu times the sum of the normal impulses, a cone, with
// the turn counted as the slip of a point at the mean distance from the centre.
// The points of a patch lie on a plane, and so do their speeds: pressure that is a plane over them
// stops all at once where no point has to let go. That is solved first.
// Why one block of friction and not one per point: four cones on four points have a solution too,
// but many, and a block at its limit is then found only after thousands of sweeps. One block is
// solved at once, and a body that slides without turning feels the same force.
// A block knows whether it slips at the start. If it does, friction is at its limit against the
// mean slip, and a slip that would turn round ends at a time that can be computed (stopTime()). If
// it does not, friction is what it takes to stay so, within the cone.
// Source: the cone and the centre as in Box3D (Catto 2025) and Jolt; the ellipsoid of force and
// torque: Howe and Cutkosky 1996; duals as the mean of velocities: Anitescu and Potra 2002.
// Not handled: pressure that is not even where a body slides and spins at once (sliding_disc.hpp).

#include <array>
#include <limits>
#include <span>

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

/// \defgroup solver Solver: chapter 9
/// Many contacts at once, solved by sweeping over them.

namespace carom {

/// One point of a patch, as the caller describes it. \ingroup solver
struct PatchPoint {
  Vector3 armA = Vector3::Zero();  ///< from A's centre of mass [m, world]
  Vector3 armB = Vector3::Zero();  ///< from B's centre of mass [m, world]
  /// What the arms' turning has added to the relative velocity since the start [m/s, world].
  Vector3 before = Vector3::Zero();
  /// What it will add until the end [m/s, world].
  Vector3 drift = Vector3::Zero();
  Real target = 0;   ///< at least this fast the points have to part at the end [m/s]
  Real impulse = 0;  ///< along the normal: where to start; then the solution [N s]
};

/// A contact between two of many bodies. \ingroup solver
struct ContactPatch {
  int bodyA = 0;                      ///< number of body A
  int bodyB = 0;                      ///< number of body B
  Vector3 normal = Vector3::UnitZ();  ///< unit, from A to B [1, world]
  int count = 0;                      ///< points used, 1 to 4
  std::array<PatchPoint, 4> points;   ///< where they touch
  Real friction = 0;                  ///< mu, zero or positive [1]
  Real slowest = 0;                   ///< slip below this counts as none [m/s]
  Vector3 rub = Vector3::Zero();      ///< friction on B: start, then solution [N s, world]
  Real twist = 0;                     ///< its torque about the normal [N m s]
};

/// One direction in which a block pushes two bodies. \ingroup solver
struct PushRow {
  Vector3 direction = Vector3::Zero();  ///< of the impulse on B [1]
  Vector3 turnA = Vector3::Zero();      ///< arm x direction, of A [m]
  Vector3 turnB = Vector3::Zero();      ///< of B [m]
  Vector3 spinA = Vector3::Zero();      ///< what a unit of impulse does to A's rate [1/(kg m)]
  Vector3 spinB = Vector3::Zero();      ///< what it does to B's [1/(kg m)]
  Real drift = 0;                       ///< added to the velocity [m/s]
};

/// How fast the points of a row part at the end of the step.
/// \param row any row \param a body A \param b body B \return speed along the row [m/s]
/// \ingroup solver
inline Real speedAtEnd(const PushRow& row, const MovingBody& a, const MovingBody& b) {
  return row.direction.dot(b.velocity.linear - a.velocity.linear) +
         row.turnB.dot(b.velocity.angular) - row.turnA.dot(a.velocity.angular) + row.drift;
}

/// Pushes two bodies along a row. \param row any row \param impulse on B; A gets the opposite [N s]
/// \param a body A \param b body B
/// \ingroup solver
inline void pushAlong(const PushRow& row, Real impulse, MovingBody& a, MovingBody& b) {
  a.velocity.linear -= a.mass.inverseMass * impulse * row.direction;
  b.velocity.linear += b.mass.inverseMass * impulse * row.direction;
  a.velocity.angular -= impulse * row.spinA;
  b.velocity.angular += impulse * row.spinB;
}

/// A patch, ready to be swept over. \ingroup solver
struct ContactBlock {
  int bodyA = 0;                      ///< number of body A
  int bodyB = 0;                      ///< number of body B
  int count = 0;                      ///< points
  int rubs = 0;                       ///< rows of friction: 0, 2, or 3 with the turn
  bool slips = false;                 ///< slips at the start
  bool given = false;                 ///< friction does not depend on the end (FrictionLaw::given)
  int lawChanges = 0;                 ///< how often sweeps have changed that
  Real friction = 0;                  ///< mu [1]
  Real radius = 0;                    ///< mean distance of the points from the centre [m]
  std::array<PushRow, 4> normals;     ///< along the normal, one per point
  std::array<Real, 4> masses = {};    ///< effective, zero if nothing can move [kg]
  std::array<Real, 4> targets = {};   ///< least speed of parting [m/s]
  std::array<Real, 4> impulses = {};  ///< along the normal [N s]
  std::array<bool, 4> holds = {};     ///< pulls, too: the points end at the target speed
  /// Where the points are, for pressing all at once: one, and two coordinates about their mean in
  /// parts of the largest distance [1].
  std::array<Vector3, 4> places = {};
  /// Pressure as a plane over these places, that takes away an approach; zero for one point [kg].
  Matrix3 plane = Matrix3::Zero();
  Real evenMass = 0;                ///< the same for pressure that is even; zero for one point [kg]
  std::array<PushRow, 3> tangents;  ///< the rows of friction
  Vector3 rub = Vector3::Zero();    ///< impulses of the rows of friction [N s]
  Matrix3 matrix = Matrix3::Identity();  ///< how an impulse changes the slip [1/kg]
  Vector3 slipBefore = Vector3::Zero();  ///< slip along the rows at the start [m/s]
  Matrix3 inverse = Matrix3::Zero();     ///< impulse that takes a slip away [kg]
  Real lightest = 0;                     ///< impulse over slip that is safe in all directions [kg]
};

/// Prepares a patch. \param patch what touches \param bodies their masses, and velocities at the
/// start of the step \return rows and masses; the impulses it starts with are not applied yet
/// \ingroup solver
ContactBlock prepareBlock(const ContactPatch& patch, std::span<const MovingBody> bodies);

/// Writes the solution of a block back. \param block as solved \param patch that it was made of;
/// receives impulses, rub and twist \ingroup solver
void storeImpulses(const ContactBlock& block, ContactPatch& patch);

/// Gives the bodies the impulses that a block starts with. \param block prepared
/// \param bodies their velocities are changed \ingroup solver
void warmStart(const ContactBlock& block, std::span<MovingBody> bodies);

/// The slip of a block along its rows of friction. \param block prepared \param bodies as they move
/// \return slip at the end of the step [m/s] \ingroup solver
Vector3 slipOf(const ContactBlock& block, std::span<const MovingBody> bodies);

/// How far the pressure of a solution is centred from where its friction was made to act, which was
/// the centre of the pressure to start with. \param block as solved \param patch that it was made
/// of, not yet changed \return in parts of the mean distance of the points; zero for one point [1]
/// \ingroup solver
Real centreShift(const ContactBlock& block, const ContactPatch& patch);

/// When a block that slips stops slipping, if its slip changes evenly from that at the start to
/// that now. \param block as solved \param bodies as they move at the end \param duration of the
/// step [s]
/// \return time from the start; infinite if it does not stop within the step [s] \ingroup solver
Real stopTime(const ContactBlock& block, std::span<const MovingBody> bodies, Real duration);

/// Whether friction of a block is at its limit. \param block as solved
/// \return true if it cannot hold more \ingroup solver
bool atLimit(const ContactBlock& block);

}  // namespace carom

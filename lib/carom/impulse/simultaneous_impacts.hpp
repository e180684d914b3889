#pragma once
// What happens when bodies hit each other in several places at once?
//
// Method: in rounds. A round looks at the contacts whose points approach, and at no others. Where
// two of them press a body against each other the faster one goes first; the others go together. It
// asks for the least impulses that stop all of these at once: z >= 0, W z + u >= 0, z . (W z + u) =
// 0 (linear_complementarity.hpp). Then it applies 1 + e times these, which turns the approach
// round. That may make neighbours approach; they are the next round. It ends when nothing
// approaches.
// Why only the approaching ones: in Newton's cradle the second contact is not hit before the first
// has passed the blow on. Taken all at once, three balls (1, 0, 0) become (-1/3, 2/3, 2/3); in
// rounds the blow travels, and the cradle comes out right for any number of balls. Why all that
// approach together and not one after the other: the cue ball between two others must not care
// which of them has the smaller number. Why not together where they press against each other: balls
// that come into the cradle from both sides, at any speeds, then change places as they should.
// Why energy never grows: in a round whose contacts share one e, it changes by
// -(1 - e^2)/2 z . W z. Contacts of different e that are joined by a body take the smallest.
// Friction: a contact that is alone in its round follows passive_impact.hpp, and so do several
// points of one area, at the centre of their pressure: an edge that hits and sticks. In other
// groups each contact has its normal impulse first and then friction up to mu times it; what that
// disturbs is the next round's.
// Limits: with e < 1 balls can hit each other without end in a finite time. What approaches slower
// than rounding, or is left after maxRounds, gets one last plastic round with all contacts; then
// nothing approaches any more, and the status says so.
// Source: Smith, Kaufman, Vouga, Tamstorf and Grinspun, Reflections on simultaneous impact, ACM
// Transactions on Graphics 31(4), 2012, section 5 (generalised reflections); the order of contacts
// that press against each other is ours.
// Not handled: what a real cradle does that is a little out of line; stacks that rest (chapter 9).

#include <span>
#include <vector>

#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/impact_law.hpp"
#include "carom/impulse/linear_complementarity.hpp"

namespace carom {

/// A contact between two of many bodies. \ingroup impulse
struct BodyContact {
  int bodyA = 0;    ///< number of body A
  int bodyB = 0;    ///< number of body B, another one
  Contact contact;  ///< normal from A to B, and arms
  ImpactLaw law;    ///< restitution and friction of this pair
};

/// How rounds of impacts ended. \ingroup impulse
enum class ImpactsStatus {
  settled,    ///< no contact approaches any more
  roundLimit  ///< too many rounds: a plastic round over all contacts ended it
};

/// What rounds of impacts did. \ingroup impulse
struct SimultaneousImpacts {
  ImpactsStatus status = ImpactsStatus::settled;  ///< how it ended
  int rounds = 0;                                 ///< rounds that had impulses
  std::vector<Real> normalImpulses;               ///< sum of each contact, over all rounds [N s]
  Real approach = 0;  ///< fastest approach that is left, zero or positive [m/s]
};

/// Limits of the rounds. \ingroup impulse
struct ImpactRounds {
  /// A cradle of n balls needs about n rounds; balls of e < 1 take as many as their energy has
  /// digits. More cost time, fewer make what is left plastic.
  int maxRounds = 1000;
  /// Contacts that are alone follow bounded_impact.hpp: one that sticks stops its slip altogether.
  bool stopsSlip = false;
};

/// Memory of the rounds, used again by the next call: who calls often asks for it once.
/// \ingroup impulse
struct ImpactMemory {
  std::vector<int> live;            ///< contacts of which a body can move
  std::vector<int> active;          ///< of these, those whose points approach
  std::vector<int> roots;           ///< of each body: another one of its group, or itself
  std::vector<int> groupOfRoot;     ///< number of the group
  std::vector<int> members;         ///< contacts, group after group
  std::vector<int> starts;          ///< where each group begins, and the end of the last
  std::vector<int> order;           ///< of a group, from the fastest
  std::vector<int> taken;           ///< of a group, those that act together
  std::vector<Real> speeds;         ///< of parting
  std::vector<Real> bent;           ///< the same, as soft contacts have it
  std::vector<Real> impulses;       ///< that stop a group
  DenseMatrix couplings;            ///< how each impulse changes each speed
  DenseMatrix softened;             ///< the same of soft contacts, or while it is taken apart
  Complementarity solution;         ///< which of them push
  ComplementarityMemory searching;  ///< memory of that
};

/// Takes memory for impacts up to a size. \param memory gets it \param result for answers, too
/// \param bodies the most in one call \param contacts the most in one call
/// \param group the most contacts that act at the same time \ingroup impulse
void reserve(ImpactMemory& memory, SimultaneousImpacts& result, int bodies, int contacts,
             int group);

/// Lets all contacts of many bodies act at once.
/// \param bodies their velocities are changed
/// \param contacts between them; a pair of bodies may have several
/// \param limits of the rounds
/// \return rounds, impulses and status
/// \throws InvalidInput if a body, contact or law is not usable, a number names no body, or a
/// contact joins a body with itself; the bodies are then unchanged
/// \erratum{6.20}
/// \ingroup impulse
SimultaneousImpacts simultaneousImpacts(std::span<MovingBody> bodies,
                                        std::span<const BodyContact> contacts,
                                        const ImpactRounds& limits = {});

/// The same without asking for memory, once what is given has its largest size.
/// \param bodies their velocities are changed \param contacts between them \param limits of rounds
/// \param memory of any earlier call \param result takes rounds, impulses and status
/// \throws InvalidInput as the other one
/// \ingroup impulse
void simultaneousImpacts(std::span<MovingBody> bodies, std::span<const BodyContact> contacts,
                         const ImpactRounds& limits, ImpactMemory& memory,
                         SimultaneousImpacts& result);

}  // namespace carom

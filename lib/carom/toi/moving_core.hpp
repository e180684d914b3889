#pragma once
// The convex parts of a solid on its way, and how far turning can carry them.
//
// Round parts are cores with a radius: what turns is the core, and a ball that turns about its
// middle goes nowhere.

#include <type_traits>
#include <variant>
#include <vector>

#include "carom/detection/core_shape.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/toi/sweep.hpp"

namespace carom::detail {

/// A convex part on its way. \ingroup toi
struct MovingCore {
  CoreShape core;     ///< the part, without its roundness; its hull must outlive this
  Sweep sweep;        ///< motion of the part
  Real reach = 0;     ///< no point of the core is farther from the centre [m]
  Real fromAxis = 0;  ///< no point of the core is farther from the axis through the centre [m]
};

/// A core on its way. \param core the part \param sweep its motion \return with its reach
MovingCore movingCore(const CoreShape& core, const Sweep& sweep);

/// The convex parts of a solid, each with the motion of the whole. Nothing for a half-space.
/// \param shape any shape; must outlive the parts \param sweep its motion
/// \return one part, or those of a compound
std::vector<MovingCore> movingCores(const Shape& shape, const Sweep& sweep);

/// Calls visit(part) for each convex part of a solid, without asking for memory.
/// \param shape any shape; must outlive the parts \param sweep its motion
/// \param visit called with each MovingCore
template <class Visit>
void forEachCore(const Shape& shape, const Sweep& sweep, Visit&& visit) {
  const auto add = [&](const auto& convex, const Pose& inBody) {
    Sweep own = sweep;
    own.start = composed(sweep.start, inBody);
    own.centre = pointToBody(inBody, sweep.centre);
    visit(movingCore(coreOf(convex), own));
  };
  std::visit(
      [&](const auto& s) {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, Compound>) {
          for (const CompoundPart& part : s.parts) {
            std::visit([&](const auto& convex) { add(convex, part.pose); }, part.shape);
          }
        } else if constexpr (!std::is_same_v<S, HalfSpace>) {
          add(s, Pose{});
        }
      },
      shape);
}

/// Refuses a pair that no first contact can be searched for.
/// \param a shape of A \param A its motion \param b shape of B \param B its motion
/// \param duration until when to look [s]
/// \throws InvalidInput if a number is not finite, a pose not rigid, the duration negative, a
///   half-space turns, both are half-spaces, or a body goes further than 1e40 m or turns faster
///   than 1e40 rad/s
void requireSearchable(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B,
                       Real duration);

}  // namespace carom::detail

#pragma once
// Where does a ball touch?
//
// Method: a ball is nearest to a body where its centre is; so the nearest point of the body to the
// centre gives normal, separation and the one point: in closed form, for hulls by GJK.
// Two balls touch on the line of their centres.
// Not handled: a ball whose centre lies exactly on the middle of another body has no direction; one
// is chosen, the same one every time.

#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/shape_view.hpp"

namespace carom {

/// The manifold of two balls.
/// \param a first ball
/// \param A its pose
/// \param b second ball
/// \param B its pose
/// \param margin surfaces up to this far apart still make a point [m]
/// \return manifold of one point, or none
/// \ingroup manifold
Manifold collideBalls(const Ball& a, const Pose& A, const Ball& b, const Pose& B, Real margin = 0);

/// The manifold of a convex body and a ball.
/// \param a the body
/// \param A its pose
/// \param b the ball
/// \param B its pose
/// \param margin surfaces up to this far apart still make a point [m]
/// \return manifold of one point, or none
/// \ingroup manifold
Manifold collideWithBall(const ConvexShape& a, const Pose& A, const Ball& b, const Pose& B,
                         Real margin = 0);

namespace detail {

/// collideWithBall() of a body that is not copied.
/// \param a view of the body's shape \param A its pose \param b the ball \param B its pose
/// \param margin as there \return as there \ingroup manifold
Manifold collideWithBallOf(const ShapeView& a, const Pose& A, const Ball& b, const Pose& B,
                           Real margin);

}  // namespace detail
}  // namespace carom

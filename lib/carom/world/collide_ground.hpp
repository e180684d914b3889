#pragma once
// Where does a body touch a piece of ground?
//
// Method: what touches a face from its front lies wholly in front of its plane. So a face is held
// against the body as a floor would be, by the body's feature that looks at it, of which what is
// over the face counts. Corners that the cut makes at sides where the ground goes on flat are left
// out: the neighbour has the rest of the contact, and both together give the points that one floor
// would give, a box four of them, however many triangles there are below it.
// An edge is a line without thickness; a contact with it counts if its normal is one that the
// ground has there.
// Source: as in ground.hpp; clipping: Sutherland and Hodgman 1974.
// Not handled: a body that lies in the ground by more than rounding on both sides of a ridge.

#include "carom/detection/cast_ray.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/world/ground.hpp"

namespace carom::world {

/// The manifold of a piece of ground (A) and a convex body (B).
/// \param ground whose \param item face or edge \param G pose of the ground, world from mesh
/// \param b the body \param B its pose \param margin surfaces up to this far apart make points [m]
/// \return manifold, its normal out of the ground; no points if the ground is not touched here
/// \ingroup world
Manifold collideGround(const Ground& ground, std::int32_t item, const Pose& G, const ConvexShape& b,
                       const Pose& B, Real margin);

/// How far a body is in front of the plane of a face. \param ground whose \param face its number
/// \param G pose of the ground \param b the body \param B its pose
/// \return height of its lowest point, negative behind [m] \ingroup world
Real heightOverFace(const Ground& ground, std::int32_t face, const Pose& G, const ConvexShape& b,
                    const Pose& B);

/// Where an edge is. \param ground whose \param item its number \param G pose of the ground
/// \return origin in its middle, z along it [world from edge] \ingroup world
Pose edgePose(const Ground& ground, std::int32_t item, const Pose& G);

/// The first point of a face on a ray, from either side. \param ground whose \param face its number
/// \param G pose of the ground \param ray usable \return the hit, its normal against the ray
/// \ingroup world
RayHit castRayAtFace(const Ground& ground, std::int32_t face, const Pose& G, const Ray& ray);

}  // namespace carom::world

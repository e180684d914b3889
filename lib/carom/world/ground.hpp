#pragma once
// How does a mesh of triangles become ground to collide with?
//
// Method: it is taken apart into faces, one per triangle, and into the edges at which something can
// be touched that no face has: where the ground bends away (ridges), and where it ends (rims). Each
// is an item of the tree of what never moves, so a step finds those near a body and no others.
// Why bodies do not trip over inner edges: a face does not know its sides. It is touched along its
// own normal only, by what is over it (collide_ground.hpp); and an edge only with a normal that the
// ground has there, between those of its two faces.
// Source: inner edges: Catto, Ghost collisions, 2020; Gregorius, GDC 2015. The normals of an edge
// are its region in Voronoi's diagram (Ericson 2005, 9.5).
// Not handled: an inside. The ground is a sheet that carries what comes from its front; whatever
// has its middle behind a face is not seen by that face, and falls on.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/detection/aabb.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/pose.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom::world {

/// How the ground goes on over an edge of a triangle. \ingroup world
enum class EdgeKind : std::uint8_t {
  flat,    ///< as it was: nothing ends there
  valley,  ///< upwards
  ridge,   ///< downwards
  rim      ///< not at all
};

/// A triangle of a ground. \ingroup world
struct GroundFace {
  Vector3 normal = Vector3::UnitZ();           ///< out of its front, unit [1, mesh]
  std::array<std::int32_t, 3> corners = {};    ///< numbers of vertices, as in the mesh
  std::array<EdgeKind, 3> edges = {};          ///< from each corner to the next
  std::array<Real, 3> lean = {Real(0), 0, 0};  ///< what is below belongs to the neighbour beyond a
                                               ///< plane that leans inwards by this much [1]
};

/// An edge at which the ground bends away or ends. \ingroup world
struct GroundEdge {
  std::int32_t from = 0;  ///< vertex
  std::int32_t to = 0;    ///< vertex
  /// Normals that the ground has here have no part along these two: into the first face, unit
  /// [1, mesh].
  Vector3 inwards = Vector3::UnitX();
  Vector3 otherwise = Vector3::UnitX();  ///< into the other face; of a rim: down [1, mesh]
};

/// A ground, taken apart. Its items are the faces and, behind them, the edges. \ingroup world
struct Ground {
  std::vector<Vector3> vertices;        ///< [m, mesh]
  std::vector<GroundFace> faces;        ///< one for each triangle, in their order
  std::vector<GroundEdge> edges;        ///< ridges and rims
  std::vector<std::int32_t> ringStart;  ///< per vertex: where its neighbours begin; one more at end
  std::vector<std::int32_t> ring;       ///< neighbours of the vertices, one vertex after the other

  /// How many items there are. \return faces and edges
  std::int32_t items() const {
    return static_cast<std::int32_t>(faces.size() + edges.size());
  }
  /// Whether an item is a face. \param item its number \return false for an edge
  bool isFace(std::int32_t item) const {
    return static_cast<std::size_t>(item) < faces.size();
  }
  /// An edge. \param item its number among all items \return the edge
  const GroundEdge& edge(std::int32_t item) const {
    return edges[static_cast<std::size_t>(item) - faces.size()];
  }
};

/// Takes a ground apart. \param mesh triangles whose corners run counter-clockwise seen from the
/// front; it may be open
/// \return the ground
/// \throws InvalidInput saying what is wrong and where: a mesh that is empty, names no vertex, or
/// has a coordinate that is not finite; a triangle without area; an edge of more than two
/// triangles, or of two that look to opposite sides
/// \ingroup world
Ground makeGround(const TriangleMesh& mesh);

/// The tight box of an item. \param ground whose \param item its number \param pose world from mesh
/// \return box [m, world] \ingroup world
Aabb<3> boundsOfItem(const Ground& ground, std::int32_t item, const Pose& pose);

/// The three corners of a face or two of an edge. \param ground whose \param item its number
/// \param corners receives them [m, mesh] \return how many \ingroup world
int cornersOfItem(const Ground& ground, std::int32_t item, std::array<Vector3, 3>& corners);

/// A face as a flat solid with two faces, for distances and times of impact. \param ground whose
/// \param face its number \param hull receives it; memory that it has is used again \ingroup world
void flatHull(const Ground& ground, std::int32_t face, ConvexHull& hull);

}  // namespace carom::world

#pragma once
// Meshes to weigh, draw and throw: made by formula, closed, looking outwards.
//
// Method: grids of vertices, each square split along the same diagonal. Nothing is random.
// Why: tests and chapters need solids whose exact answer is known, at any fineness. Sines differ in
// the last bit between C libraries; snapToGrid() removes that, and makes the polyhedron's own
// moments rational numbers.
// Not handled: union and difference of solids (joined() only puts meshes side by side).

#include <span>

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// A box with its faces along the axes, of 8 vertices and 12 triangles.
/// \param low corner with the smallest coordinates [m]
/// \param high corner with the largest coordinates, above low in each [m]
/// \return closed mesh
/// \throws InvalidInput if high is not above low
/// \ingroup mass
TriangleMesh boxMesh(const Vector3& low, const Vector3& high);

/// A tetrahedron; corners in any order.
/// \param a first corner [m]
/// \param b second corner [m]
/// \param c third corner [m]
/// \param d fourth corner [m]
/// \return closed mesh of 4 triangles that looks outwards
/// \ingroup mass
TriangleMesh tetrahedronMesh(const Vector3& a, const Vector3& b, const Vector3& c,
                             const Vector3& d);

/// An ellipsoid as a globe: `rings` bands between the poles on the z axis, twice as many meridians.
/// \param semiAxes half lengths along x, y, z [m]
/// \param rings at least 2
/// \return closed mesh of 4 rings (rings - 1) triangles, vertices on the ellipsoid
/// \throws InvalidInput if a half length is not positive or rings < 2
/// \ingroup mass
TriangleMesh ellipsoidMesh(const Vector3& semiAxes, int rings);

/// A ball as an icosahedron whose triangles are split in four again and again: even triangles, no
/// poles.
/// \param radius [m]
/// \param splits how often, 0 to 9; 20 · 4^splits triangles
/// \return closed mesh, vertices on the sphere
/// \throws InvalidInput if radius is not positive or splits is out of range
/// \ingroup mass
TriangleMesh icosphereMesh(Real radius, int splits);

/// A torus about the origin, round the z axis.
/// \param ringRadius from the axis to the middle of the tube [m]
/// \param tubeRadius below ringRadius [m]
/// \param around steps around the axis, at least 3
/// \param across steps around the tube, at least 3
/// \return closed mesh of 2 · around · across triangles, vertices on the torus
/// \throws InvalidInput if 0 < tubeRadius < ringRadius does not hold or a number of steps is below
/// 3
/// \ingroup mass
TriangleMesh torusMesh(Real ringRadius, Real tubeRadius, int around, int across);

/// A solid of revolution about the z axis, as turned on a lathe: cylinder, cone, half ball, bottle.
/// \param profile points (distance from the axis, height) from the lower end on the axis to the
/// upper end on the axis [m]; the first and the last have distance zero, the others a positive one
/// \param around steps around the axis, at least 3
/// \return closed mesh, looking outwards if the heights rise along the outer side
/// \throws InvalidInput if the profile is not as said or around < 3
/// \ingroup mass
TriangleMesh latheMesh(std::span<const Vector2> profile, int around);

/// A prism along z over an outline that is seen whole from the origin (a star shape: gears,
/// polygons, Pacman).
/// \param outline corners counter-clockwise about the origin [m]
/// \param height full length along z; the prism reaches from -height/2 to height/2 [m]
/// \return closed mesh
/// \throws InvalidInput if there are fewer than 3 corners, one is not further counter-clockwise
/// than the one before, or height is not positive
/// \ingroup mass
TriangleMesh prismMesh(std::span<const Vector2> outline, Real height);

/// A prism as prismMesh(), with a hole along the axis that has as many corners.
/// \param outline outer corners counter-clockwise about the origin [m]
/// \param hole inner corners, as many, each at about the angle of its partner [m]
/// \param height full length along z [m]
/// \return closed mesh of genus 1
/// \throws InvalidInput as prismMesh(), and if the numbers of corners differ
/// \ingroup mass
TriangleMesh hollowPrismMesh(std::span<const Vector2> outline, std::span<const Vector2> hole,
                             Real height);

/// The mesh moved.
/// \param mesh any mesh
/// \param offset [m]
/// \return the moved mesh
/// \ingroup mass
TriangleMesh translated(TriangleMesh mesh, const Vector3& offset);

/// The mesh after a linear map of its vertices; a map that mirrors also reverses the triangles, so
/// that they still look outwards.
/// \param mesh any mesh
/// \param map 3x3 matrix, e.g. a rotation
/// \return the mapped mesh
/// \ingroup mass
TriangleMesh transformed(TriangleMesh mesh, const Matrix3& map);

/// The mesh turned inside out: every triangle reversed.
/// \param mesh any mesh
/// \return the reversed mesh
/// \ingroup mass
TriangleMesh reversed(TriangleMesh mesh);

/// Two meshes as one, side by side; join a reversed one to make a cavity.
/// \param first any mesh
/// \param second any mesh; its indices are moved up
/// \return all vertices and triangles of both
/// \ingroup mass
TriangleMesh joined(TriangleMesh first, const TriangleMesh& second);

/// The mesh with every coordinate rounded to a multiple of `grid`, a power of two such as 2^-20.
/// \param mesh any mesh
/// \param grid spacing [m]
/// \return the rounded mesh
/// \throws InvalidInput if grid is not positive
/// \ingroup mass
TriangleMesh snapToGrid(TriangleMesh mesh, Real grid);

}  // namespace carom

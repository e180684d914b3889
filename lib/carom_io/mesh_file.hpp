#pragma once
// How does a mesh come from a file?
//
// Four formats, each read by a file of its own (mesh_off.cpp, mesh_obj.cpp, mesh_stl.cpp,
// mesh_ply.cpp). Own readers, because common libraries keep coordinates as 32-bit floats, and a
// mesh far from the origin then loses the volume that is to be computed. The whole file is read
// first; counts in it are compared with the bytes that are left before room is made, so a hostile
// header cannot ask for more memory than the file is worth.
//
// Sources: OFF: Geomview's manual, "OFF files"; OBJ: Wavefront's Advanced Visualizer manual,
// appendix B1; STL: 3D Systems' StereoLithography interface specification (1989); PLY: G. Turk,
// "The PLY polygon file format" (1994).
//
// Not handled: curves and free-form surfaces of OBJ, binary OFF, normals, colours, materials and
// textures (skipped).

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "carom/core/errors.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom::io {

/// Thrown when a mesh file cannot be read; what() says "file:line: what" for text, "file, byte n:
/// what" for binary data.
/// \ingroup io
class MeshFileError : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// Reads a triangle mesh from an OFF, OBJ, STL (text or binary) or PLY (text, or binary of either
/// byte order) file. The format follows from the name's ending, in capitals or not.
///
/// Coordinates are taken as metres in the file's own frame, in the precision of the file: text and
/// PLY doubles as doubles, binary STL and PLY floats as the floats they are. A polygon becomes a
/// fan of triangles about its first corner, which is exact for plane convex polygons only. STL has
/// no indices: corners that are equal in all their bits become one vertex. What the surface
/// encloses is not judged here: see checkMesh().
/// \param path of the file
/// \return the mesh, in the order of the file
/// \throws MeshFileError when the file cannot be opened, is of an unknown format, cut short,
///        contradicts itself, names a vertex that does not exist, or holds a number that is not
///        finite
/// \ingroup io
TriangleMesh readMesh(const std::filesystem::path& path);

}  // namespace carom::io

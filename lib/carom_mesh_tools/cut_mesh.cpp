// carom_cut: cuts a solid into convex parts, so that `carom contact` can work with it.
//
// Method: the mesh becomes a Nef polyhedron, whose notches are cut by vertical walls until nothing
// reaches inwards (Hachenberger 2007, as CGAL has it). All of that is exact; only the corners of the
// parts are rounded at the end, and each part is the hull of its rounded corners, so it is convex.
// Why a program of its own: CGAL's polyhedra are under the GPL, and so is this program once it is
// built. It is neither built nor installed unless asked for (CAROM_MESH_TOOLS), and nothing in the
// library needs it.
// Not handled: the fewest parts, which is a hard problem; a curved surface gives a part or more for
// each of its facets that look inwards. The walls' corners are rounded, so neighbouring parts may
// overlap or part by an ulp.
//
// Exit codes: 0 done, 1 the input is no good, 4 wrong use.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_decomposition_3.h>

#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/mesh_problem.hpp"
#include "carom_io/mesh_file.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using carom::ConvexHull;
using carom::TriangleMesh;
using carom::Vector3;

Nef exactly(const TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const Vector3& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
  std::vector<std::vector<std::size_t>> faces;
  for (const auto& triangle : mesh.triangles) {
    std::vector<std::size_t> face;
    for (const auto corner : triangle) face.push_back(static_cast<std::size_t>(corner));
    faces.push_back(face);
  }
  Polyhedron polyhedron;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, polyhedron);
  return Nef(polyhedron);
}

std::vector<ConvexHull> partsOf(Nef solid) {
  CGAL::convex_decomposition_3(solid);
  std::vector<ConvexHull> parts;
  // The first volume is what lies outside of everything.
  auto volume = solid.volumes_begin();
  for (++volume; volume != solid.volumes_end(); ++volume) {
    if (!volume->mark()) continue;
    Polyhedron part;
    solid.convert_inner_shell_to_polyhedron(volume->shells_begin(), part);
    std::vector<Vector3> corners;
    for (auto p = part.points_begin(); p != part.points_end(); ++p) {
      corners.push_back(
          {CGAL::to_double(p->x()), CGAL::to_double(p->y()), CGAL::to_double(p->z())});
    }
    parts.push_back(carom::hullOfPoints(corners));
  }
  return parts;
}

// One OFF file with all parts; no two share a vertex.
void write(const std::vector<ConvexHull>& parts, const std::string& path) {
  std::size_t vertices = 0, faces = 0;
  for (const ConvexHull& part : parts) {
    vertices += part.vertices.size();
    for (const auto& face : part.faces) faces += static_cast<std::size_t>(face.count) - 2;
  }
  std::ofstream file(path);
  file.precision(17);
  file << "OFF\n" << vertices << ' ' << faces << " 0\n";
  for (const ConvexHull& part : parts) {
    for (const Vector3& v : part.vertices) {
      file << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    }
  }
  std::size_t first = 0;
  for (const ConvexHull& part : parts) {
    const auto cornerOf = [&](std::int32_t halfEdge) {
      const auto& side = part.halfEdges[static_cast<std::size_t>(halfEdge)];
      return first + static_cast<std::size_t>(side.origin);
    };
    for (const auto& face : part.faces) {
      for (std::int32_t k = 1; k + 1 < face.count; ++k) {
        file << "3 " << cornerOf(face.firstHalfEdge) << ' ' << cornerOf(face.firstHalfEdge + k)
             << ' ' << cornerOf(face.firstHalfEdge + k + 1) << '\n';
      }
    }
    first += part.vertices.size();
  }
  file.close();
  if (!file) throw carom::InvalidInput(path + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: carom_cut SOLID PARTS.off\n"
                 "Cuts a closed mesh (.off, .obj, .stl, .ply) into convex parts.\n";
    return 4;
  }
  try {
    const TriangleMesh mesh = carom::io::readMesh(argv[1]);
    const auto problems = carom::checkMesh(mesh);
    if (!problems.empty()) {
      std::cerr << argv[1] << ": " << problems.front().message << '\n';
      return 1;
    }
    const std::vector<ConvexHull> parts = partsOf(exactly(mesh));
    write(parts, argv[2]);
    std::cout << argv[1] << ": " << parts.size()
              << (parts.size() == 1 ? " convex part\n" : " convex parts\n");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}

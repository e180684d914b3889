// Mass properties before a judge: exact rational arithmetic, by formulas that the library does not
// use, and CGAL's own predicates on meshes.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/self_intersections.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom_io/mesh_file.hpp"
#include "oracle/exact_mass.hpp"
#include "support/catch.hpp"

using carom::Matrix3;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector3;
using carom_test::Errors;
using carom_test::errorsOf;
using carom_test::sizeOf;
using carom_test::weighExactly;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

struct Named {
  std::string name;
  TriangleMesh mesh;
};

Matrix3 thirdTurn() {
  Matrix3 R;
  R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  return R / 3;
}

TriangleMesh dentedBall() {
  carom::Random random(41);
  TriangleMesh mesh = carom::icosphereMesh(1, 3);
  for (Vector3& vertex : mesh.vertices) vertex *= random.between(0.6, 1.4);
  return mesh;
}

// Meshes made by formula, and the files of tests/meshes.
std::vector<Named> goodMeshes() {
  std::vector<Named> meshes{
      {"box", carom::boxMesh({0, 0, 0}, {1, 2, 3})},
      {"turned box", carom::transformed(carom::boxMesh({0, 0, 0}, {1, 2, 3}), thirdTurn())},
      {"tetrahedron",
       carom::tetrahedronMesh({0.1, 0.2, 0.3}, {5, 0.7, 0.11}, {0.13, 4, 0.17}, {0.19, 0.23, 3})},
      {"torus", carom::torusMesh(2, 0.5, 40, 20)},
      {"ellipsoid", carom::ellipsoidMesh({3, 2, 1}, 24)},
      {"dented ball", dentedBall()},
      {"hollow ball",
       carom::joined(carom::icosphereMesh(1, 2), carom::reversed(carom::icosphereMesh(0.9, 2)))}};
  for (const char* file : {"gear.off", "die.obj", "bracket.stl", "torus.ply", "knot.ply"}) {
    const TriangleMesh mesh = carom::io::readMesh(std::filesystem::path(CAROM_MESH_DIR) / file);
    meshes.push_back({file, carom::transformed(mesh, thirdTurn())});
  }
  return meshes;
}

Mesh surfaceMeshOf(const TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const Vector3& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& [a, b, c] : mesh.triangles) {
    polygons.push_back(
        {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
  }
  Mesh result;
  REQUIRE(pmp::is_polygon_soup_a_polygon_mesh(polygons));
  pmp::polygon_soup_to_polygon_mesh(points, polygons, result);
  return result;
}

// CGAL's pairs of triangles that cut or touch each other, as numbers of the mesh, in order.
std::vector<carom::TrianglePair> pairsByCgal(const TriangleMesh& mesh) {
  const Mesh surface = surfaceMeshOf(mesh);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
  pmp::self_intersections(surface, std::back_inserter(found));
  std::vector<carom::TrianglePair> pairs;
  for (const auto& [f, g] : found) {
    const auto a = static_cast<std::int32_t>(f.idx()), b = static_cast<std::int32_t>(g.idx());
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(pairs.begin(), pairs.end(), [](const auto& p, const auto& q) {
    return std::pair(p.first, p.second) < std::pair(q.first, q.second);
  });
  return pairs;
}

bool hasFlatTriangle(const TriangleMesh& mesh) {
  const auto problems = carom::checkMesh(mesh);
  return !problems.empty() && problems.front().kind == carom::MeshProblemKind::degenerateTriangle;
}

}  // namespace

TEST_CASE("exact arithmetic confirms volume, centre and inertia of every mesh") {
  for (const Named& named : goodMeshes()) {
    INFO(named.name);
    const auto body = carom::massProperties(named.mesh, 1);
    const Errors fast = errorsOf(body.volume, body.center, body.inertia, named.mesh);
    CHECK(fast.volume < 1e-14);
    CHECK(fast.center < 1e-14);
    CHECK(fast.inertia < 1e-14);
    const Errors plain = errorsOf(carom::signedVolume(named.mesh), carom::centerOfMass(named.mesh),
                                  carom::inertiaTensor(named.mesh, 1), named.mesh);
    CHECK(plain.volume < 1e-13);
    CHECK(plain.center < 1e-13);
    CHECK(plain.inertia < 1e-13);
  }
}

TEST_CASE("exact arithmetic confirms meshes a million metres from the origin") {
  for (const Named& named : goodMeshes()) {
    INFO(named.name);
    // The vertices are rounded by the move; the rounded mesh is what is judged.
    const TriangleMesh far = carom::translated(named.mesh, {1e6, -1e6, 0.7e6});
    const auto body = carom::massProperties(far, 1);
    const Errors errors = errorsOf(body.volume, body.center, body.inertia, far);
    CHECK(errors.volume < 1e-13);
    CHECK(errors.inertia < 1e-12);
    CHECK(errors.center * sizeOf(far) < 6e-11);  // half an ulp of 1e6: no double is nearer
  }
}

TEST_CASE("exact arithmetic confirms slivers, down to plates of rounding thickness") {
  for (int power = 1; power <= 45; power += 4) {
    const Real t = std::ldexp(1.0, -power);
    const TriangleMesh plate = carom::translated(
        carom::transformed(carom::boxMesh({0, 0, 0}, {1, 1, t}), thirdTurn()), {1.4, -0.4, 1.2});
    INFO("thickness 2^-" << power);
    REQUIRE(weighExactly(plate).volume > 0);
    const auto body = carom::massProperties(plate, 1);
    const Errors errors = errorsOf(body.volume, body.center, body.inertia, plate);
    CHECK(errors.volume < 1e-13);
    CHECK(errors.center < 1e-13);
    CHECK(errors.inertia < 1e-12);
    if (power >= 13) {  // the exact path: nothing but the last rounding
      CHECK(errors.volume < 4e-16);
      CHECK(errors.center < 4e-16);
      CHECK(errors.inertia < 4e-16);
    }
  }
}

TEST_CASE("CGAL's exact volume is the rational one, and the sign follows its orientation") {
  for (const Named& named : goodMeshes()) {
    INFO(named.name);
    const Kernel::FT volume = pmp::volume(surfaceMeshOf(named.mesh));
    CHECK(CGAL::exact(volume) == weighExactly(named.mesh).volume);
    const Mesh inverted = surfaceMeshOf(carom::reversed(named.mesh));
    CHECK(pmp::volume(inverted) < 0);
    CHECK(carom::signedVolume(carom::reversed(named.mesh)) < 0);
  }
}

TEST_CASE("CGAL agrees on what is closed and what looks outwards") {
  for (const Named& named : goodMeshes()) {
    INFO(named.name);
    const Mesh good = surfaceMeshOf(named.mesh);
    CHECK(CGAL::is_closed(good));
    CHECK(pmp::does_bound_a_volume(good));
    CHECK(carom::checkMesh(named.mesh).empty());

    TriangleMesh opened = named.mesh;
    opened.triangles.pop_back();
    CHECK_FALSE(CGAL::is_closed(surfaceMeshOf(opened)));
    REQUIRE_FALSE(carom::checkMesh(opened).empty());
    CHECK(carom::checkMesh(opened).front().kind == carom::MeshProblemKind::openEdge);

    if (named.name == "hollow ball") continue;  // CGAL asks for one piece here
    CHECK(pmp::is_outward_oriented(good));
    const TriangleMesh inverted = carom::reversed(named.mesh);
    CHECK_FALSE(pmp::is_outward_oriented(surfaceMeshOf(inverted)));
    REQUIRE_FALSE(carom::checkMesh(inverted).empty());
    CHECK(carom::checkMesh(inverted).front().kind == carom::MeshProblemKind::flipped);
  }
}

TEST_CASE("CGAL refuses what the check calls non-manifold or partly flipped") {
  TriangleMesh flipped = carom::boxMesh({0, 0, 0}, {1, 1, 1});
  std::swap(flipped.triangles[7][1], flipped.triangles[7][2]);
  TriangleMesh fin = carom::boxMesh({0, 0, 0}, {1, 1, 1});
  fin.vertices.emplace_back(0.5, -1, -1);
  fin.triangles.push_back({0, 1, 8});
  for (const TriangleMesh& mesh : {flipped, fin}) {
    std::vector<std::vector<std::size_t>> polygons;
    for (const auto& [a, b, c] : mesh.triangles) {
      polygons.push_back(
          {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
    }
    CHECK_FALSE(pmp::is_polygon_soup_a_polygon_mesh(polygons));
    CHECK_FALSE(carom::checkMesh(mesh).empty());
  }
}

TEST_CASE("CGAL and the library find no meshes of the makers that cut themselves") {
  for (const Named& named : goodMeshes()) {
    INFO(named.name);
    CHECK_FALSE(pmp::does_self_intersect(surfaceMeshOf(named.mesh)));
    CHECK(carom::selfIntersections(named.mesh).empty());
  }
  const TriangleMesh crossing = carom::joined(carom::boxMesh({0, 0, 0}, {1, 1, 1}),
                                              carom::boxMesh({0.5, 0.5, 0.5}, {2, 2, 2}));
  CHECK(pmp::does_self_intersect(surfaceMeshOf(crossing)));
  CHECK(carom::selfIntersections(crossing) == pairsByCgal(crossing));
}

TEST_CASE("CGAL and the library name the same pairs of triangles that cut or touch each other") {
  // Surfaces whose vertices are pushed about. On a coarse grid corners fall on faces, edges on
  // edges, and neighbours are folded flat; turned by thirds nothing is exactly flat any more.
  carom::Random random(77);
  int compared = 0;
  std::size_t pairs = 0;
  for (int round = 0; round < 1000; ++round) {
    TriangleMesh mesh = round % 4 == 0 ? carom::icosphereMesh(1, 2) : carom::icosphereMesh(1, 1);
    if (round % 5 == 0) mesh = carom::torusMesh(1, 0.4, 8, 6);
    for (Vector3& v : mesh.vertices) v += random.vector(0.3);
    if (round % 3 != 0) mesh = carom::snapToGrid(mesh, round % 3 == 1 ? 0.25 : 0.5);
    if (round % 7 == 0) mesh = carom::transformed(mesh, thirdTurn());
    if (hasFlatTriangle(mesh)) continue;
    INFO("round " << round << " (seed 77)");
    const auto expected = pairsByCgal(mesh);
    CHECK(carom::selfIntersections(mesh, 1000000) == expected);
    pairs += expected.size();
    ++compared;
  }
  CHECK(compared > 400);
  CHECK(pairs > 10000);
}

// Mass properties before a judge: exact rational arithmetic, by formulas that the library does not
// use, and CGAL's own predicates on meshes.
//
// The integrals are Eberly's (Polyhedral Mass Properties, 2002): surface integrals of polynomials
// in one coordinate after the other, not sums over tetrahedra. In rational numbers they have no
// error at all.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/random.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom_io/mesh_file.hpp"
#include "support/catch.hpp"

using carom::Matrix3;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector3;

namespace {

using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

struct ExactBody {
  Rational volume = 0;
  std::array<Rational, 3> center;
  std::array<std::array<Rational, 3>, 3> inertia;  // density 1, about the centre
};

using Point = std::array<Rational, 3>;

ExactBody weighExactly(const TriangleMesh& mesh) {
  // ∫ 1, ∫ x_i, ∫ x_i², ∫ x_i x_(i+1) over the solid.
  Rational volume = 0;
  std::array<Rational, 3> first = {0, 0, 0};
  std::array<Rational, 3> square = {0, 0, 0};
  std::array<Rational, 3> product = {0, 0, 0};
  for (const auto& triangle : mesh.triangles) {
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& v = mesh.vertices[static_cast<std::size_t>(triangle[k])];
      p[k] = {Rational(v.x()), Rational(v.y()), Rational(v.z())};
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      // Component i of the normal, twice the area long.
      const Rational n =
          (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
      const Rational &w0 = p[0][i], &w1 = p[1][i], &w2 = p[2][i];
      const Rational f1 = w0 + w1 + w2;
      const Rational f2 = w0 * w0 + w1 * (w0 + w1) + w2 * f1;
      const Rational f3 = w0 * w0 * w0 + w1 * (w0 * w0 + w1 * (w0 + w1)) + w2 * f2;
      if (i == 0) volume += n * f1 / 6;
      first[i] += n * f2 / 24;
      square[i] += n * f3 / 60;
      Rational g = 0;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Rational& w = p[corner][i];
        g += p[corner][j] * (f2 + w * (f1 + w));
      }
      product[i] += n * g / 120;
    }
  }
  ExactBody body;
  body.volume = volume;
  for (std::size_t i = 0; i < 3; ++i) body.center[i] = first[i] / volume;
  for (std::size_t i = 0; i < 3; ++i) {
    square[i] -= volume * body.center[i] * body.center[i];
    product[i] -= volume * body.center[i] * body.center[(i + 1) % 3];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    body.inertia[i][i] = square[j] + square[(i + 2) % 3];
    body.inertia[i][j] = body.inertia[j][i] = -product[i];
  }
  return body;
}

// |got - exact| as a double; the difference is taken exactly.
Real distance(Real got, const Rational& exact) {
  return std::abs(CGAL::to_double(Rational(got) - exact));
}

Real sizeOf(const TriangleMesh& mesh) {
  Vector3 low = mesh.vertices.front();
  Vector3 high = low;
  for (const Vector3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

struct Errors {
  Real volume = 0;   // relative
  Real center = 0;   // relative to the size of the body
  Real inertia = 0;  // relative to the largest entry
};

Errors errorsOf(Real volume, const Vector3& center, const Matrix3& inertia,
                const TriangleMesh& mesh) {
  const ExactBody exact = weighExactly(mesh);
  Errors errors;
  errors.volume = distance(volume, exact.volume) / CGAL::to_double(exact.volume);
  Real largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    errors.center = std::max(errors.center, distance(center[row], exact.center[i]));
    for (std::size_t j = 0; j < 3; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      errors.inertia =
          std::max(errors.inertia, distance(inertia(row, column), exact.inertia[i][j]));
      largest = std::max(largest, std::abs(CGAL::to_double(exact.inertia[i][j])));
    }
  }
  errors.center /= sizeOf(mesh);
  errors.inertia /= largest;
  return errors;
}

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

TEST_CASE("the meshes of the makers do not cut themselves, and CGAL sees one that does") {
  for (const Named& named : goodMeshes()) {
    INFO(named.name);
    CHECK_FALSE(pmp::does_self_intersect(surfaceMeshOf(named.mesh)));
  }
  const TriangleMesh crossing = carom::joined(carom::boxMesh({0, 0, 0}, {1, 1, 1}),
                                              carom::boxMesh({0.5, 0.5, 0.5}, {2, 2, 2}));
  CHECK(pmp::does_self_intersect(surfaceMeshOf(crossing)));
}

// What does a solid weigh, where does it balance, how hard is it to turn?
//
//     mass_of_mesh [FOLDER] [FILE]     weighs a mesh file (OFF, OBJ, STL, PLY); without one, a mug
//
// Then the same solid is weighed far from the origin, in the way that most programs do it and in
// the library's.

#include <filesystem>
#include <iostream>
#include <numbers>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/principal_axes.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom_io/mesh_file.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::MassProperties;
using carom::Matrix3;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector2;
using carom::Vector3;

constexpr Real kDensity = 2400;  // [kg/m^3]: stoneware

// A mug, 9 cm high, with a ring as its handle. The ring stands 2 mm off the wall: parts that
// overlap would count twice.
TriangleMesh mug() {
  const std::vector<Vector2> profile = {{0, 0},        {0.04, 0},      {0.04, 0.09},
                                        {0.036, 0.09}, {0.036, 0.006}, {0, 0.006}};
  const TriangleMesh handle = carom::transformed(carom::torusMesh(0.025, 0.005, 32, 12),
                                                 Matrix3{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}});
  return carom::joined(carom::latheMesh(profile, 48),
                       carom::translated(handle, Vector3(0.072, 0, 0.045)));
}

//! [naive]
// The whole inertia in one pass about the world's origin, moved to the centre at the end.
Matrix3 naiveInertia(const TriangleMesh& mesh) {
  Real volume = 0;
  Vector3 first = Vector3::Zero();   // integral of r dV
  Matrix3 second = Matrix3::Zero();  // integral of r r^T dV
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = carom::cornersOf(mesh, triangle);
    const Real v = a.dot(carom::cross(b, c)) / 6;
    const Vector3 s = a + b + c;
    volume += v;
    first += v / 4 * s;
    second +=
        v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  second -= first * first.transpose() / volume;  // from the origin to the centre
  return kDensity * (second.trace() * Matrix3::Identity() - second);
}
//! [naive]

Real largestExtent(const TriangleMesh& mesh) {
  Vector3 low = mesh.vertices.front(), high = low;
  for (const Vector3& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return (high - low).maxCoeff();
}

void printBody(const MassProperties& body) {
  const auto principal = carom::principalAxes(body.inertia);
  carom::io::Table table;
  table.column("quantity").column("x or value", carom::io::fixed(3));
  table.column("y", carom::io::fixed(3)).column("z", carom::io::fixed(3));
  const Vector3 center = 1000 * body.center;
  const Vector3 moments = 1e6 * principal.moments;
  table.row({"volume [cm^3]", 1e6 * body.volume, "", ""});
  table.row({"mass [g]", 1000 * body.mass, "", ""});
  table.row({"centre of mass [mm]", center.x(), center.y(), center.z()});
  table.row({"principal moments [kg mm^2]", moments.x(), moments.y(), moments.z()});
  std::cout << table;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  try {
    const TriangleMesh mesh = argc > 2 ? carom::io::readMesh(argv[2]) : mug();
    //! [judge]
    const auto problems = carom::checkMesh(mesh);
    if (!problems.empty()) {
      std::cerr << problems.front().message << '\n';
      return 1;
    }
    const MassProperties body = carom::massProperties(mesh, kDensity);
    //! [judge]
    std::cout << mesh.triangles.size() << " triangles, density " << kDensity << " kg/m^3\n\n";
    printBody(body);

    std::cout << "\nThe same solid moved along x, error of the inertia relative to its size\n\n";
    carom::io::Table table;
    table.column("distance [m]", carom::io::scientific(0))
        .column("one pass", carom::io::scientific(0));
    table.column("the library", carom::io::scientific(0));
    for (Real distance : {0.0, 1.0, 10.0, 100.0, 1000.0}) {
      // Moving rounds the corners. Moved back, the rounded solid stands at the origin, to be
      // compared with.
      const TriangleMesh moved = carom::translated(mesh, Vector3(distance, 0, 0));
      const TriangleMesh back = carom::translated(moved, Vector3(-distance, 0, 0));
      const Matrix3 exact = carom::massProperties(back, kDensity).inertia;
      const Real size = exact.norm();
      table.row({distance, (naiveInertia(moved) - exact).norm() / size,
                 (carom::massProperties(moved, kDensity).inertia - exact).norm() / size});
    }
    std::cout << table;

    // Drawn with the body's origin in its centre of mass and its axes along the principal ones.
    const auto principal = carom::principalAxes(body.inertia);
    const Real larger = 0.5 / largestExtent(mesh);
    const TriangleMesh drawn = carom::transformed(carom::translated(mesh, -body.center),
                                                  larger * principal.axes.transpose());
    const carom::Quaternion upright = carom::matrixToQuaternion(principal.axes);
    carom::io::Recording recording("A mesh and its principal axes",
                                   "The solid turns slowly; the lines are its principal axes, "
                                   "through the centre of mass. It is drawn half a metre large.");
    recording.addBody("solid", carom::io::Mesh{drawn}, {.opacity = 0.6});
    const char* const names[] = {"least moment", "middle moment", "largest moment"};
    for (int k = 0; k < 3; ++k) {
      const Vector3 along = 0.45 * Vector3::Unit(k);
      recording.addBody(names[k], carom::io::Polyline{{-along, along}});
    }
    for (int i = 0; i <= 240; ++i) {
      const auto [s, c] = carom::sineCosine(std::numbers::pi * i / 240);
      const carom::Quaternion turned = carom::hamiltonProduct({c, 0, 0, s}, upright);
      const carom::io::Pose pose{Vector3::Zero(), turned};
      recording.addFrame({i / 60.0, {pose, pose, pose, pose}, {}, {}});
    }
    recording.writeHtml(folder / "mass_of_mesh.html");
  } catch (const carom::InvalidInput& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}

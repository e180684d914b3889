// How do solids of one mass differ in how hard they are to turn?
//
// Eight solids of 1 kg that fit into a box of 1 m: their moments in closed form, and how close a
// mesh comes. Then all get the same angular momentum, and the picture shows how fast each turns.
// Last, two slips of the source: the moment about an axis, and the skater's energy.

#include <Eigen/LU>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/mass/inertia_about.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/standard_solids.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::MassProperties;
using carom::Matrix3;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector2;
using carom::Vector3;

struct Animal {
  std::string name;
  MassProperties exact;
  TriangleMesh mesh;
};

std::vector<Animal> zoo() {
  const std::vector<Vector2> cylinder = {{0, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {0, 0.5}};
  const std::vector<Vector2> cone = {{0, 0}, {0.5, 0}, {0, 1}};
  const Vector3 a(0.5, 0, 0), b(-0.25, 0.433, 0), c(-0.25, -0.433, 0), d(0, 0, 0.8);
  return {
      {"ball", carom::solidBall(0.5, 1), carom::icosphereMesh(0.5, 4)},
      {"hollow ball", carom::hollowBall(0.4, 0.5, 1),
       carom::joined(carom::icosphereMesh(0.5, 4), carom::reversed(carom::icosphereMesh(0.4, 4)))},
      {"box", carom::solidBox({1, 0.6, 0.4}, 1),
       carom::boxMesh({-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2})},
      {"cylinder", carom::solidCylinder(0.5, 1, 1), carom::latheMesh(cylinder, 96)},
      {"cone", carom::solidCone(0.5, 1, 1), carom::latheMesh(cone, 96)},
      {"ellipsoid", carom::solidEllipsoid({0.5, 0.3, 0.2}, 1),
       carom::ellipsoidMesh({0.5, 0.3, 0.2}, 48)},
      {"tetrahedron", carom::solidTetrahedron(a, b, c, d, 1), carom::tetrahedronMesh(a, b, c, d)},
      {"torus", carom::solidTorus(0.35, 0.15, 1), carom::torusMesh(0.35, 0.15, 96, 48)},
  };
}

void printZoo(const std::vector<Animal>& animals) {
  carom::io::Table table;
  table.column("1 kg of");
  for (const char* title : {"Ixx [kg m^2]", "Iyy [kg m^2]", "Izz [kg m^2]"}) {
    table.column(title, carom::io::fixed(5));
  }
  table.column("triangles").column("mesh differs by", carom::io::scientific(0));
  for (const Animal& animal : animals) {
    const Matrix3 exact = animal.exact.inertia / animal.exact.mass;
    const MassProperties mesh = carom::massProperties(animal.mesh, 1);
    const Real difference =
        (mesh.inertia - animal.exact.inertia).norm() / animal.exact.inertia.norm();
    if (difference < 1e-14) {
      table.row({animal.name, exact(0, 0), exact(1, 1), exact(2, 2), animal.mesh.triangles.size(),
                 "rounding"});
    } else {
      table.row({animal.name, exact(0, 0), exact(1, 1), exact(2, 2), animal.mesh.triangles.size(),
                 difference});
    }
  }
  std::cout << table;
}

void printSlips() {
  //! [axis]
  const Matrix3 I = Vector3(1, 2, 3).asDiagonal();
  const Vector3 n = Vector3(1, 1, 0).normalized();
  const Real right = carom::momentAboutAxis(I, n);
  const Real source = (I.inverse() * n).norm();
  //! [axis]
  std::cout << "\nMoment about (1,1,0) of diag(1,2,3) kg m^2: n.In = "
            << carom::io::Cell(right).text(carom::io::fixed(4)) << ", the source's recipe "
            << carom::io::Cell(source).text(carom::io::fixed(4)) << '\n';

  carom::io::Table table;
  table.column("arms")
      .column("I [kg m^2]", carom::io::fixed(1))
      .column("L [N m s]", carom::io::fixed(1));
  table.column("omega [rad/s]", carom::io::fixed(1)).column("energy [J]", carom::io::fixed(1));
  const Real L = 12;
  for (const auto& [arms, moment] : {std::pair{"wide", 4.0}, std::pair{"close", 2.0}}) {
    table.row({arms, moment, L, L / moment, L * L / (2 * moment)});
  }
  std::cout << "\nA skater pulls in her arms\n\n" << table;
}

void record(const std::vector<Animal>& animals, const std::filesystem::path& file) {
  carom::io::Recording recording(
      "One angular momentum, eight solids",
      "Eight solids of the same mass turn about their upright axes with the same angular momentum. "
      "Those with their mass close to the axis turn fastest.");
  recording.setView({.direction = Vector3(0, 1, -0.7)});
  std::vector<Real> rates;  // [rad/s]
  const Real L = 0.1;       // [N m s]
  for (const Animal& animal : animals) {
    recording.addBody(animal.name,
                      carom::io::Mesh{carom::translated(animal.mesh, -animal.exact.center)},
                      {.axes = true});
    rates.push_back(L * animal.exact.mass / animal.exact.inertia(2, 2));
  }
  for (int i = 0; i <= 300; ++i) {
    carom::io::Frame frame{.time = i / 60.0};
    for (std::size_t k = 0; k < animals.size(); ++k) {
      const auto [s, c] = carom::sineCosine(rates[k] * frame.time / 2);
      const Real column = static_cast<Real>(k % 4), row = static_cast<Real>(k / 4);
      frame.poses.push_back({Vector3(1.7 * column, -2.2 * row, 0), {c, 0, 0, s}});
    }
    recording.addFrame(frame);
  }
  recording.writeHtml(file);
}

int main(int argc, char** argv) {
  const std::vector<Animal> animals = zoo();
  printZoo(animals);
  printSlips();
  record(animals, std::filesystem::path(argc > 1 ? argv[1] : ".") / "tensor_zoo.html");
}

// How is a body weighed that is made of parts?
//
// Pac-Man is a disc with a wedge cut out. He is not convex, so he is made of two convex halves.
// Each half is weighed by itself, and parallel axes bring both to the centre of the whole.

#include <filesystem>
#include <iostream>
#include <numbers>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/mass/combine_bodies.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::MassProperties;
using carom::Matrix3;
using carom::Real;
using carom::Vector2;
using carom::Vector3;

constexpr Real kMouth = std::numbers::pi / 3;  // [rad]: 60 degrees, open towards +x
constexpr Real kHeight = 0.2;                  // [m]
constexpr Real kDensity = 500;                 // [kg/m^3]
constexpr int kSteps = 48;                     // corners of each half's arc

// The outline of a piece of a disc of radius 1 m, from one angle to another, seen from `origin`.
std::vector<Vector2> sector(Real from, Real to, const Vector2& origin) {
  std::vector<Vector2> outline = {-origin};
  for (int i = 0; i <= kSteps; ++i) {
    const auto [s, c] = carom::sineCosine(from + (to - from) * i / kSteps);
    outline.push_back(Vector2(c, s) - origin);
  }
  return outline;
}

// A half, weighed: its outline is drawn about a point inside it and moved back.
MassProperties weighHalf(Real from, Real to) {
  const auto [s, c] = carom::sineCosine((from + to) / 2);
  const Vector2 inside = 0.5 * Vector2(c, s);
  const auto mesh = carom::translated(carom::prismMesh(sector(from, to, inside), kHeight),
                                      Vector3(inside.x(), inside.y(), 0));
  return carom::massProperties(mesh, kDensity);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const Real pi = std::numbers::pi;
  const MassProperties upper = weighHalf(kMouth / 2, pi);
  const MassProperties lower = weighHalf(-pi, -kMouth / 2);

  //! [combine]
  const std::vector<MassProperties> parts = {upper, lower};
  const MassProperties whole = carom::combineBodies(parts);
  //! [combine]

  //! [wrong]
  Matrix3 sum = Matrix3::Zero();       // each about its own centre
  Matrix3 diagonal = Matrix3::Zero();  // the source's m d^2, added to the diagonal
  for (const MassProperties& part : parts) {
    const Real d2 = (part.center - whole.center).squaredNorm();
    sum += part.inertia;
    diagonal += part.inertia + part.mass * d2 * Matrix3::Identity();
  }
  //! [wrong]

  // The same body in one piece: the outline seen from a point behind the mouth.
  const Vector2 behind(-0.1, 0);
  const auto mesh =
      carom::translated(carom::prismMesh(sector(kMouth / 2, 2 * pi - kMouth / 2, behind), kHeight),
                        Vector3(-0.1, 0, 0));
  // The arc of the one piece has half as many corners per radian, so it differs a little.
  const MassProperties one = carom::massProperties(mesh, kDensity);

  carom::io::Table table;
  table.column("way")
      .column("mass [kg]", carom::io::fixed(2))
      .column("centre x [m]", carom::io::fixed(4));
  for (const char* title : {"Ixx [kg m^2]", "Iyy [kg m^2]", "Izz [kg m^2]"}) {
    table.column(title, carom::io::fixed(3));
  }
  const auto add = [&](const char* way, Real mass, Real x, const Matrix3& I) {
    table.row({way, mass, x, I(0, 0), I(1, 1), I(2, 2)});
  };
  add("upper half, own centre", upper.mass, upper.center.x(), upper.inertia);
  add("lower half, own centre", lower.mass, lower.center.x(), lower.inertia);
  add("combined", whole.mass, whole.center.x(), whole.inertia);
  add("in one piece", one.mass, one.center.x(), one.inertia);
  add("wrong: tensors added", whole.mass, whole.center.x(), sum);
  add("wrong: m d^2 on the diagonal", whole.mass, whole.center.x(), diagonal);
  std::cout << table;

  carom::io::Plot plot("Pac-Man in two convex halves");
  plot.xAxis("x [m]").yAxis("y [m]").equalAspect().size(600, 560);
  plot.polygon("upper half", sector(kMouth / 2, pi, Vector2::Zero()));
  plot.polygon("lower half", sector(-pi, -kMouth / 2, Vector2::Zero()));
  plot.points("centres of the halves", {upper.center.x(), lower.center.x()},
              {upper.center.y(), lower.center.y()});
  plot.points("centre of the whole", {whole.center.x()}, {whole.center.y()});
  plot.arrow(whole.center.head<2>(), upper.center.head<2>());
  plot.arrow(whole.center.head<2>(), lower.center.head<2>());
  plot.writeSvg(folder / "pacman.svg");
}

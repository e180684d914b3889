// Does a body notice of how many triangles its floor is made?
//
// A box and a ball slide over one floor, over a sheet of triangles that is ground, and over
// the same triangles as solids of their own, each of which has edges and sides. Then a crowd
// rolls and tumbles down into a hollow of triangles, for the picture.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/world/world.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::TriangleMesh;
using carom::Vector3;
using carom::world::BodyDescription;
using carom::world::BodyId;
using carom::world::BodyKind;
using carom::world::ShapeDescription;
using carom::world::World;

constexpr Real kStep = 1.0 / 60;

// A square sheet of cells x cells x 2 triangles, its inner corners shaken sideways.
template <class Height>
TriangleMesh sheet(Real half, int cells, const Height& height) {
  carom::Random random(8);
  TriangleMesh mesh;
  const Real cell = 2 * half / cells;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const bool inside = i > 0 && j > 0 && i < cells && j < cells;
      const Real dx = random.between(-0.3, 0.3), dy = random.between(-0.3, 0.3);
      const Real x = -half + cell * (i + (inside ? dx : 0));
      const Real y = -half + cell * (j + (inside ? dy : 0));
      mesh.vertices.push_back({x, y, height(x, y)});
      if (i == cells || j == cells) continue;
      const int a = i * (cells + 1) + j, b = a + cells + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return mesh;
}

//! [ground]
BodyDescription groundOf(const TriangleMesh& mesh) {
  ShapeDescription sheet;
  sheet.ground = std::make_shared<TriangleMesh>(mesh);
  BodyDescription body;
  body.kind = BodyKind::immovable;
  body.shapes = {sheet};
  return body;
}
//! [ground]

// Each triangle for itself: a solid with a tip below it.
BodyDescription solidsOf(const TriangleMesh& mesh) {
  BodyDescription body;
  body.kind = BodyKind::immovable;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto corner = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
    const Vector3 below = (corner(a) + corner(b) + corner(c)) / 3 - Vector3::UnitZ();
    const std::vector<Vector3> corners = {corner(a), corner(b), corner(c), below};
    body.shapes.push_back({.shape = carom::hullOfPoints(corners)});
  }
  return body;
}

BodyDescription plane() {
  BodyDescription body;
  body.kind = BodyKind::immovable;
  body.shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}};
  return body;
}

BodyDescription thing(const carom::Shape& shape, const Vector3& at, const Vector3& velocity) {
  BodyDescription body;
  body.position = at;
  body.velocity = velocity;
  body.shapes = {{.shape = shape}};
  return body;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const TriangleMesh flat = sheet(4, 16, [](Real, Real) { return Real(0); });
  const std::vector<std::pair<std::string, BodyDescription>> floors = {
      {"one floor", plane()}, {"ground", groundOf(flat)}, {"solids", solidsOf(flat)}};
  carom::io::Table table;
  table.column("body").column("floor").column("way [m]", carom::io::fixed(9));
  table.column("highest [m]", carom::io::scientific(1));
  table.column("impacts").column("points");
  for (const bool isBox : {true, false}) {
    for (const auto& [name, floor] : floors) {
      World world({.sleeping = false});
      world.add(floor);
      const carom::Shape shape =
          isBox ? carom::Shape(carom::makeBox({0.3, 0.2, 0.1})) : carom::Shape(carom::Ball{0.1});
      const BodyId body = world.add(thing(shape, {-2.5, 0.15, 0.1}, {4, 0.5, 0}));
      Real highest = 0;
      std::size_t impacts = 0;
      int points = 0;
      for (int n = 0; n < 60; ++n) {
        world.step(kStep);
        highest = std::max(highest, world.position(body).z() - 0.1);
        impacts += world.events().impacts.size();
        int now = 0;
        for (const auto& pair : world.touching()) now += pair.points;
        points = std::max(points, now);
      }
      const Vector3 way = world.position(body) - Vector3(-2.5, 0.15, 0.1);
      table.row(
          {isBox ? "box" : "ball", name, std::hypot(way.x(), way.y()), highest, impacts, points});
    }
  }
  std::cout << table;

  const TriangleMesh hollow = sheet(6, 24, [](Real x, Real y) {
    return 0.05 * (x * x + y * y) + 0.25 * carom::sine(2 * x) * carom::cosine(2 * y);
  });
  World world;
  world.add(groundOf(hollow));
  carom::io::Recording recording("Into a hollow", "Boxes and balls on a ground of 1152 triangles.");
  recording.addFixed("ground", carom::io::Mesh{hollow}, {},
                     {.color = carom::io::Color{170, 180, 170}});
  carom::Random random(5);
  std::vector<BodyId> bodies;
  for (int i = 0; i < 24; ++i) {
    const Real x = random.between(-4.5, 4.5), y = random.between(-4.5, 4.5);
    const Vector3 at(x, y, 4 + 0.15 * i);
    const Vector3 half = Vector3::Constant(0.22) + random.vector(0.07);
    const bool isBox = i % 2 == 0;
    const carom::Shape shape =
        isBox ? carom::Shape(carom::makeBox(half)) : carom::Shape(carom::Ball{half.x()});
    bodies.push_back(world.add(thing(shape, at, Vector3::Zero())));
    const std::string name = (isBox ? "box " : "ball ") + std::to_string(i);
    if (isBox) {
      recording.addBody(name, carom::io::Box{2 * half});
    } else {
      recording.addBody(name, carom::io::Ball{half.x()});
    }
  }
  recording.setView({.target = Vector3(0, 0, 0.5), .distance = 13});
  for (int n = 0; n < 360; ++n) {
    world.step(kStep);
    if (n % 2 == 0) continue;
    carom::io::Frame frame{.time = world.time()};
    for (const BodyId id : bodies) {
      frame.poses.push_back({world.position(id), world.orientation(id)});
    }
    recording.addFrame(frame);
  }
  recording.writeHtml(folder / "triangle_floor.html");
}

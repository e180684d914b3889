// How thin may an arch be?
//
// Twelve wedges make half a circle of stone, without mortar. Statics says that it stands if it is
// thicker than 10.49% of its radius: then a line of thrust fits into the stones (Milankovitch 1907,
// Heyman 1966). In the world, with the friction of stone, four arches stand side by side: a tenth
// thicker than that, a little thicker, a little thinner, and a tenth thinner.

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/world/world.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyId;

constexpr int kStones = 12;
constexpr Real kLimit = 0.1048566596612387;  // thickness over radius, by statics
constexpr Real kApart = 4;                   // what falls must not strike the next one [m]
constexpr Real kDeep = 0.25;                 // half the depth of a stone [m]
constexpr Real kStep = 1.0 / 60;
constexpr std::array<Real, 4> kThickness = {1.1, 1.02, 0.98, 0.9};  // in parts of the limit

// The corners of a stone of an arch of radius 1 m.
std::vector<Vector3> cornersOf(int stone, Real thickness) {
  std::vector<Vector3> corners;
  for (const int joint : {stone, stone + 1}) {
    const Real angle = std::numbers::pi * joint / kStones;
    for (const Real radius : {1 - thickness / 2, 1 + thickness / 2}) {
      for (const Real y : {-kDeep, kDeep}) {
        corners.push_back({-radius * carom::cosine(angle), y, radius * carom::sine(angle)});
      }
    }
  }
  return corners;
}

carom::TriangleMesh surface(const carom::ConvexHull& hull) {
  carom::TriangleMesh mesh{hull.vertices, {}};
  for (const carom::HullFace& face : hull.faces) {
    const auto corner = [&](int i) { return hull.halfEdges[face.firstHalfEdge + i].origin; };
    for (int i = 1; i + 1 < face.count; ++i) {
      mesh.triangles.push_back({corner(0), corner(i), corner(i + 1)});
    }
  }
  return mesh;
}

struct Arch {
  Real thickness = 0;  // [m]
  std::vector<BodyId> stones;
  Real fallsAt = 0;  // [s]
};

// Four arches side by side; recorded if there is something to record with.
std::vector<Arch> build(carom::world::World& world, Real friction, carom::io::Recording* film) {
  const carom::world::Material rough{.friction = friction};
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero()),
                         .material = rough}}});
  std::vector<Arch> arches;
  for (const Real part : kThickness) {
    Arch arch;
    arch.thickness = part * kLimit;
    const Vector3 place(kApart * (Real(arches.size()) - 1.5), 0, 0);
    for (int i = 0; i < kStones; ++i) {
      const carom::ConvexHull stone = carom::hullOfPoints(cornersOf(i, arch.thickness));
      arch.stones.push_back(world.add(
          {.position = place, .shapes = {{.shape = stone, .material = rough}}, .maySleep = false}));
      if (film == nullptr) continue;
      film->addBody(std::to_string(arches.size()) + "." + std::to_string(i),
                    carom::io::Mesh{surface(stone)});
    }
    arches.push_back(arch);
  }
  return arches;
}

void run(carom::world::World& world, std::vector<Arch>& arches, carom::io::Recording* film) {
  for (int n = 0; n < 600; ++n) {
    if (film != nullptr && n % 6 == 0) {
      carom::io::Frame frame{.time = world.time()};
      for (const Arch& arch : arches) {
        for (const BodyId id : arch.stones) {
          frame.poses.push_back({world.position(id), world.orientation(id)});
        }
      }
      film->addFrame(frame);
    }
    world.step(kStep);
    for (Arch& arch : arches) {
      const bool low = world.centre(arch.stones[kStones / 2]).z() < 0.7;
      if (low && arch.fallsAt == 0) arch.fallsAt = world.time();
    }
  }
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Recording recording("Four arches",
                                 "From the left: 10% thicker than the limit, 2% thicker, 2% "
                                 "thinner and 10% thinner. The two thin ones fall.");
  recording.addFixed("ground", carom::io::Plane{.size = 20, .gridStep = 1});
  recording.setView({.direction = {0, 1, -0.2}, .target = Vector3(0, 0, 0.7), .distance = 16});
  carom::world::World stone, rough;
  std::vector<Arch> arches = build(stone, 0.7, &recording), others = build(rough, 4, nullptr);
  run(stone, arches, &recording);
  run(rough, others, nullptr);

  carom::io::Table table;
  table.column("thickness / limit", carom::io::fixed(2));
  table.column("thickness [mm]", carom::io::fixed(1));
  table.column("friction 0.7").column("friction 4");
  const auto fate = [](const Arch& arch) {
    return std::string(arch.fallsAt > 0 ? "has fallen" : "stands");
  };
  for (std::size_t k = 0; k < arches.size(); ++k) {
    table.row({kThickness[k], 1000 * arches[k].thickness, fate(arches[k]), fate(others[k])});
  }
  std::cout << "Arches of twelve stones, 1 m in radius, after ten seconds\n\n" << table;
  recording.writeHtml(folder / "arch.html");
}

// Where do bodies of every kind touch?
//
// Fifteen pairs, B above A and 10 mm deep in it. The table has the manifold at rest; in the picture
// B moves about, and a dot marks each contact point. At the end: a box that is tilted by a
// billionth, and the names of its points.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/manifold/collide.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"
#include "zoo_scenes.hpp"

using carom::FeatureKind;
using carom::Manifold;
using carom::PartManifold;
using carom::Real;
using carom::Vector3;
using zoo::Scene;

std::vector<PartManifold> touch(const Scene& scene, const carom::io::Pose& a,
                                const carom::io::Pose& b) {
  std::vector<PartManifold> manifolds;
  carom::collide(scene.a.shape, carom::poseOf(a.orientation, a.position), scene.b.shape,
                 carom::poseOf(b.orientation, b.position), manifolds);
  return manifolds;
}

carom::io::Pose poseOfB(const Scene& scene, const Vector3& cell, Real time) {
  const auto [s, c] = carom::sineCosine(0.25 * time);  // half of the angle that B turns about z
  const auto [y, x] = carom::sineCosine(time);
  const Vector3 aside(scene.slide * (1 - x), scene.slide * y, 0);
  return {cell + aside + Vector3(0, 0, scene.top + scene.height - zoo::kDeep),
          carom::hamiltonProduct({c, 0, 0, s}, scene.turnB)};
}

void printZoo() {
  carom::io::Table table;
  table.column("A").column("B").column("B is").column("parts").column("points");
  table.column("depth [mm]", carom::io::fixed(1));
  table.column("area [m^2]", carom::io::fixed(4));
  for (const Scene& scene : zoo::scenes()) {
    const std::vector<PartManifold> manifolds =
        touch(scene, {Vector3::Zero(), scene.turnA}, poseOfB(scene, Vector3::Zero(), 0));
    int points = 0;
    Real depth = 0, area = 0;
    for (const auto& [partA, partB, manifold] : manifolds) {
      points += manifold.count;
      area += manifold.area;
      for (int i = 0; i < manifold.count; ++i)
        depth = std::max(depth, -manifold.points[i].separation);
    }
    table.row(
        {scene.a.name, scene.b.name, scene.how, manifolds.size(), points, 1000 * depth, area});
  }
  std::cout << table;
}

std::string hex(std::uint32_t id) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(id));
  return text;
}

//! [names]
void printNames() {
  carom::io::Table table;
  table.column("tilt [rad]", carom::io::significant(1)).column("names of the points");
  const carom::Box box{{1, 1, 0.5}};
  for (const Real tilt : {-1e-9, 0.0, 1e-9}) {
    const carom::Pose A, B = carom::poseOf({1, 0, tilt / 2, 0}, {0.3, 0.2, 1 - 1e-6});
    const Manifold manifold = carom::collide(box, A, box, B);
    std::string names;
    for (int i = 0; i < manifold.count; ++i)
      names += (i > 0 ? " " : "") + hex(manifold.points[i].id);
    table.row({tilt, names});
  }
  std::cout << table;
  const carom::FeaturePair cornerOnFace{{FeatureKind::face, 5}, {FeatureKind::vertex, 0}};
  const carom::FeaturePair edgeOverEdge{{FeatureKind::edge, 6}, {FeatureKind::edge, 8}};
  const std::vector<std::uint32_t> ids =
      carom::contactIds(std::vector<carom::FeaturePair>{cornerOnFace, edgeOverEdge});
  std::cout << '\n' << hex(ids[0]) << ": corner 0 of B on face 5 of A\n";
  std::cout << hex(ids[1]) << ": edge 8 of B over edge 6 of A\n";
}
//! [names]

void record(const std::filesystem::path& file) {
  carom::io::Recording recording(
      "Fifteen manifolds",
      "Fifteen pairs of bodies, one on the other. The upper one slides and "
      "turns, and a dot marks each point of contact.");
  recording.setView({.direction = Vector3(0.1, 1, -0.6)});
  const std::vector<Scene> all = zoo::scenes();
  const auto cell = [](std::size_t i) {
    return Vector3(2.4 * static_cast<Real>(i % 5), -2.4 * static_cast<Real>(i / 5), 0);
  };
  // A body cannot appear or vanish: dots without a point stay with the first one.
  const auto dots = [](const Scene& scene) { return scene.b.name == "two legs" ? 8u : 4u; };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = std::to_string(i + 1) + ": " + all[i].a.name + " and " + all[i].b.name;
    recording.addFixed(name + ", A", all[i].a.picture, {cell(i), all[i].turnA},
                       {.color = carom::io::kBlue});
    recording.addBody(name + ", B", all[i].b.picture,
                      {.color = carom::io::kOrange, .opacity = 0.5});
    for (unsigned k = 1; k <= dots(all[i]); ++k) {
      recording.addBody(name + ", point " + std::to_string(k), carom::io::Ball{0.06},
                        {.color = carom::io::kVermilion});
    }
  }
  for (int step = 0; step <= 300; ++step) {
    carom::io::Frame frame{.time = step / 30.0};
    for (std::size_t i = 0; i < all.size(); ++i) {
      frame.poses.push_back(poseOfB(all[i], cell(i), frame.time));
      std::vector<carom::io::Pose> points;
      for (const auto& part : touch(all[i], {cell(i), all[i].turnA}, frame.poses.back())) {
        for (int k = 0; k < part.manifold.count; ++k) {
          points.push_back({part.manifold.points[k].position, {}});
        }
      }
      points.resize(dots(all[i]), points.empty() ? carom::io::Pose{cell(i), {}} : points[0]);
      frame.poses.insert(frame.poses.end(), points.begin(), points.end());
    }
    recording.addFrame(frame);
  }
  recording.writeHtml(file);
}

int main(int argc, char** argv) {
  printZoo();
  std::cout << "\nA box on a box, tilted by a billionth\n\n";
  printNames();
  record(std::filesystem::path(argc > 1 ? argv[1] : ".") / "manifold_zoo.html");
}

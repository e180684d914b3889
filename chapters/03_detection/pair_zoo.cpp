// How far apart is every kind of body from every other kind?
//
// Seven kinds make 27 pairs (two half-spaces have no distance worth the name). In each, B comes
// towards A, sinks into it and leaves again, turning; dots are the two nearest points.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/mass/meshes.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Pose;
using carom::Real;
using carom::Separation;
using carom::Vector3;

struct Kind {
  std::string name;
  carom::Shape shape;
  carom::io::Shape picture;
};

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

//! [kinds]
std::vector<Kind> kinds() {
  const carom::ConvexHull gem = carom::hullOfPoints(std::vector<Vector3>{
      {0.5, 0, 0}, {-0.4, 0.3, 0}, {-0.3, -0.4, 0.1}, {0, 0.1, 0.6}, {0.1, 0, -0.5}, {0, 0.5, 0}});
  const Vector3 arm(0.5, 0.15, 0.15), place(0, 0, 0.4);
  const carom::Compound cross = carom::makeCompound(
      {{carom::makeBox(arm), {}},
       {carom::makeBox({0.15, 0.15, 0.5}), {carom::Matrix3::Identity(), place}}});
  return {
      {"ball", carom::makeBall(0.45), carom::io::Ball{0.45}},
      {"box", carom::makeBox({0.5, 0.35, 0.3}), carom::io::Box{{1, 0.7, 0.6}}},
      {"capsule", carom::makeCapsule(0.25, 0.35), carom::io::Capsule{0.25, 0.7}},
      {"cylinder", carom::makeCylinder(0.35, 0.4), carom::io::Cylinder{0.35, 0.8}},
      {"hull", gem, carom::io::Mesh{surface(gem)}},
      {"compound", cross,
       carom::io::Mesh{carom::joined(carom::boxMesh(-arm, arm),
                                     carom::boxMesh({-0.15, -0.15, -0.1}, {0.15, 0.15, 0.9}))}},
      {"half-space", carom::makeHalfSpace({0, 0, 1}, {0, 0, -0.3}), carom::io::Plane{1.8, 0.3}},
  };
}
//! [kinds]

struct Pair {
  Kind a, b;
  Vector3 cell;  // where it stands in the picture [m]
};

// A half-space is always A here, and stays as it is; other bodies are turned a little.
carom::io::Pose placeOfA(const Pair& pair) {
  const auto [s, c] = carom::sineCosine(0.3);
  if (pair.a.name == "half-space") return {pair.cell, {}};
  return {pair.cell, {c, s * 0.6, s * 0.8, 0}};
}

carom::io::Pose placeOfB(const Pair& pair, Real time) {
  const Real swing = carom::cosine(std::numbers::pi * time / 4);  // 1, -1 after 4 s, 1 after 8 s
  const auto [s, c] = carom::sineCosine(0.35 * time + 0.2);
  const bool plane = pair.a.name == "half-space";
  const Vector3 direction = plane ? Vector3(0, 0, 1) : Vector3(0.48, 0.6, 0.64);
  return {pair.cell + ((plane ? 0.45 : 0.85) + 0.45 * swing) * direction,
          {c, s * 0.48, s * 0.6, -s * 0.64}};
}

Separation distance(const Pair& pair, Real time) {
  const carom::io::Pose a = placeOfA(pair), b = placeOfB(pair, time);
  return carom::signedDistance(pair.a.shape, carom::poseOf(a.orientation, a.position), pair.b.shape,
                               carom::poseOf(b.orientation, b.position));
}

std::string triple(const Vector3& v) {
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += (i ? ", " : "(") + carom::io::Cell(v(i)).text(carom::io::fixed(2));
  return text + ")";
}

int main(int argc, char** argv) {
  const std::vector<Kind> all = kinds();
  std::vector<Pair> pairs;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j <= std::min(i, 5); ++j) {
      const int n = static_cast<int>(pairs.size());  // seven in a row
      pairs.push_back({all[i], all[j], {2.5 * (n % 7), -2.8 * (n / 7), 0}});
    }
  }

  carom::io::Table table;
  table.column("A").column("B").column("apart [m]", carom::io::fixed(4));
  table.column("overlap [m]", carom::io::fixed(4)).column("normal");
  Real check = 0;  // how far point A + s n is from point B [m]
  for (const Pair& pair : pairs) {
    const Separation apart = distance(pair, 0), deep = distance(pair, 4);
    for (const Separation& s : {apart, deep}) {
      check = std::max(check, (s.pointA + s.separation * s.normal - s.pointB).norm());
    }
    table.row({pair.a.name, pair.b.name, apart.separation, deep.separation, triple(deep.normal)});
  }
  std::cout << table << "\nPoint on A plus s n misses the point on B by at most "
            << carom::io::Cell(check).text(carom::io::scientific(0)) << " m.\n";

  carom::io::Recording recording("Every pair of bodies",
                                 "Twenty-seven pairs of bodies. In each pair one body comes "
                                 "towards the other, sinks into it "
                                 "and leaves; two dots are the nearest points.");
  recording.setView({.direction = Vector3(0, 0.8, -1)});
  for (const Pair& pair : pairs) {
    const std::string name = pair.a.name + ", " + pair.b.name;
    const bool plane = pair.a.name == "half-space";
    const Vector3 floor = plane ? Vector3(0, 0, -0.3) : Vector3(0, 0, 0);
    const carom::io::Pose a = placeOfA(pair);
    recording.addFixed(name + ": A", pair.a.picture, {a.position + floor, a.orientation},
                       {.color = carom::io::kBlue, .opacity = 0.55});
    recording.addBody(name + ": B", pair.b.picture, {.color = carom::io::kOrange, .opacity = 0.55});
    for (const char* point : {": point on A", ": point on B"}) {
      recording.addBody(name + point, carom::io::Ball{0.1}, {.color = carom::io::kVermilion});
    }
  }
  for (int step = 0; step <= 240; ++step) {
    carom::io::Frame frame{.time = step / 30.0};
    for (const Pair& pair : pairs) {
      const Separation s = distance(pair, frame.time);
      frame.poses.push_back(placeOfB(pair, frame.time));
      frame.poses.push_back({s.pointA, {}});
      frame.poses.push_back({s.pointB, {}});
    }
    recording.addFrame(frame);
  }
  recording.writeHtml(std::filesystem::path(argc > 1 ? argv[1] : ".") / "pair_zoo.html");
}

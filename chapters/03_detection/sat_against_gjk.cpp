// Separating axes or GJK: which is right, and which has more to do?
//
// Pairs of hulls whose distance is known, because of the way in which they are made: one below a
// plane, one above another, nearest to each other with corners, faces or edges. Then pairs with
// more and more corners, for which the work is counted, not timed.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/detection/gjk_distance.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/sat_hulls.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::ConvexHull;
using carom::Pose;
using carom::Real;
using carom::Vector3;
using Cloud = std::vector<Vector3>;

Pose turned(carom::Random& random) {
  carom::Quaternion q;
  for (Real* part : {&q.w, &q.x, &q.y, &q.z}) *part = random.between(-1, 1);
  return carom::poseOf(q, Vector3::Zero());
}

//! [made]
// What of a body lies at the height 0; all the rest of it is lower.
Cloud top(const std::string& feature) {
  if (feature == "corner") return {{0, 0, 0}};
  if (feature == "edge") return {{-1, 0, 0}, {1, 0, 0}};
  return {{-0.8, -0.6, 0}, {0.9, -0.5, 0}, {0, 0.9, 0}};  // face
}

// B is a body like A, turned upside down with the edge across,
// and put `gap` above A.
Cloud upsideDown(const Cloud& points, Real gap) {
  Cloud result;
  for (const Vector3& p : points) result.push_back({p.y(), p.x(), gap - p.z()});
  return result;
}
//! [made]

Cloud body(const std::string& feature, carom::Random& random) {
  Cloud points = top(feature);
  while (points.size() < 10) {
    points.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-2, -0.4)});
  }
  return points;
}

Cloud placed(const ConvexHull& hull, const Pose& pose) {
  Cloud points;
  for (const Vector3& vertex : hull.vertices) points.push_back(carom::pointToWorld(pose, vertex));
  return points;
}

std::size_t dotProducts(const ConvexHull& a, const ConvexHull& b) {
  const std::size_t axes = a.faces.size() + b.faces.size() + a.edges.size() * b.edges.size();
  return axes * (a.vertices.size() + b.vertices.size());
}

void printErrors(int pairs) {
  carom::io::Table table;
  table.column("nearest with").column("d [m]", carom::io::significant(1));
  table.column("axes [m]", carom::io::significant(3));
  table.column("error [m]", carom::io::scientific(0))
      .column("GJK err [m]", carom::io::scientific(0));
  table.column("points", carom::io::fixed(1));
  carom::Random random(3);
  const std::vector<std::pair<std::string, std::string>> kinds = {
      {"face", "face"}, {"face", "corner"}, {"edge", "edge"}, {"corner", "corner"}};
  for (const auto& [below, above] : kinds) {
    for (const Real gap : {1.0, 1e-6, 0.0}) {
      Real found = 0, satError = 0, gjkError = 0, points = 0;
      for (int i = 0; i < pairs; ++i) {
        const ConvexHull a = carom::hullOfPoints(body(below, random));
        const ConvexHull b = carom::hullOfPoints(upsideDown(body(above, random), gap));
        const Pose pose = turned(random);
        const Real axis = carom::satHulls(a, pose, b, pose).separation;
        const carom::PointDistance gjk = carom::gjkDistance(placed(a, pose), placed(b, pose));
        found += axis / pairs;
        satError = std::max(satError, std::abs(axis - gap));
        gjkError = std::max(gjkError, std::abs(gjk.distance - gap));
        points += static_cast<Real>(gjk.iterations) / pairs;
      }
      table.row({below + " and " + above, gap, std::abs(found) < 1e-14 ? 0 : found, satError,
                 gjkError, points});
    }
  }
  std::cout << table;
}

Cloud onBall(int corners, carom::Random& random) {
  Cloud points;
  while (static_cast<int>(points.size()) < corners) {
    const Vector3 p(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (p.norm() > 0.1 && p.norm() < 1) points.push_back(p.normalized());
  }
  return points;
}

void printWork(const std::filesystem::path& folder) {
  carom::io::Table table;
  table.column("corners").column("axes").column("dot products");
  table.column("GJK points", carom::io::fixed(1)).column("for GJK", carom::io::fixed(0));
  std::vector<Real> corners, forAxes, forGjk;
  carom::Random random(8);
  for (const int n : {8, 16, 32, 64, 128}) {
    constexpr int kPairs = 50;
    Real points = 0;
    std::size_t work = 0;
    for (int i = 0; i < kPairs; ++i) {
      const ConvexHull a = carom::hullOfPoints(onBall(n, random));
      const ConvexHull b = carom::hullOfPoints(onBall(n, random));
      const Pose A = turned(random), B{turned(random).R_WB, {2.2, 0, 0}};
      work = dotProducts(a, b);
      points +=
          static_cast<Real>(carom::gjkDistance(placed(a, A), placed(b, B)).iterations) / kPairs;
    }
    corners.push_back(n);
    forAxes.push_back(static_cast<Real>(work));
    forGjk.push_back(points * 2 * n);
    table.row({n, work / static_cast<std::size_t>(2 * n), work, points, forGjk.back()});
  }
  std::cout << table;
  carom::io::Plot plot("Work for one pair of hulls");
  plot.xAxis("corners of each hull", carom::io::Scale::Logarithmic)
      .xRange(5, 200)
      .yAxis("dot products", carom::io::Scale::Logarithmic);
  plot.curve("all axes", corners, forAxes, {.marks = true});
  plot.curve("GJK", corners, forGjk, {.marks = true});
  plot.slope("slope 3", 3, 8, forAxes.front() / 2).slope("slope 1", 1, 8, forGjk.front() / 2);
  plot.writeSvg(folder / "sat_against_gjk.svg");
}

int main(int argc, char** argv) {
  std::cout << "200 pairs in each row, at a known distance d; the largest errors\n\n";
  printErrors(200);
  std::cout << "\nWork, counted: hulls with corners on a ball, apart\n\n";
  printWork(argc > 1 ? argv[1] : ".");
}

// What is left of one face over another?
//
// A face is cut by the planes that stand on the four edges of a rectangle, one after the other.
// Each picture is one cut. Then the same for two cubes, and what the contact point of the source
// would do in its place.

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "../03_detection/panels.hpp"
#include "carom/core/cross.hpp"
#include "carom/manifold/clip_polygon.hpp"
#include "carom/manifold/face_contact.hpp"
#include "carom/manifold/polygon_centroid.hpp"
#include "carom/manifold/reduce_contacts.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector2;
using carom::Vector3;
using Loop = std::vector<Vector3>;

const Loop kReference = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}};   // [m]
const Loop kIncident = {{1, -1, 0}, {5, 1, 0}, {4, 4, 0}, {-1, 2, 0}};  // [m]

std::vector<Vector2> flat(const Loop& loop) {
  std::vector<Vector2> corners;
  for (const Vector3& corner : loop) corners.push_back(corner.head<2>());
  return corners;
}

carom::io::Plot panel(const std::string& title, const Loop& left) {
  carom::io::Plot plot(title);
  plot.xRange(-2, 6).yRange(-2, 5).equalAspect().size(380, 330);
  plot.polygon("", flat(kReference), {.opacity = 0.1, .color = carom::io::kBlue});
  plot.polygon("", flat(left), {.opacity = 0.35, .color = carom::io::kVermilion});
  return plot;
}

// The line of a cut across the whole picture, and its corners.
void mark(carom::io::Plot& plot, const Vector3& from, const Vector3& along, const Loop& left) {
  const Vector3 a = from - 6 * along.normalized(), b = from + 8 * along.normalized();
  const auto inside = [](Real v, Real low, Real high) { return std::min(std::max(v, low), high); };
  plot.curve("", {inside(a.x(), -1.9, 5.9), inside(b.x(), -1.9, 5.9)},
             {inside(a.y(), -1.9, 4.9), inside(b.y(), -1.9, 4.9)},
             {.dashed = true, .color = carom::io::kGreen});
  std::vector<Real> x, y;
  for (const Vector3& corner : left) x.push_back(corner.x()), y.push_back(corner.y());
  plot.curve("", x, y, {.line = false, .marks = true, .color = carom::io::kVermilion});
}

Vector3 meanOf(const Loop& corners) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& corner : corners) sum += corner;
  return sum / static_cast<Real>(corners.size());
}

void printCubes() {
  // Cubes of 2 m, B at (1.9, 1.5, 0): they overlap by 0.1 m along x, on a part of their faces.
  const Loop faceOfA = {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}};
  const Loop faceOfB = {{0.9, 0.5, -1}, {0.9, 0.5, 1}, {0.9, 2.5, 1}, {0.9, 2.5, -1}};
  const Vector3 n = Vector3::UnitX();
  //! [cubes]
  Loop common;  // halfway between the two faces
  for (const auto& [position, separation] : carom::faceContact(faceOfA, n, faceOfB)) {
    common.push_back(position - separation / 2 * n);
  }
  const Vector3 center = carom::polygonCentroid(common).centroid;
  // Amid the overlap, on the axis through A's centre.
  const Vector3 onAxis = 0.95 * n;
  //! [cubes]
  carom::io::Table table;
  table.column("contact point");
  for (const char* title : {"x [m]", "y [m]", "z [m]", "arm x normal [m]"}) {
    table.column(title, carom::io::fixed(2));
  }
  for (const Vector3& corner : common) {
    table.row({"a corner of the contact", corner.x(), corner.y(), corner.z(),
               carom::cross(corner, n).z()});
  }
  table.row(
      {"centre of the area", center.x(), center.y(), center.z(), carom::cross(center, n).z()});
  table.row({"the source's, on the axis", onAxis.x(), onAxis.y(), onAxis.z(),
             carom::cross(onAxis, n).z()});
  std::cout << table;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("cut").column("corners").column("area [m^2]", carom::io::fixed(4));
  std::vector<carom::io::Plot> panels = {panel("before", kIncident)};
  Loop left = kIncident;
  table.row({"before", left.size(), carom::polygonCentroid(left).area});
  for (std::size_t i = 0; i < 4; ++i) {
    //! [cut]
    const Vector3 edge = kReference[(i + 1) % 4] - kReference[i];
    const Vector3 outward = carom::cross(edge, Vector3::UnitZ());
    left = carom::clipPolygon(left, outward, outward.dot(kReference[i]));
    //! [cut]
    const std::string name = "cut by edge " + std::to_string(i);
    panels.push_back(panel(name, left));
    mark(panels.back(), kReference[i], edge, left);
    table.row({name, left.size(), carom::polygonCentroid(left).area});
  }
  const Vector3 center = carom::polygonCentroid(left).centroid, mean = meanOf(left);
  panels.push_back(panel("o centre of the area, x mean of corners", left));
  panels.back().xRange(0, 4).yRange(0, 3);
  panels.back().label({center.x() - 0.1, center.y()}, "o").label({mean.x() - 0.1, mean.y()}, "x");
  writePanels(folder / "clip.svg", panels, 2, 380, 330);

  Loop four;
  for (const int i : carom::reduceContacts(left, std::vector<Real>(left.size(), 0))) {
    four.push_back(left[static_cast<std::size_t>(i)]);
  }
  table.row({"the best four", four.size(), carom::polygonCentroid(four).area});

  std::cout << "A quadrilateral cut to a rectangle of 4 m by 3 m\n\n" << table;
  const auto text = [](Real v) { return carom::io::Cell(v).text(carom::io::fixed(3)); };
  std::cout << "\ncentre of the area (" << text(center.x()) << ", " << text(center.y())
            << ") m, mean of the corners (" << text(mean.x()) << ", " << text(mean.y()) << ") m\n"
            << "\nTwo cubes that overlap on a part of their faces\n\n";
  printCubes();
}

// On which axis is there a gap?
//
// Two triangles, and their shadows on the normal of each of the six edges. Only one of the six
// shows that they are apart, and it belongs to the second triangle.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "carom/detection/project.hpp"
#include "carom/detection/sat_polygons.hpp"
#include "carom_io/table.hpp"
#include "panels.hpp"

using carom::Interval;
using carom::Real;
using carom::Vector2;
using carom::Vector3;

const std::vector<Vector2> kA = {{0.5, 0.5}, {-0.5, 2}, {-2.5, 0}};  // [m]
const std::vector<Vector2> kB = {{1.5, 2}, {0, -2}, {2.5, -0.5}};    // [m]

std::vector<Vector3> lifted(const std::vector<Vector2>& corners) {
  std::vector<Vector3> points;
  for (const Vector2& corner : corners) points.push_back({corner.x(), corner.y(), 0});
  return points;
}

struct Axis {
  std::string name;
  Vector2 normal;
  Interval ofA, ofB;  // shadows [m]
};

//! [axes]
// The normals of the edges of one triangle, and what both cover on each.
void addAxes(const std::string& owner, const std::vector<Vector2>& corners,
             std::vector<Axis>& axes) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 edge = corners[(i + 1) % corners.size()] - corners[i];
    const Vector2 normal = Vector2(edge.y(), -edge.x()).normalized();
    const Vector3 axis(normal.x(), normal.y(), 0);
    const Interval onA = carom::project(lifted(kA), axis);
    const Interval onB = carom::project(lifted(kB), axis);
    axes.push_back({"edge " + std::to_string(i) + " of " + owner, normal, onA, onB});
  }
}
//! [axes]

// The triangles, one axis beside them, and the shadows on it.
carom::io::Plot panel(const Axis& axis) {
  const Real gap = carom::gapBetween(axis.ofA, axis.ofB);
  const std::string says = (gap > 0 ? "a gap of " : "overlap ") +
                           carom::io::Cell(gap > 0 ? gap : -gap).text(carom::io::fixed(2)) + " m";
  carom::io::Plot plot(axis.name + ": " + says);
  plot.xRange(-4.2, 4.2).yRange(-4.2, 4.2).equalAspect().size(380, 360);
  plot.polygon("", kA, {.color = carom::io::kBlue});
  plot.polygon("", kB, {.color = carom::io::kVermilion});
  plot.label({-1.2, 0.8}, "A").label({1.4, 0.2}, "B");

  // The axis runs beside the bodies, on the side where there is room.
  Vector2 across(-axis.normal.y(), axis.normal.x());
  if (across.y() > 0) across = -across;
  const auto at = [&](Real along, Real beside) -> Vector2 {
    return along * axis.normal + beside * across;
  };
  const auto draw = [&](Real low, Real high, Real beside, carom::io::CurveStyle style) {
    const Vector2 from = at(low, beside), to = at(high, beside);
    plot.curve("", {from.x(), to.x()}, {from.y(), to.y()}, style);
  };
  draw(std::min(axis.ofA.low, axis.ofB.low) - 0.4, std::max(axis.ofA.high, axis.ofB.high) + 0.4,
       3.1, {.width = 1, .color = carom::io::kGray});
  draw(axis.ofA.low, axis.ofA.high, 3.0, {.width = 6, .color = carom::io::kBlue});
  draw(axis.ofB.low, axis.ofB.high, 3.2, {.width = 6, .color = carom::io::kVermilion});
  if (gap > 0) {  // the line that fits between them
    const Real middle = axis.ofB.low > axis.ofA.high ? (axis.ofB.low + axis.ofA.high) / 2
                                                     : (axis.ofA.low + axis.ofB.high) / 2;
    const Vector2 from = at(middle, 3.5), to = at(middle, -3);
    plot.curve("", {from.x(), to.x()}, {from.y(), to.y()},
               {.dashed = true, .color = carom::io::kGreen});
  }
  return plot;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::vector<Axis> axes;
  addAxes("A", kA, axes);
  addAxes("B", kB, axes);

  carom::io::Table table;
  table.column("normal of").column("x", carom::io::fixed(3)).column("y", carom::io::fixed(3));
  for (const char* title : {"A from", "to", "B from", "to", "gap"}) {
    table.column(title, carom::io::fixed(3));
  }
  std::vector<carom::io::Plot> panels;
  for (const Axis& axis : axes) {
    table.row({axis.name, axis.normal.x(), axis.normal.y(), axis.ofA.low, axis.ofA.high,
               axis.ofB.low, axis.ofB.high, carom::gapBetween(axis.ofA, axis.ofB)});
    panels.push_back(panel(axis));
  }
  std::cout << "Shadows of two triangles on the normals of their edges, in metres\n\n" << table;

  const carom::SeparatingAxis best = carom::satPolygons(kA, kB);
  std::cout << "\nThe best axis is the normal of edge "
            << (best.kind == carom::AxisKind::faceOfA ? best.featureA : best.featureB) << " of "
            << (best.kind == carom::AxisKind::faceOfA ? 'A' : 'B') << ", turned to ("
            << carom::io::Cell(best.axis.x()).text(carom::io::fixed(3)) << ", "
            << carom::io::Cell(best.axis.y()).text(carom::io::fixed(3)) << "),\nfrom A to B.\n";
  // Left the edges of A, right those of B.
  writePanels(folder / "axes.svg",
              {panels[0], panels[3], panels[1], panels[4], panels[2], panels[5]}, 2, 380, 360);
}

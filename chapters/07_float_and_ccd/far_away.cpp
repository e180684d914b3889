// What does a simulation look like 131 km from its origin?
//
// A body drifts for ten seconds in steps of a sixtieth, with its position in floats, in doubles,
// and in cells with offsets. Then it goes round a circle half a metre wide, and what the player
// sees is drawn: the position relative to a camera that stands beside it.

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/precision/cell_position.hpp"
#include "carom/precision/relative_to_origin.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::CellPosition;
using carom::FloatCellPosition;
using carom::Real;
using carom::Vector3;
using FloatVector3 = Eigen::Vector3f;

const Real kStep = 1 / 60.0;  // [s]

//! [bodies]
// One position, kept in four ways. The camera stands at `home`.
class Body {
 public:
  explicit Body(const Vector3& home)
      : home_(home), camera_(carom::cellPosition(home)), doubles_(home), cells_(camera_) {
    floats_ = home.cast<float>();
    floatCells_ = {camera_.cell, camera_.offset.cast<float>()};
  }

  void move(const Vector3& by) {
    floats_ += by.cast<float>();
    doubles_ += by;
    floatCells_ = carom::moved(floatCells_, by.cast<float>());
    cells_ = carom::moved(cells_, by);
  }

  // What the camera sees [m].
  std::vector<Vector3> seen() const {
    return {floats_.cast<Real>() - home_, doubles_ - home_,
            carom::relativeToOrigin(carom::inDoubles(floatCells_), camera_),
            carom::relativeToOrigin(cells_, camera_)};
  }

 private:
  Vector3 home_;
  CellPosition camera_;
  FloatVector3 floats_;
  Vector3 doubles_;
  FloatCellPosition floatCells_;
  CellPosition cells_;
};
//! [bodies]

const std::vector<std::string> kWays = {"floats", "doubles", "cells, floats", "cells, doubles"};

std::vector<Vector3> drifted(Real distance, Real speed) {
  Body body({distance, 0, 0});
  for (int i = 0; i < 600; ++i) body.move({speed * kStep, 0, 0});
  return body.seen();
}

void printDrift() {
  carom::io::Table table;
  table.column("position in").column("0.6 m/s moved [m]", carom::io::fixed(4));
  table.column("0.4 m/s moved [m]", carom::io::fixed(4));
  const auto fast = drifted(0x1p17, 0.6), slow = drifted(0x1p17, 0.4);
  for (std::size_t i = 0; i < 4; ++i) table.row({kWays[i], fast[i].x(), slow[i].x()});
  std::cout << "At 131 072 m, after ten seconds\n\n" << table << '\n';
}

void printErrors() {
  carom::io::Table table;
  table.column("error [m] at");
  for (const std::string& way : kWays) table.column(way, carom::io::scientific(0));
  for (const auto& [name, distance] : std::vector<std::pair<std::string, Real>>{
           {"1 km", 1000.0}, {"100 km", 1e5}, {"10 000 km", 1e7}, {"1e9 km", 1e12}}) {
    std::vector<carom::io::Cell> row = {name};
    for (const Vector3& place : drifted(distance, 0.6)) row.push_back(std::abs(place.x() - 6));
    table.row(row);
  }
  std::cout << table;
}

Vector3 onTheCircle(Real angle) {
  const auto [s, c] = carom::sineCosine(angle);
  return {0.25 * c, 0.25 * s, 0};
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  printDrift();
  printErrors();

  carom::io::Plot plot("Once round, 131 km from the origin");
  plot.xAxis("x [m]").yAxis("y [m]").equalAspect();
  plot.describe(
      "In cells the path is a circle. In floats it is a broken line that does not close.");
  carom::io::Recording recording("Far from the origin",
                                 "A ball on a circle: crooked in floats, round in cells.");
  recording.addBody("floats", carom::io::Disc{0.06}, {.trail = true});
  recording.addBody("cells", carom::io::Disc{0.06}, {.trail = true});
  recording.setView({.flat = true, .target = Vector3(0.4, 0, 0), .distance = 0.6});
  recording.setParameter("distance");

  for (const auto& [name, home] : std::vector<std::pair<std::string, Real>>{
           {"1 km", 1024.0}, {"131 km", 0x1p17}, {"1 049 km", 0x1p20}}) {
    Body body({home, home, 0});
    const Vector3 start = onTheCircle(0);
    std::vector<std::vector<Real>> x(4), y(4);
    recording.beginCase(name);
    for (int i = 0; i <= 240; ++i) {
      const auto seen = body.seen();
      for (std::size_t way = 0; way < 4; ++way) {
        x[way].push_back(start.x() + seen[way].x());
        y[way].push_back(start.y() + seen[way].y());
      }
      const auto at = [&](std::size_t way, Real beside) {
        return carom::io::Pose{.position = {beside + x[way].back(), y[way].back(), 0}};
      };
      recording.addFrame({.time = i * kStep, .poses = {at(0, 0), at(2, 0.8)}});
      const Real turn = 6.283185307179586 / 240;
      body.move(onTheCircle((i + 1) * turn) - onTheCircle(i * turn));
    }
    if (name == "131 km") {
      plot.curve("floats", x[0], y[0], {.width = 1});
      plot.curve("cells, floats", x[2], y[2]);
    }
  }
  plot.writeSvg(folder / "far_away.svg");
  recording.writeHtml(folder / "far_away.html");
}

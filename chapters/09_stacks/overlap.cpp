// How is an overlap taken away?
//
// A box of 1 kg stands 20 cm deep in the ground. Three ways to bring it out: by asking the solver for
// speed (Baumgarte), by velocities that move bodies and are then thrown away, and by putting it
// where it belongs (projection). What is left when the overlap is gone?

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/solver/box_column.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "push_out.hpp"

using carom::BoxColumn;
using carom::ContactRow;
using carom::Real;

constexpr Real kStep = 1.0 / 60;
constexpr Real kGravity = 9.81;
constexpr Real kDeep = 0.2;   // [m]
constexpr Real kShare = 0.2;  // of the overlap, in each step
enum class Way { baumgarte, pseudoVelocities, projection };

struct Story {
  std::vector<Real> times, heights;
  Real highest = -kDeep, fastest = 0;
};

Story tell(Way way) {
  BoxColumn column = carom::boxColumn(std::vector<Real>{1});
  auto& [bodies, rows] = column;
  ContactRow& row = rows[0];
  carom::MovingBody& box = bodies[1];
  row.separation = -kDeep;
  Story story;
  for (int n = 0; n < 60; ++n) {
    story.times.push_back(n * kStep);
    story.heights.push_back(1000 * row.separation);
    carom::pullDown(bodies, -kGravity * kStep);
    row.impulse = 0;
    //! [ways]
    row.target = -std::max(row.separation, Real(0)) / kStep;
    if (way == Way::baumgarte && row.separation < 0) {
      row.target = -kShare * row.separation / kStep;  // real speed
    }
    carom::sequentialImpulses(bodies, rows, 4);
    Real move = kStep * box.velocity.linear.z();
    if (way == Way::pseudoVelocities) {
      const auto moves = carom::pushOut(bodies, rows, kShare, 4);
      move += moves[1].linear.z();
    }
    if (way == Way::projection) move = std::max(move, -row.separation);
    //! [ways]
    row.separation += move;
    story.highest = std::max(story.highest, row.separation);
    story.fastest = std::max(story.fastest, box.velocity.linear.z());
  }
  return story;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Plot plot("Out of the ground");
  plot.describe(
      "Height over time. With Baumgarte the box comes up fastest and hops two "
      "centimetres into the air before it comes down. With pseudo-velocities it rises "
      "along a curve that flattens out at zero. Projection is there at once.");
  plot.xAxis("time [s]").yAxis("gap [mm]").size(760, 420);
  carom::io::Table table;
  table.column("way").column("fastest upwards [m/s]", carom::io::fixed(3));
  table.column("highest [mm]", carom::io::fixed(2)).column("in the end [mm]", carom::io::fixed(2));
  const std::vector<std::string> names = {"Baumgarte", "pseudo-velocities", "projection"};
  for (int k = 0; k < 3; ++k) {
    const Story story = tell(static_cast<Way>(k));
    const std::string& name = names[static_cast<std::size_t>(k)];
    table.row({name, story.fastest, 1000 * story.highest, story.heights.back()});
    plot.curve(name, story.times, story.heights);
  }
  std::cout << "A box that stands 200 mm deep in the ground\n\n" << table;
  plot.writeSvg(folder / "overlap.svg");
}

// Two billiard balls meet.
//
// A blue ball comes from the left with 0.5 m/s and hits a red one at rest, off its centre. The
// physics is in two_balls.hpp; here is what one sees of it: a table and a moving picture.

#include <filesystem>
#include <iostream>
#include <string>

#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"
#include "two_balls.hpp"

using namespace two_balls;

constexpr Real kStep = 0.001;  // [s]: at 0.5 m/s a ball moves half a millimetre in one step
constexpr int kSteps = 1600;   // 1.6 s in all

void printMotion(std::ostream& out) {
  using carom::io::fixed;
  carom::io::Table table;
  table.column("time [s]", fixed(1)).column("blue x [m]", fixed(4)).column("y [m]", fixed(4));
  table.column("red x [m]", fixed(4)).column("y [m]", fixed(4));
  table.column("p_x [mN s]", fixed(3))
      .column("p_y [mN s]", fixed(3))
      .column("energy [mJ]", fixed(3));
  Pair pair;
  for (int i = 0; i <= kSteps; ++i) {
    if (i % 200 == 0) {
      const Vector2 p = 1000 * momentum(pair);
      const auto& [blue, red] = pair;
      table.row({i * kStep, blue.position.x(), blue.position.y(), red.position.x(),
                 red.position.y(), p.x(), p.y(), 1000 * energy(pair)});
    }
    step(pair, kStep, 0.75);
  }
  out << table;
}

void record(const std::filesystem::path& file) {
  carom::io::Recording recording("Two billiard balls",
                                 "A blue ball comes from the left and hits a red one off its "
                                 "centre. The red one leaves along "
                                 "the line of centres; the blue one is turned aside.");
  recording.setView({.flat = true, .up = carom::Vector3::UnitY()});
  recording.addBody("blue", carom::io::Disc{kRadius}, {.color = carom::io::kBlue, .trail = true});
  recording.addBody("red", carom::io::Disc{kRadius},
                    {.color = carom::io::kVermilion, .trail = true});
  recording.addChannel("kinetic energy", "J");
  recording.setParameter("restitution e");
  const auto pose = [](const Ball& b) {
    return carom::io::Pose{carom::Vector3(b.position.x(), b.position.y(), 0), {}};
  };
  for (const char* label : {"0", "0.25", "0.5", "0.75", "1"}) {
    recording.beginCase(label);
    Pair pair;
    for (int i = 0; i <= kSteps; ++i) {
      if (i % 10 == 0) {
        recording.addFrame({i * kStep, {pose(pair.blue), pose(pair.red)}, {energy(pair)}, {}});
      }
      step(pair, kStep, std::stod(label));
    }
  }
  recording.writeHtml(file);
}

int main(int argc, char** argv) {
  std::cout << "Two balls of 0.17 kg, restitution 0.75\n\n";
  printMotion(std::cout);
  record(std::filesystem::path(argc > 1 ? argv[1] : ".") / "first_collision.html");
}

// carom_cut runs as a child, as a user runs it; what it writes is weighed, and given to `carom contact`.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "carom/mass/mass_properties.hpp"
#include "carom_io/mesh_file.hpp"
#include "support/catch.hpp"

namespace {

const std::filesystem::path kScratch = CAROM_SCRATCH_DIR;

int run(const std::string& command) {
  return std::system((command + " > " + (kScratch / "out.txt").string() + " 2>&1").c_str());
}

carom::Real volumeOf(const std::filesystem::path& mesh) {
  return carom::massPropertiesOfGoodMesh(carom::io::readMesh(mesh), 1).volume;
}

}  // namespace

TEST_CASE("the parts of a concave solid weigh as much as the solid, and contact takes them") {
  std::filesystem::create_directories(kScratch);
  const std::filesystem::path parts = kScratch / "parts.off";
  for (const std::string name : {"bracket.stl", "gear.off", "die.obj"}) {
    CAPTURE(name);
    const std::filesystem::path solid = std::filesystem::path(CAROM_MESH_DIR) / name;
    std::filesystem::remove(parts);
    REQUIRE(run(std::string(CAROM_CUT) + " " + solid.string() + " " + parts.string()) == 0);
    CHECK(std::abs(volumeOf(parts) - volumeOf(solid)) <= 1e-12 * volumeOf(solid));
    // Whether each part is convex is for `carom contact` to say: it refuses what is not.
    CHECK(run(std::string(CAROM_PROGRAM) + " contact " + parts.string() + " " + parts.string() +
              " --pose 1000 0 0") == 0);
    if (name != "die.obj") {
      CHECK(run(std::string(CAROM_PROGRAM) + " contact " + solid.string() + " " + solid.string()) !=
            0);
    }
  }
}

TEST_CASE("what is no solid is not cut") {
  std::filesystem::create_directories(kScratch);
  const std::filesystem::path open = kScratch / "open.off";
  std::ofstream(open) << "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n";
  const std::string out = (kScratch / "no.off").string();
  CHECK(run(std::string(CAROM_CUT) + " " + open.string() + " " + out) != 0);
  CHECK(run(std::string(CAROM_CUT) + " nothing.off " + out) != 0);
  CHECK(run(CAROM_CUT) != 0);
  CHECK_FALSE(std::filesystem::exists(out));
}

// The project's own mesh files, read and weighed, against fractions computed by the script that
// made them.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "carom/mass/check_mesh.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/quick_mesh_check.hpp"
#include "carom/mass/self_intersections.hpp"
#include "carom_io/mesh_file.hpp"
#include "support/catch.hpp"

using nlohmann::json;

namespace {

double number(const json& value) {
  return std::strtod(value.get<std::string>().c_str(), nullptr);
}

}  // namespace

TEST_CASE("whatever triangle a mesh file loses, the quick check and the plain one both refuse it") {
  for (const char* name : {"gear.off", "die.obj", "bracket.stl", "torus.ply", "knot.ply"}) {
    const carom::TriangleMesh good =
        carom::io::readMesh(std::filesystem::path(CAROM_MESH_DIR) / name);
    for (std::size_t t = 0; t < good.triangles.size(); t += 1 + good.triangles.size() / 50) {
      INFO(name << ", triangle " << t);
      carom::TriangleMesh open = good;
      open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      CHECK_FALSE(carom::isClearlyGood(open));
      CHECK_FALSE(carom::checkMesh(open).empty());
      carom::TriangleMesh flipped = good;
      std::swap(flipped.triangles[t][0], flipped.triangles[t][1]);
      CHECK_FALSE(carom::isClearlyGood(flipped));
      CHECK_FALSE(carom::checkMesh(flipped).empty());
    }
  }
}

TEST_CASE("every mesh file of the project is a good mesh and weighs what fractions say") {
  const std::filesystem::path folder = CAROM_MESH_DIR;
  std::ifstream file(folder / "expected.json");
  const json all = json::parse(file);
  REQUIRE(all.size() == 6);
  for (const auto& [name, expected] : all.items()) {
    INFO(name);
    const carom::TriangleMesh mesh = carom::io::readMesh(folder / name);
    CHECK(mesh.triangles.size() == expected["triangles"].get<std::size_t>());
    CHECK(carom::checkMesh(mesh).empty());
    CHECK(carom::isClearlyGood(mesh));
    CHECK(carom::selfIntersections(mesh).empty());
    const carom::MassProperties body = carom::massProperties(mesh, 1);
    const double volume = number(expected["volume"]);
    CHECK(std::abs(body.volume - volume) <= 2e-15 * volume);
    double largest = 0;
    double error = 0;
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      CHECK(std::abs(body.center[i] - number(expected["center"][row])) <= 2e-15);
      for (int j = 0; j < 3; ++j) {
        const double entry = number(expected["inertia"][row][static_cast<std::size_t>(j)]);
        largest = std::max(largest, std::abs(entry));
        error = std::max(error, std::abs(body.inertia(i, j) - entry));
      }
    }
    CHECK(error <= 2e-15 * largest);
  }
}

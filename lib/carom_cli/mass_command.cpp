#include "carom_cli/mass_command.hpp"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/parallel_axis.hpp"
#include "carom/mass/principal_axes.hpp"
#include "carom/mass/quick_mesh_check.hpp"
#include "carom/mass/self_intersections.hpp"
#include "carom/mass/shell_centroid.hpp"
#include "carom_io/mesh_file.hpp"
#include "carom_io/number_text.hpp"
#include "carom_io/table.hpp"

namespace carom::cli {

namespace {

using Json = nlohmann::ordered_json;

// Every point meets every triangle: as many points as about two seconds allow, within these bounds.
constexpr Real kPointsTimesTriangles = 4e8;
constexpr Real kFewestPoints = 1000, kMostPoints = 200000;
constexpr std::uint64_t kSeed = 1;

const char* nameOf(MassMethod method) {
  switch (method) {
    case MassMethod::Tetrahedra:
      return "tetrahedra";
    case MassMethod::MonteCarlo:
      return "montecarlo";
    case MassMethod::Surface:
      return "surface";
  }
  return "";
}

// The columns of a matrix one after the other: an axis is a list of three numbers.
Json columns(const Matrix3& m) {
  Json list = Json::array();
  for (int c = 0; c < 3; ++c) list.push_back(Json::array({m(0, c), m(1, c), m(2, c)}));
  return list;
}

Json rows(const Matrix3& m) {
  return columns(m.transpose());
}

Json numbers(const Vector3& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

struct Weighed {
  MassProperties body;
  std::optional<Real> relativeError;  // of the volume, one standard deviation
  std::string remark;
};

Weighed weigh(const TriangleMesh& mesh, const MassRequest& request) {
  if (request.method == MassMethod::MonteCarlo) {
    const Real points =
        std::clamp(kPointsTimesTriangles / Real(mesh.triangles.size()), kFewestPoints, kMostPoints);
    const MonteCarloMass estimate =
        monteCarloMass(mesh, request.density, static_cast<int>(points), kSeed);
    return {estimate.body, estimate.relativeError,
            "estimated from " + std::to_string(estimate.samples) + " random points, " +
                std::to_string(estimate.inside) + " of them inside"};
  }
  Weighed result{massPropertiesOfGoodMesh(mesh, request.density), std::nullopt, ""};
  if (request.method == MassMethod::Surface) {
    const Vector3 sheet = shellCentroid(mesh);
    result.body.inertia =
        parallelAxis(result.body.inertia, result.body.mass, sheet - result.body.center);
    result.body.center = sheet;
    result.remark =
        "the centre is that of the surface, a thin sheet, not that of the solid; "
        "the inertia is the solid's, about that point";
  }
  return result;
}

void printJson(const MassRequest& request, std::size_t triangles, const Weighed* weighed,
               const std::vector<std::string>& problems) {
  // A mesh that is no solid has no volume, so these are null: zero would be a number.
  Json out{{"file", request.file},
           {"method", nameOf(request.method)},
           {"density", request.density},
           {"volume", nullptr},
           {"mass", nullptr},
           {"center", nullptr},
           {"inertia", nullptr},
           {"principal_moments", nullptr},
           {"principal_axes", nullptr},
           {"triangles", triangles},
           {"problems", problems}};
  if (weighed != nullptr) {
    const PrincipalAxes principal = principalAxes(weighed->body.inertia);
    out["volume"] = weighed->body.volume;
    out["mass"] = weighed->body.mass;
    out["center"] = numbers(weighed->body.center);
    out["inertia"] = rows(weighed->body.inertia);
    out["principal_moments"] = numbers(principal.moments);
    out["principal_axes"] = columns(principal.axes);
    if (weighed->relativeError) out["relative_error"] = *weighed->relativeError;
    if (!weighed->remark.empty()) out["remark"] = weighed->remark;
  }
  std::cout << out.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void printText(const MassRequest& request, std::size_t triangles, const Weighed& weighed) {
  const MassProperties& body = weighed.body;
  const PrincipalAxes principal = principalAxes(body.inertia);
  std::cout << request.file << ": " << triangles << " triangles, " << request.density
            << " kg/m^3, by " << nameOf(request.method) << '\n';
  if (!weighed.remark.empty()) std::cout << "Note: " << weighed.remark << ".\n";
  io::Table table;
  const io::Notation digits = io::significant(12);
  table.column("quantity").column("x", digits).column("y", digits).column("z", digits);
  const auto addVector = [&table](const char* name, const Vector3& v) {
    table.row({name, v.x(), v.y(), v.z()});
  };
  addVector("centre [m]", body.center);
  for (int r = 0; r < 3; ++r) {
    addVector(r == 0 ? "inertia about the centre [kg m^2]" : "", body.inertia.row(r));
  }
  addVector("principal moments [kg m^2]", principal.moments);
  for (int c = 0; c < 3; ++c) {
    addVector(c == 0 ? "principal axes, one a line" : "", principal.axes.col(c));
  }
  std::cout << "volume " << io::roundedText(body.volume, std::chars_format::general, 12)
            << " m^3, mass " << io::roundedText(body.mass, std::chars_format::general, 12) << " kg";
  if (weighed.relativeError) {
    std::cout << ", both within about "
              << io::roundedText(100 * *weighed.relativeError, std::chars_format::general, 2)
              << " %";
  }
  std::cout << "\n\n" << table;
}

}  // namespace

int runMass(const MassRequest& request) {
  TriangleMesh mesh;
  std::vector<std::string> problems;
  std::optional<Weighed> weighed;
  try {
    mesh = io::readMesh(request.file);
    std::vector<MeshProblem> found;
    if (!isClearlyGood(mesh)) found = checkMesh(mesh);
    if (found.empty() && request.selfIntersections) found = checkSelfIntersections(mesh);
    for (const MeshProblem& problem : found) {
      problems.push_back(request.file + ": " + problem.message);
    }
    if (problems.empty()) weighed = weigh(mesh, request);
  } catch (const InvalidInput& error) {
    // The message of a mesh file error starts with the file's name already.
    const std::string message = error.what();
    const bool named = message.compare(0, request.file.size(), request.file) == 0;
    problems.push_back(named ? message : request.file + ": " + message);
  }
  for (const std::string& problem : problems) std::cerr << problem << '\n';
  if (request.json) {
    printJson(request, mesh.triangles.size(), weighed ? &*weighed : nullptr, problems);
  } else if (weighed) {
    printText(request, mesh.triangles.size(), *weighed);
  }
  return weighed ? 0 : 1;
}

}  // namespace carom::cli

// The program `carom`. Exit codes: 0 done, 1 the input is no good, 4 wrong use, 70 a bug of ours.
#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "carom_cli/contact_command.hpp"
#include "carom_cli/mass_command.hpp"

namespace {

constexpr int kWrongUse = 4;
constexpr int kOurBug = 70;  // EX_SOFTWARE of sysexits.h

int run(int argc, char** argv) {
  using carom::cli::MassMethod;
  carom::cli::MassRequest request;

  CLI::App app{"Carom: the collisions of rigid bodies"};
  app.set_version_flag("--version", "carom " CAROM_VERSION);
  app.require_subcommand(1);
  CLI::App* mass = app.add_subcommand("mass", "Weigh the solid inside a mesh file (SI units)");
  mass->add_option("FILE", request.file, "mesh file: .off, .obj, .stl or .ply, in metres")
      ->required();
  mass->add_option("--density", request.density, "[kg/m^3], greater than 0; default 1");
  const std::map<std::string, MassMethod> methods{{"tetrahedra", MassMethod::Tetrahedra},
                                                  {"montecarlo", MassMethod::MonteCarlo},
                                                  {"surface", MassMethod::Surface}};
  std::string method = "tetrahedra";
  mass->add_option("--method", method, "tetrahedra (default), montecarlo or surface")
      ->check(CLI::IsMember({"tetrahedra", "montecarlo", "surface"}));
  mass->add_flag("--json", request.json, "print one JSON object");
  mass->add_flag("--self-intersections,!--no-self-intersections", request.selfIntersections,
                 "look for triangles that cut or touch each other (default: yes; about 2 us each)");

  carom::cli::ContactRequest contactRequest;
  CLI::App* contact = app.add_subcommand(
      "contact", "Whether two solids overlap, how far or deep, and where (SI units)");
  contact->add_option("A", contactRequest.fileA, "mesh file of a convex solid, or of convex parts")
      ->required();
  contact->add_option("B", contactRequest.fileB, "the other mesh file")->required();
  const auto poseOption = [contact](const char* name, std::vector<double>& pose,
                                    const char* whose) {
    contact
        ->add_option(name, pose,
                     std::string("pose of ") + whose +
                         ": x y z [m], or x y z and a quaternion w x y z; default: as in the file")
        ->expected(3, 7)
        ->check(CLI::Number);
  };
  poseOption("--pose", contactRequest.poseB, "B");
  poseOption("--pose-a", contactRequest.poseA, "A");
  contact->add_flag("--json", contactRequest.json, "print one JSON object");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Asking for help or the version is reported the same way, with exit code 0.
    return app.exit(error) == 0 ? 0 : kWrongUse;
  }
  if (*contact) {
    for (const auto* pose : {&contactRequest.poseA, &contactRequest.poseB}) {
      if (!pose->empty() && pose->size() != 3 && pose->size() != 7) {
        std::cerr << "a pose has 3 or 7 numbers, not " << pose->size() << '\n';
        return kWrongUse;
      }
    }
    return carom::cli::runContact(contactRequest);
  }
  if (!(request.density > 0) || !std::isfinite(request.density)) {
    std::cerr << "--density " << request.density << ": must be finite and greater than 0\n";
    return kWrongUse;
  }
  request.method = methods.at(method);
  return carom::cli::runMass(request);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "carom: an error that should not happen: " << error.what() << '\n';
    return kOurBug;
  }
}

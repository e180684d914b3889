// The suite `mass`: what it costs to weigh a mesh, and how exact the answer is.
//
// One run of the program gives everything that is compared: time and error of a row come from the
// same mesh and the same setting. Errors are taken against rational numbers and left out where CGAL
// is not installed.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>

#include "bench/bench.hpp"
#include "bench/mass_methods.hpp"
#include "bench/peers.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/quick_mesh_check.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::MassProperties;
using carom::Matrix3;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector3;
using carom::bench::Case;
using carom::bench::Json;
using carom::bench::keep;
using carom::bench::Options;
using carom::bench::Timing;

namespace {

constexpr Real kDensity = 1;

// A ball with bumps, so that nothing cancels by symmetry; 20 * 4^splits triangles.
TriangleMesh dentedBall(int splits) {
  carom::Random random(41);
  TriangleMesh mesh = carom::icosphereMesh(1, splits);
  for (Vector3& vertex : mesh.vertices) vertex *= random.between(0.8, 1.2);
  return mesh;
}

// Exact in thirds, so that every coordinate of a turned mesh is rounded.
Matrix3 thirdTurn() {
  Matrix3 R;
  R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  return R / 3;
}

struct Method {
  std::string name;
  std::function<MassProperties()> weigh;  // what is timed
};

// The library's seams one after the other: what the chapter explains.
MassProperties plainPasses(const TriangleMesh& mesh) {
  MassProperties body;
  body.volume = carom::signedVolume(mesh);
  body.mass = kDensity * body.volume;
  body.center = carom::centerOfMass(mesh);
  body.inertia = carom::inertiaTensor(mesh, kDensity);
  return body;
}

constexpr const char* kFast = "carom";
constexpr const char* kChecked = "carom, mesh checked";
constexpr const char* kPlain = "carom, the chapter's passes";
constexpr const char* kIgl = "libigl";
constexpr const char* kGather = "gather the corners";
constexpr const char* kCgalInexact = "CGAL, inexact volume";
constexpr const char* kCgalExact = "CGAL, exact volume";

std::vector<Method> methodsFor(const TriangleMesh& mesh) {
  namespace bench = carom::bench;
  std::vector<Method> methods = {
      {"one pass, float", [&mesh] { return bench::onePassFloat(mesh); }},
      {"one pass", [&mesh] { return bench::onePass(mesh); }},
      {"one pass, shifted", [&mesh] { return bench::shiftedPass(mesh); }},
      {"the same, Kahan's sums", [&mesh] { return bench::shiftedKahan(mesh); }},
      {"the same, pairwise sums", [&mesh] { return bench::shiftedPairwise(mesh); }},
      {kPlain, [&mesh] { return plainPasses(mesh); }},
      {kFast, [&mesh] { return carom::massPropertiesOfGoodMesh(mesh, kDensity); }},
      {kChecked, [&mesh] { return carom::massProperties(mesh, kDensity); }}};
#ifdef CAROM_BENCH_LIBIGL
  methods.push_back({kIgl, bench::libiglMoments(mesh)});
#endif
  return methods;
}

struct Row {
  std::string method;
  Timing time;
  std::optional<carom::bench::MassErrors> errors;
};

// Time and error of every method on one mesh.
std::vector<Row> weighInAllWays(const TriangleMesh& mesh, const Options& options) {
  const std::vector<Method> methods = methodsFor(mesh);
  std::vector<Case> cases;
  for (const Method& method : methods) {
    cases.push_back({method.name, mesh.triangles.size(), [&method] { keep(method.weigh()); }});
  }
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
#ifdef CAROM_BENCH_CGAL
  const auto judge = carom::bench::exactJudge(mesh);
#endif
  std::vector<Row> rows;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    rows.push_back({methods[i].name, timings[i], std::nullopt});
#ifdef CAROM_BENCH_CGAL
    rows.back().errors = judge(methods[i].weigh());
#endif
  }
  return rows;
}

Json timeJson(const Timing& time) {
  return {{"ns_per_item", time.median}, {"least", time.least}, {"most", time.most}};
}

// Infinity is not a number of JSON.
Json numberOrNull(Real number) {
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

// One point of the diagrams: a mesh at a distance, or squeezed flat.
struct Setting {
  const char* scene;
  const char* parameter;
  Real value;
  std::vector<Row> rows;
};

std::string power(Real value) {
  return "1e" + std::to_string(static_cast<int>(std::lround(std::log10(value))));
}

void print(const std::vector<Setting>& settings) {
  carom::io::Table table;
  table.column("method").column("ns per triangle", carom::io::fixed(1));
  for (const Setting& setting : settings) {
    table.column(std::string(setting.parameter) + " " + power(setting.value),
                 carom::io::scientific(1));
  }
  for (std::size_t m = 0; m < settings.front().rows.size(); ++m) {
    const Row& first = settings.front().rows[m];
    std::vector<carom::io::Cell> cells = {first.method, first.time.median};
    for (const Setting& setting : settings) {
      const auto& errors = setting.rows[m].errors;
      if (errors) {
        cells.emplace_back(errors->inertia);
      } else {
        cells.emplace_back("-");
      }
    }
    table.row(cells);
  }
  std::cout << "\nRelative error of the inertia, " << settings.front().scene
            << "; time at the first\n\n"
            << table << std::flush;
}

void addRows(Json& rows, const std::vector<Setting>& settings, std::size_t triangles) {
  for (const Setting& setting : settings) {
    for (const Row& row : setting.rows) {
      Json json{{"suite", "mass"},
                {"scene", setting.scene},
                {"engine", row.method},
                {"version", CAROM_VERSION},
                {"threads", 1},
                {"items", triangles},
                {setting.parameter, setting.value}};
      json.update(timeJson(row.time));
      if (row.errors) {
        json["error"] = {{"volume", numberOrNull(row.errors->volume)},
                         {"center", numberOrNull(row.errors->center)},
                         {"inertia", numberOrNull(row.errors->inertia)}};
      }
      rows.push_back(json);
    }
  }
}

// The upper edge of the diagrams: no digit is left there, or less than none.
constexpr Real kTop = 10;
constexpr Real kBottom = 1e-17;
constexpr Real kEdge = 1e-21;  // below the bottom: machine, compiler and flags

Real shown(Real error) {
  return std::isfinite(error) ? std::clamp(error, kBottom, kTop) : kTop;
}

// W6: time against error, one curve per method, one mark per setting.
void drawTimeAgainstError(const std::vector<Setting>& settings, const std::string& title,
                          const std::string& shows, const std::filesystem::path& file) {
  carom::io::Plot plot(title);
  plot.describe(shows).size(980, 560);
  plot.xAxis("time [ns per triangle]", carom::io::Scale::Logarithmic).xRange(1, 1000);
  plot.yAxis("relative error of the inertia", carom::io::Scale::Logarithmic);
  plot.yRange(kEdge, kTop);
  for (std::size_t m = 0; m < settings.front().rows.size(); ++m) {
    std::vector<Real> x, y;
    for (const Setting& setting : settings) {
      x.push_back(setting.rows[m].time.median);
      y.push_back(shown(setting.rows[m].errors->inertia));
    }
    const std::string& name = settings.front().rows[m].method;
    plot.curve(name, x, y, carom::bench::styleOf(m, name == kIgl));
  }
  carom::bench::sign(plot, 1.3, 1e-18, 0.1);
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

// The same errors against the setting, where curves do not hide each other.
void drawError(const std::vector<Setting>& settings, const std::string& title,
               const std::string& axis, const std::string& shows,
               const std::filesystem::path& file) {
  carom::io::Plot plot(title);
  plot.describe(shows).size(980, 560);
  plot.xAxis(axis, carom::io::Scale::Logarithmic);
  plot.yAxis("relative error of the inertia", carom::io::Scale::Logarithmic);
  plot.yRange(kEdge, kTop);
  for (std::size_t m = 0; m < settings.front().rows.size(); ++m) {
    std::vector<Real> x, y;
    for (const Setting& setting : settings) {
      x.push_back(setting.value);
      y.push_back(shown(setting.rows[m].errors->inertia));
    }
    const std::string& name = settings.front().rows[m].method;
    plot.curve(name, x, y, carom::bench::styleOf(m, name == kIgl));
  }
  carom::bench::sign(plot, settings.front().value * 1.5, 1e-18, 0.1);
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

struct Comparison {
  Json rows, ratios;
};

// What is claimed of the library's time, as ratios of medians: at most 4.5 gather passes; the peers
// at least as slow.
Json claims(std::size_t triangles, const std::map<std::string, Real>& ns) {
  const Real ours = ns.at(kFast);
  Json ratios{{"items", triangles}, {"carom_over_gather", ours / ns.at(kGather)}};
  for (const char* peer : {kIgl, kCgalInexact, kCgalExact}) {
    if (ns.contains(peer)) ratios[std::string(peer) + " over carom"] = ns.at(peer) / ours;
  }
  return ratios;
}

// Plain passes, peers and the library on one mesh.
Comparison compare(const TriangleMesh& mesh, [[maybe_unused]] bool withExactKernel,
                   const Options& options) {
  namespace bench = carom::bench;
  const std::size_t n = mesh.triangles.size();
  std::vector<Case> cases = {
      {kGather, n, [&mesh] { keep(bench::gatherCorners(mesh)); }},
      {"volume, the chapter's pass", n, [&mesh] { keep(carom::signedVolume(mesh)); }},
      {"is it clearly good?", n, [&mesh] { keep(carom::isClearlyGood(mesh)); }},
      {"check of the mesh, plain", n, [&mesh] { keep(carom::checkMesh(mesh).size()); }}};
  std::vector<Method> methods = methodsFor(mesh);
  for (const Method& method : methods) {
    cases.push_back({method.name, n, [&method] { keep(method.weigh()); }});
  }
#ifdef CAROM_BENCH_CGAL
  const auto inexact = bench::cgalInexactVolume(mesh);
  cases.push_back({kCgalInexact, n, [&inexact] { keep(inexact()); }});
  std::function<Real()> exact;
  if (withExactKernel) {
    exact = bench::cgalExactVolume(mesh);
    cases.push_back({kCgalExact, n, [&exact] { keep(exact()); }});
  }
#endif
  const std::vector<Timing> timings = bench::measure(cases, options);

  std::map<std::string, Real> ns;
  for (std::size_t i = 0; i < cases.size(); ++i) ns[cases[i].name] = timings[i].median;
  carom::io::Table table;
  table.column("what").column("ns per triangle", carom::io::fixed(2));
  table.column("least", carom::io::fixed(2)).column("most", carom::io::fixed(2));
  table.column("over gather", carom::io::fixed(2)).column("over carom", carom::io::fixed(2));
  Json rows = Json::array();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Timing& t = timings[i];
    table.row(
        {cases[i].name, t.median, t.least, t.most, t.median / ns[kGather], t.median / ns[kFast]});
    Json row{{"suite", "mass"},          {"scene", "dented ball"}, {"engine", cases[i].name},
             {"version", CAROM_VERSION}, {"threads", 1},           {"items", n}};
    row.update(timeJson(t));
    row["over_gather"] = t.median / ns[kGather];
    row["over_carom"] = t.median / ns[kFast];
    rows.push_back(row);
  }
  std::cout << "\nA mesh of " << n << " triangles\n\n" << table << std::flush;
  return {rows, claims(n, ns)};
}

// Root mean square errors of Monte Carlo over four decades of points, and their slope.
Json monteCarlo() {
  const TriangleMesh mesh =
      carom::tetrahedronMesh({0, 0, 0}, {1, 0.2, 0}, {0.1, 1, 0.3}, {0.3, 0.2, 1});
  const MassProperties exact = carom::massProperties(mesh, kDensity);
  constexpr int kSeeds = 64;
  std::vector<Real> points, volumes, inertias;
  Json rows = Json::array();
  carom::io::Table table;
  table.column("points").column("volume", carom::io::scientific(2));
  table.column("inertia", carom::io::scientific(2));
  for (int samples = 100; samples <= 1000000; samples *= 10) {
    Real volume = 0, inertia = 0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      const auto estimate = carom::monteCarloMass(mesh, kDensity, samples, seed);
      volume += std::pow(estimate.body.volume / exact.volume - 1, 2);
      inertia +=
          (estimate.body.inertia - exact.inertia).squaredNorm() / exact.inertia.squaredNorm();
    }
    points.push_back(samples);
    volumes.push_back(std::sqrt(volume / kSeeds));
    inertias.push_back(std::sqrt(inertia / kSeeds));
    table.row({samples, volumes.back(), inertias.back()});
    rows.push_back({{"suite", "mass"},
                    {"scene", "tetrahedron"},
                    {"engine", "Monte Carlo"},
                    {"points", samples},
                    {"seeds", kSeeds},
                    {"error", {{"volume", volumes.back()}, {"inertia", inertias.back()}}}});
  }
  const Real slope = carom::bench::slopeOf(points, volumes);
  const Real inertiaSlope = carom::bench::slopeOf(points, inertias);
  std::cout << "\nMonte Carlo, root mean square error of " << kSeeds << " seeds\n\n"
            << table << "slopes " << slope << " and " << inertiaSlope << ", expected -0.5\n"
            << std::flush;
  return {{"rows", rows}, {"slope_volume", slope}, {"slope_inertia", inertiaSlope}};
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = carom::bench::readOptions(argc, argv);
  Json figures{{"suite", "mass"}, {"circumstances", carom::bench::circumstances(options)}};
#ifdef CAROM_BENCH_LIBIGL
  figures["circumstances"]["libigl_flags"] = CAROM_BENCH_LIBIGL;
#else
  std::cout << "libigl is left out: configure with -DCAROM_LIBIGL_DIR=<clone>\n";
#endif
#ifdef CAROM_BENCH_CGAL
  figures["circumstances"]["cgal"] = CAROM_BENCH_CGAL;
#else
  std::cout << "CGAL is left out, and with it all errors: install libcgal-dev\n";
#endif
  std::cout << carom::bench::circumstancesInALine() << '\n';

  const TriangleMesh ball = dentedBall(4);
  const Comparison small = compare(ball, true, options);
  const Comparison large = compare(dentedBall(8), false, options);
  figures["ratios"] = {small.ratios, large.ratios};
  Json rows = small.rows;
  for (const Json& row : large.rows) rows.push_back(row);

  std::vector<Setting> distances, slivers;
  for (const Real distance : {1.0, 1e2, 1e4, 1e6, 1e8}) {
    const TriangleMesh mesh = carom::translated(ball, distance * Vector3(1, -0.7, 0.4));
    distances.push_back({"moved", "offset", distance, weighInAllWays(mesh, options)});
  }
  print(distances);
  for (const Real aspect : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const Matrix3 flat = Vector3(1, 1, aspect).asDiagonal();
    const TriangleMesh mesh = carom::translated(
        carom::transformed(carom::transformed(ball, flat), thirdTurn()), {0.3, 0.2, 0.1});
    slivers.push_back({"squeezed", "aspect", aspect, weighInAllWays(mesh, options)});
  }
  print(slivers);
  addRows(rows, distances, ball.triangles.size());
  addRows(rows, slivers, ball.triangles.size());
  figures["rows"] = rows;
  figures["monte_carlo"] = monteCarlo();
  carom::bench::writeJson(options, figures);

#ifdef CAROM_BENCH_CGAL
  if (!options.plots.empty()) {
    std::filesystem::create_directories(options.plots);
    drawTimeAgainstError(distances, "Weighing a mesh: time against error, 1 m to 1e8 m away",
                         "Each method is a row of points at about one time; the further up, the "
                         "less exact.",
                         options.plots / "mass_time_error.svg");
    drawTimeAgainstError(slivers,
                         "Weighing a thin solid: time against error, flat to 1e-2 ... 1e-10",
                         "Each method is a row of points; the exact path stays at the bottom.",
                         options.plots / "mass_slivers.svg");
    drawError(distances, "Weighing a mesh far away", "distance from the origin [m]",
              "Errors against the distance of the mesh from the origin.",
              options.plots / "mass_far.svg");
  }
#endif
}

// Group M of the case book: every reference value, to the error that an excellent program reaches.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/mass/box_inertia.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/combine_bodies.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/parallel_axis.hpp"
#include "carom/mass/principal_axes.hpp"
#include "carom/mass/shell_centroid.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom/mass/standard_solids.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kUlp = 2.220446049250313e-16;

TriangleMesh tetrahedron(const json& corners) {
  return tetrahedronMesh(vector(corners[0]), vector(corners[1]), vector(corners[2]),
                         vector(corners[3]));
}

// Both ways of weighing, the plain functions of the chapter and the fast pass, against one
// reference. Over thousands of triangles the plain sums, which are not compensated, are allowed a
// little more.
void checkAgainst(const TriangleMesh& mesh, const json& expected, Real tolerance) {
  const Real plain = mesh.triangles.size() > 1000 ? 1e-14 : tolerance;
  const Real volume = number(expected["volume"]);
  const Vector3 center = vector(expected["center"]);
  const Matrix3 inertia = matrix(expected["inertia"]);
  CHECK(relativeError(signedVolume(mesh), volume) <= plain);
  CHECK((centerOfMass(mesh) - center).norm() <= plain * sizeOf(mesh));
  CHECK(relativeError(inertiaTensor(mesh, 1), inertia) <= plain);
  const MassProperties body = massProperties(mesh, 1);
  CHECK(relativeError(body.volume, volume) <= tolerance);
  CHECK((body.center - center).norm() <= tolerance * sizeOf(mesh));
  CHECK(relativeError(body.inertia, inertia) <= tolerance);
}

}  // namespace

TEST_CASE("M1: a box of twelve triangles is weighed exactly, and equation 18 agrees") {
  const json expected = massCase("M1");
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 2, 3});
  CHECK(signedVolume(box) == number(expected["volume"]));
  CHECK(centerOfMass(box) == vector(expected["center"]));
  CHECK(massProperties(box, 1).volume == number(expected["volume"]));
  CHECK(massProperties(box, 1).center == vector(expected["center"]));
  checkAgainst(box, expected, 2 * kUlp);
  CHECK(boxInertia(6, {1, 2, 3}) == matrix(expected["inertia"]));

  // Half lengths read as full ones: everything a quarter.
  CHECK(boxInertia(6, {0.5, 1, 1.5}) == matrix(expected["inertia"]) / 4);
}

TEST_CASE("M2: Tonon's published tetrahedron, and the products that his matrix swaps") {
  const json expected = massCase("M2");
  const TriangleMesh mesh = tetrahedron(expected["corners"]);
  checkAgainst(mesh, expected, 1e-15);

  const Matrix3 inertia = massProperties(mesh, 1).inertia;
  const Vector3 printed = vector(expected["published"]["diagonal"]);
  CHECK(relativeError(Vector3(inertia.diagonal()), printed) < 2e-8);
  Matrix3 swapped = inertia;
  std::swap(swapped(0, 1), swapped(0, 2));
  CHECK(relativeError(swapped, inertia) > 0.03);
}

TEST_CASE("M3: Mirtich's tetrahedron, and the sign error of early versions of his program") {
  const json expected = massCase("M3");
  const TriangleMesh mesh = tetrahedron(expected["corners"]);
  checkAgainst(mesh, expected, 2 * kUlp);

  // About the corner at the origin: I = trace(C) E - C of the published second moments.
  const Matrix3 C = matrix(expected["second_moments"]);
  const Matrix3 about = C.trace() * Matrix3::Identity() - C;
  const MassProperties body = massProperties(mesh, 1);
  CHECK(relativeError(parallelAxis(body.inertia, body.mass, body.center), about) <= 2 * kUlp);
  CHECK((body.mass * body.center - vector(expected["first_moments"])).norm() <= 1e-14);
  const Real wrong = -(C(0, 1) + body.mass * body.center.x() * body.center.y());
  CHECK(wrong == number(expected["wrong"]["Ixy_with_sign_error"]));
}

TEST_CASE("M4: a regular tetrahedron has a spherical tensor, and its axes are left alone") {
  const json expected = massCase("M4");
  const TriangleMesh mesh = tetrahedron(expected["corners"]);
  checkAgainst(mesh, expected, kUlp);
  CHECK(principalAxes(massProperties(mesh, 1).inertia).axes == Matrix3::Identity());
  CHECK(principalAxes(inertiaTensor(mesh, 1)).axes == Matrix3::Identity());
}

TEST_CASE("M5: an ellipsoid mesh has its own exact moments, and tends to the smooth one") {
  const json expected = massCase("M5");
  const Real smooth = number(expected["smooth"]["volume"]);
  CHECK(relativeError(solidEllipsoid({3, 2, 1}, 1).volume, smooth) <= 2 * kUlp);
  CHECK(relativeError(Vector3(solidEllipsoid({3, 2, 1}, 1).inertia.diagonal()),
                      vector(expected["smooth"]["diagonal"])) <= 2 * kUlp);

  std::vector<Real> missing;
  for (const int rings : {8, 16, 32}) {
    const json& mine = expected["rings"][std::to_string(rings)];
    const TriangleMesh mesh = snapToGrid(ellipsoidMesh({3, 2, 1}, rings), 1.0 / (1 << 20));
    REQUIRE(mesh.triangles.size() == mine["triangles"].get<std::size_t>());
    checkAgainst(mesh, mine, 2e-15);
    missing.push_back(smooth - massProperties(mesh, 1).volume);
  }
  CHECK(std::log2(missing[0] / missing[1]) == Approx(number(expected["order"][0])).epsilon(1e-9));
  CHECK(std::log2(missing[1] / missing[2]) == Approx(number(expected["order"][1])).epsilon(1e-9));
}

TEST_CASE("M6: a torus is not convex and has a hole") {
  const json expected = massCase("M6");
  for (const json& mine : expected["meshes"]) {
    const TriangleMesh mesh =
        snapToGrid(torusMesh(2, 0.5, mine["around"], mine["across"]), 1.0 / (1 << 20));
    checkAgainst(mesh, mine, 2e-15);
  }
  const MassProperties smooth = solidTorus(2, 0.5, 1);
  CHECK(relativeError(smooth.volume, number(expected["smooth"]["volume"])) <= 2 * kUlp);
  CHECK(relativeError(Vector3(smooth.inertia.diagonal()), vector(expected["smooth"]["diagonal"])) <=
        2 * kUlp);
  CHECK(number(expected["wrong"]["convex_hull_volume"]) > 1.8 * smooth.volume);
}

TEST_CASE("M7: a box far from the origin keeps every digit of its inertia") {
  const json expected = massCase("M7");
  const Matrix3 inertia = matrix(expected["inertia"]);
  for (int power = 0; power <= 8; ++power) {
    const Real T = std::pow(10.0, power);
    const Vector3 corner = Vector3::Constant(T);
    const TriangleMesh box = boxMesh(corner, corner + Vector3(1, 0.5, 0.25));
    INFO("T = 1e" << power);
    CHECK(relativeError(inertiaTensor(box, 1), inertia) <= 1e-15);
    CHECK(relativeError(massProperties(box, 1).inertia, inertia) <= 1e-15);
    CHECK(signedVolume(box) == number(expected["volume"]));
    CHECK(massProperties(box, 1).volume == number(expected["volume"]));
    CHECK(centerOfMass(box) - corner == vector(expected["center"]));
    CHECK(massProperties(box, 1).center - corner == vector(expected["center"]));
  }
}

TEST_CASE("M7: taken about the world's origin, the same sums lose the inertia altogether") {
  const json expected = massCase("M7");
  const Matrix3 inertia = matrix(expected["inertia"]);
  const auto error = [&](Real T) {
    const Vector3 corner = Vector3::Constant(T);
    return relativeError(
        weighAboutWorldOrigin(boxMesh(corner, corner + Vector3(1, 0.5, 0.25))).inertia, inertia);
  };
  CHECK(error(1e2) > 1e-13);
  CHECK(error(1e4) > 1e-9);
  CHECK(error(1e6) > 1);
}

TEST_CASE("M8: a plate thinner than a billionth of its width is weighed to the last digits") {
  const json expected = massCase("M8");
  const TriangleMesh flat = boxMesh({0, 0, 0}, {1, 1, std::ldexp(1.0, -30)});
  checkAgainst(flat, expected["axis_aligned"], 1e-15);

  const json& mine = expected["turned"];
  TriangleMesh turned;
  for (const json& vertex : mine["vertices"]) turned.vertices.push_back(vector(vertex));
  for (const json& triangle : mine["triangles"]) turned.triangles.push_back(triangle);
  const MassProperties body = massProperties(turned, 1);
  CHECK(relativeError(body.volume, number(mine["volume"])) <= 1e-15);
  CHECK((body.center - vector(mine["center"])).norm() <= 1e-15);
  CHECK(relativeError(body.inertia, matrix(mine["inertia"])) <= 1e-15);

  // What a pass in double can promise: seven digits, the plain function as little as the others.
  CHECK(relativeError(signedVolume(turned), number(mine["volume"])) < 1e-6);
  CHECK(relativeError(weighAboutWorldOrigin(turned).volume, number(mine["volume"])) > 1e-8);
}

TEST_CASE("M9: a box inside out has negative volume, is refused, and is right once reversed") {
  const json expected = massCase("M9");
  const TriangleMesh flipped = reversed(boxMesh({0, 0, 0}, {1, 2, 3}));
  CHECK(signedVolume(flipped) == number(expected["volume"]));
  CHECK(centerOfMass(flipped) == vector(expected["center"]));
  CHECK(relativeError(inertiaTensor(flipped, 1), matrix(expected["inertia"])) <= 2 * kUlp);
  CHECK_THROWS_AS(massProperties(flipped, 1), InvalidInput);
  checkAgainst(reversed(flipped), massCase("M1"), 2 * kUlp);

  // Volumes without their signs hide that the mesh is inside out.
  const TriangleMesh right = reversed(flipped);
  const auto unsignedVolume = [](const TriangleMesh& mesh, const Vector3& origin) {
    Real volume = 0;
    for (const auto& triangle : mesh.triangles) {
      const auto [a, b, c] = cornersOf(mesh, triangle);
      volume += std::abs((a - origin).dot(cross(b - a, c - a))) / 6;
    }
    return volume;
  };
  CHECK(unsignedVolume(flipped, {0, 0, 0}) == unsignedVolume(right, {0, 0, 0}));
  CHECK(unsignedVolume(right, {9, 9, 9}) > 9 * signedVolume(right));
}

TEST_CASE(
    "M10: a cube without its last triangle is refused, and the reason is that its volume depends "
    "on the origin") {
  const json expected = massCase("M10");
  TriangleMesh open = boxMesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();

  Vector3 areaVector = Vector3::Zero();
  for (const auto& triangle : open.triangles) {
    const auto [a, b, c] = cornersOf(open, triangle);
    areaVector += cross(b - a, c - a) / 2;
  }
  CHECK(areaVector == vector(expected["area_vector"]));
  for (const json& silent : expected["silent_volumes"]) {
    const TriangleMesh moved = translated(open, -vector(silent["origin"]));
    CHECK(relativeError(weighAboutWorldOrigin(moved).volume, number(silent["volume"])) < 1e-14);
  }

  const auto problems = checkMesh(open);
  REQUIRE(problems.size() == 3);
  for (const MeshProblem& problem : problems) CHECK(problem.kind == MeshProblemKind::openEdge);
  CHECK_THROWS_AS(massProperties(open, 1), InvalidInput);
}

TEST_CASE("M11: hollow solids, by a reversed inner skin and in closed form") {
  const json expected = massCase("M11");
  const TriangleMesh outer = boxMesh({-1, -1, -1}, {1, 1, 1});
  const TriangleMesh inner = boxMesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  checkAgainst(joined(outer, reversed(inner)), expected["cube"], 1e-15);
  CHECK(signedVolume(joined(outer, inner)) ==
        number(expected["wrong"]["volume_without_reversing"]));

  const json& ball = expected["ball"];
  const MassProperties hollow = hollowBall(0.9, 1, 1);
  CHECK(relativeError(hollow.volume, number(ball["volume"])) <= 1e-15);
  CHECK(relativeError(hollow.inertia(0, 0) / hollow.mass, number(ball["inertia_per_mass"])) <=
        1e-15);
  const MassProperties thin = hollowBall(1 - 1e-12, 1, 1);
  CHECK(relativeError(thin.inertia(2, 2) / thin.mass, number(ball["thin_inertia_per_mass"])) <
        1e-11);
  const MassProperties solid = hollowBall(0, 1, 1);
  CHECK(relativeError(solid.inertia(1, 1) / solid.mass, number(ball["solid_inertia_per_mass"])) <=
        1e-15);

  // The same by subtraction: a hole is a part of negative mass.
  MassProperties hole = solidBall(0.9, 1);
  hole.volume = -hole.volume;
  hole.mass = -hole.mass;
  hole.inertia = -hole.inertia;
  const MassProperties drilled = combineBodies(std::array{solidBall(1, 1), hole});
  CHECK(relativeError(drilled.inertia, hollow.inertia) < 1e-14);
}

TEST_CASE("M12: the mean of the triangles is the centre of the shell, not of the solid") {
  const json expected = massCase("M12");

  const json& tetra = expected["tetrahedron"];
  const TriangleMesh mesh = tetrahedron(tetra["corners"]);
  CHECK((shellCentroid(mesh) - vector(tetra["surface"])).norm() <= 1e-15);
  CHECK((centerOfMass(mesh) - vector(tetra["solid"])).norm() <= 1e-15);

  // Round bodies approach the closed forms as the square of the step.
  const std::vector<Vector2> coneProfile{{0, 0}, {1, 0}, {0, 1}};
  const TriangleMesh cone = latheMesh(coneProfile, 2000);
  CHECK_THAT(centerOfMass(cone).z(), WithinAbs(number(expected["cone"]["solid"]), 1e-12));
  CHECK_THAT(shellCentroid(cone).z(), WithinAbs(number(expected["cone"]["surface"]), 1e-6));

  std::vector<Vector2> dome{{0, 0}};
  const int steps = 500;
  for (int i = 0; i <= steps; ++i) {
    const Real angle = std::numbers::pi / 2 * i / steps;
    dome.emplace_back(i == steps ? 0 : std::cos(angle), std::sin(angle));
  }
  TriangleMesh half = latheMesh(dome, 1000);
  const json& ball = expected["half_ball"];
  CHECK_THAT(centerOfMass(half).z(), WithinAbs(number(ball["solid"]), 1e-5));
  CHECK_THAT(shellCentroid(half).z(), WithinAbs(number(ball["surface"]), 1e-5));
  half.triangles.erase(half.triangles.begin(), half.triangles.begin() + 1000);  // the flat side
  CHECK_THAT(shellCentroid(half).z(), WithinAbs(number(ball["open_shell"]), 1e-5));
}

TEST_CASE("M13: the spread of Monte Carlo over a hundred seeds is what statistics says") {
  const json expected = massCase("M13");
  // A ball of 320 triangles fills its bounding cube a little less than the smooth one; its own
  // share is known.
  const TriangleMesh ball = icosphereMesh(1, 2);
  const Real exact = signedVolume(ball);
  const int samples = 2500;
  const int seeds = 100;
  Real sum = 0;
  Real squares = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Real error =
        monteCarloMass(ball, 1, samples, static_cast<std::uint64_t>(seed)).body.volume / exact - 1;
    sum += error;
    squares += error * error;
  }
  const Real spread = std::sqrt((squares - sum * sum / seeds) / (seeds - 1));
  Vector3 low = ball.vertices.front();
  Vector3 high = low;
  for (const Vector3& v : ball.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Real p = exact / (high - low).prod();
  CHECK_THAT(spread, WithinRel(std::sqrt((1 - p) / (p * samples)), 0.2));

  // The formula itself, with p = pi/6 for the smooth ball.
  const Real q = std::numbers::pi / 6;
  CHECK_THAT(std::sqrt((1 - q) / (q * 1e4)), WithinRel(number(expected["at_1e4"]), 1e-14));
  CHECK_THAT(std::sqrt((1 - q) / (q * 1e6)), WithinRel(number(expected["at_1e6"]), 1e-14));
  CHECK_THAT((1 - q) / q * 1e12, WithinRel(number(expected["samples_for_1e_minus_6"]), 1e-11));
  const MonteCarloMass once = monteCarloMass(ball, 1, 10000, 7);
  CHECK_THAT(once.relativeError, WithinRel(number(expected["at_1e4"]), 0.1));
}

TEST_CASE("M14: Pacman from two halves needs Steiner's term") {
  const json expected = massCase("M14");
  const json& half = expected["half"];
  // A flat disc sector as a body of unit thickness: only the moment about z counts.
  const Real turn =
      75 * std::numbers::pi / 180;  // from the axis of symmetry to the middle of a half
  const Real distance = number(half["center_distance"]);
  MassProperties upper;
  upper.volume = upper.mass = number(half["area"]);
  upper.center = {distance * std::cos(turn), distance * std::sin(turn), 0};
  upper.inertia(2, 2) = number(half["inertia"]);
  MassProperties lower = upper;
  lower.center.y() = -upper.center.y();

  const MassProperties pacman = combineBodies(std::array{upper, lower});
  CHECK(relativeError(pacman.mass, number(expected["area"])) <= 1e-15);
  CHECK_THAT(pacman.center.x(), WithinRel(number(expected["center"]), 1e-15));
  CHECK_THAT(pacman.center.y(), WithinAbs(0, 1e-16));
  CHECK(relativeError(pacman.inertia(2, 2), number(expected["inertia"])) <= 1e-15);
  CHECK_THAT(upper.inertia(2, 2) + lower.inertia(2, 2),
             WithinRel(number(expected["wrong"]["sum_without_steiner"]), 1e-15));

  // A polygon in place of the arc is second order in its step.
  const auto polygonError = [&](int steps) {
    std::vector<Vector2> outline;
    for (int i = 0; i <= steps; ++i) {
      const Real angle = 150 * std::numbers::pi / 180 * i / steps;
      outline.emplace_back(std::cos(angle), std::sin(angle));
    }
    TriangleMesh fan;  // the sector as a prism of height 1 over the fan from the origin
    fan.vertices = {{0, 0, 0}, {0, 0, 1}};
    for (const Vector2& corner : outline) {
      fan.vertices.emplace_back(corner.x(), corner.y(), 0);
      fan.vertices.emplace_back(corner.x(), corner.y(), 1);
    }
    for (int i = 0; i < steps; ++i) {
      const int p = 2 + 2 * i;
      const int q = p + 2;
      fan.triangles.insert(fan.triangles.end(),
                           {{0, q, p}, {1, p + 1, q + 1}, {p, q, q + 1}, {p, q + 1, p + 1}});
    }
    const int last = 2 + 2 * steps;
    fan.triangles.insert(fan.triangles.end(),
                         {{0, 2, 3}, {0, 3, 1}, {0, 1, last + 1}, {0, last + 1, last}});
    return relativeError(massProperties(fan, 1).inertia(2, 2), number(half["inertia"]));
  };
  CHECK_THAT(std::log2(polygonError(20) / polygonError(40)), WithinAbs(2, 0.02));
}

TEST_CASE("M15: a box about its corner, as a tensor and not as a scalar") {
  const json expected = massCase("M15");
  const Matrix3 center = matrix(massCase("M1")["inertia"]);
  const Vector3 d = vector(expected["offset"]);
  const Real m = number(expected["mass"]);
  CHECK(relativeError(parallelAxis(center, m, d), matrix(expected["inertia"])) <= kUlp);
  CHECK(parallelAxis(center, m, -d) == parallelAxis(center, m, d));

  const Matrix3 scalar = center + m * d.dot(d) * Matrix3::Identity();
  CHECK(Vector3(scalar.diagonal()) == vector(expected["wrong"]["scalar_diagonal"]));
  CHECK((scalar - matrix(expected["inertia"])).cwiseAbs().maxCoeff() == 13.5);
}

TEST_CASE("M16: principal axes of a nearly symmetric tensor keep all digits") {
  const json expected = massCase("M16");
  const Matrix3 tensor = matrix(expected["tensor"]);
  const PrincipalAxes axes = principalAxes(tensor);
  CHECK((axes.moments - vector(expected["moments"])).cwiseAbs().maxCoeff() <= 4e-16);
  const Matrix3 again = axes.axes * axes.moments.asDiagonal() * axes.axes.transpose();
  CHECK((again - tensor).cwiseAbs().maxCoeff() <= 1e-15);
  const Vector3 largest = axes.axes.col(2);
  const Vector3 known = vector(expected["axis_of_largest"]);
  CHECK((largest - std::copysign(1.0, largest.dot(known)) * known).norm() <= 1e-15);
  CHECK_THAT(cross(axes.axes.col(0), axes.axes.col(1)).dot(axes.axes.col(2)), WithinAbs(1, 1e-15));

  // The closed form with an arccosine loses half the digits.
  const Real q = tensor.trace() / 3;
  const Matrix3 B = tensor - q * Matrix3::Identity();
  const Real p = std::sqrt(B.squaredNorm() / 6);
  const Real det = cross(B.col(0), B.col(1)).dot(B.col(2)) / (p * p * p);
  const Real angle = std::acos(std::min(1.0, std::max(-1.0, det / 2))) / 3;
  const Real smallest = q + 2 * p * std::cos(angle + 2 * std::numbers::pi / 3);
  CHECK(std::abs(smallest - 1) > 1e-14);
}

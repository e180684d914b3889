// Grader of 02.check_mesh: good meshes that are spoilt in one way each, so that what is wrong is
// known. How the sentences are worded is not graded.

#include "carom/mass/check_mesh.hpp"

#include <algorithm>
#include <limits>

#include "carom/mass/meshes.hpp"
#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "the list of problems, neither more nor less";

// The problems as words, so that a message can be read: "open edge 0-1 of triangle 3".
std::vector<std::string> inWords(const std::vector<MeshProblem>& problems) {
  static const char* const names[] = {
      "empty",     "not a number",      "index out of range", "degenerate triangle",
      "open edge", "non-manifold edge", "partly flipped",     "flipped"};
  std::vector<std::string> words;
  for (const MeshProblem& problem : problems) {
    const auto kind = static_cast<std::size_t>(problem.kind);
    std::string text = kind < std::size(names) ? names[kind] : "unknown kind";
    if (problem.vertex >= 0) text += " at vertex " + std::to_string(problem.vertex);
    if (problem.edge[0] >= 0)
      text += " " + std::to_string(problem.edge[0]) + "-" + std::to_string(problem.edge[1]);
    if (problem.triangle >= 0) text += " of triangle " + std::to_string(problem.triangle);
    words.push_back(text);
  }
  return words;
}

using Words = std::vector<std::string>;

// Corners 0 to 3; triangles (0,2,1), (0,1,3), (1,2,3), (2,0,3).
TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

// Two tetrahedra that share the edge 0-1 and nothing else: four triangles meet there.
TriangleMesh glued() {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.push_back({0, -1, 0});
  mesh.vertices.push_back({0, 0, -1});
  mesh.triangles.insert(mesh.triangles.end(), {{0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}});
  return mesh;
}

// A triangle that sticks out of the edge 0-1.
TriangleMesh fin() {
  TriangleMesh mesh = tetrahedron();
  mesh.vertices.push_back({0.5, -1, -1});
  mesh.triangles.push_back({0, 1, 4});
  return mesh;
}

TriangleMesh without(TriangleMesh mesh, std::size_t triangle) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
  return mesh;
}

TriangleMesh withReversed(TriangleMesh mesh, std::size_t triangle) {
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
  return mesh;
}

// The three edges of a triangle, as a problem of one kind each, in ascending order.
Words edgesOf(const char* kind, const TriangleMesh& mesh, std::size_t triangle) {
  std::vector<std::array<std::int32_t, 2>> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t p = mesh.triangles[triangle][k];
    const std::int32_t q = mesh.triangles[triangle][(k + 1) % 3];
    edges.push_back({std::min(p, q), std::max(p, q)});
  }
  std::sort(edges.begin(), edges.end());
  Words words;
  for (const auto& edge : edges) {
    words.push_back(std::string(kind) + " " + std::to_string(edge[0]) + "-" +
                    std::to_string(edge[1]));
  }
  return words;
}

// Kind and edge without the triangle.
Words withoutTriangle(const std::vector<MeshProblem>& problems) {
  Words words = inWords(problems);
  for (std::string& text : words) text = text.substr(0, text.find(" of "));
  return words;
}

}  // namespace

TEST_CASE("open") {
  GRADE(inWords(checkMesh(without(tetrahedron(), 3))),
        (Words{"open edge 0-2 of triangle 0", "open edge 0-3 of triangle 1",
               "open edge 2-3 of triangle 2"}),
        within(0, kExact), given("mesh", "a tetrahedron without its last triangle (2,0,3)"),
        given("triangles", without(tetrahedron(), 3).triangles));
  Random random(seed());
  const TriangleMesh ball = icosphereMesh(1, 1);
  for (int n = 0; n < 5; ++n) {
    const auto t = static_cast<std::size_t>(random.integer(0, 79));
    GRADE(withoutTriangle(checkMesh(without(ball, t))), edgesOf("open edge", ball, t),
          within(0, kExact), given("mesh", "a ball of 80 triangles"),
          given("taken away is triangle", ball.triangles[t]));
  }
}

TEST_CASE("good") {
  GRADE(inWords(checkMesh(tetrahedron())), Words{}, within(0, kExact),
        given("mesh", "a tetrahedron"), given("triangles", tetrahedron().triangles));
  GRADE(inWords(checkMesh(torusMesh(2, 0.5, 8, 6))), Words{}, within(0, kExact),
        given("mesh", "a ring of 96 triangles"));
  const TriangleMesh hollow =
      joined(boxMesh({-2, -2, -2}, {2, 2, 2}), reversed(boxMesh({-1, -1, -1}, {1, 1, 1})));
  GRADE(inWords(checkMesh(hollow)), Words{}, within(0, kExact),
        given("mesh", "a cube with a hollow"));
  // To find nothing anywhere would be right so far.
  GRADE(checkMesh(without(torusMesh(2, 0.5, 8, 6), 40)).size(), std::size_t(3), within(0, kExact),
        given("mesh", "a ring with one triangle missing"), about("the number of problems"));
}

TEST_CASE("crowded") {
  GRADE(inWords(checkMesh(glued())), Words{"non-manifold edge 0-1 of triangle 0"},
        within(0, kExact), given("mesh", "two tetrahedra that share one edge"),
        given("triangles", glued().triangles));
  GRADE(inWords(checkMesh(fin())),
        (Words{"non-manifold edge 0-1 of triangle 0", "open edge 0-4 of triangle 4",
               "open edge 1-4 of triangle 4"}),
        within(0, kExact), given("mesh", "a tetrahedron with a triangle sticking out of an edge"),
        given("triangles", fin().triangles));
}

TEST_CASE("flipped_patch") {
  GRADE(inWords(checkMesh(withReversed(tetrahedron(), 2))),
        (Words{"partly flipped 1-2 of triangle 0", "partly flipped 1-3 of triangle 1",
               "partly flipped 2-3 of triangle 2"}),
        within(0, kExact), given("mesh", "a tetrahedron whose triangle 2 looks inwards"),
        given("triangles", withReversed(tetrahedron(), 2).triangles));
  Random random(seed());
  const TriangleMesh ball = icosphereMesh(1, 1);
  for (int n = 0; n < 5; ++n) {
    const auto t = static_cast<std::size_t>(random.integer(0, 79));
    GRADE(withoutTriangle(checkMesh(withReversed(ball, t))), edgesOf("partly flipped", ball, t),
          within(0, kExact), given("mesh", "a ball of 80 triangles"),
          given("reversed is triangle", ball.triangles[t]));
  }
}

TEST_CASE("inside_out") {
  GRADE(inWords(checkMesh(reversed(tetrahedron()))), Words{"flipped"}, within(0, kExact),
        given("mesh", "a tetrahedron, every triangle reversed"),
        given("triangles", reversed(tetrahedron()).triangles));
  GRADE(inWords(checkMesh(translated(reversed(boxMesh({0, 0, 0}, {1, 2, 3})), {5, -7, 9}))),
        Words{"flipped"}, within(0, kExact),
        given("mesh", "a box away from the origin, every triangle reversed"));
}

TEST_CASE("numbers") {
  GRADE(inWords(checkMesh({})), Words{"empty"}, within(0, kExact),
        given("mesh", "no triangles at all"));
  TriangleMesh bad = tetrahedron();
  bad.vertices[2].x() = std::numeric_limits<Real>::quiet_NaN();
  GRADE(inWords(checkMesh(bad)), Words{"not a number at vertex 2"}, within(0, kExact),
        given("mesh", "a tetrahedron whose vertex 2 is not a number"));
  bad = tetrahedron();
  bad.triangles[1][2] = 4;
  GRADE(inWords(checkMesh(bad)), Words{"index out of range of triangle 1"}, within(0, kExact),
        given("mesh", "a tetrahedron, 4 vertices, whose triangle 1 names vertex 4"));
  bad = tetrahedron();
  bad.triangles[0][2] = 2;
  GRADE(inWords(checkMesh(bad)), Words{"degenerate triangle of triangle 0"}, within(0, kExact),
        given("mesh", "a tetrahedron whose triangle 0 is (0,2,2)"));
}

PROBES() {
  Random random(33);
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 2, 3});
  for (int n = 0; n < 5; ++n) {
    const auto t = static_cast<std::size_t>(random.integer(0, 11));
    PROBE(checkMesh(without(box, t)));
    PROBE(checkMesh(withReversed(box, t)));
  }
  PROBE(checkMesh(box));
  PROBE(checkMesh(tetrahedron()));
  PROBE(checkMesh(reversed(box)));
  PROBE(checkMesh(reversed(tetrahedron())));
  PROBE(checkMesh(glued()));
  PROBE(checkMesh(fin()));
}

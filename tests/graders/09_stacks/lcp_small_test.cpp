// Grader of 09.lcp_small: problems that are made from their answers.

#include "carom/solver/lcp_small.hpp"

#include <cmath>

#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Reals = std::vector<Real>;

// A positive definite matrix, row after row, and speeds for which the answer is known: where it
// pushes the speed afterwards is zero, elsewhere it is what is said.
struct Known {
  Reals matrix, speeds, impulses;
};

Known knownProblem(const Reals& matrix, const Reals& impulses, const Reals& speedsAfter) {
  const std::size_t n = impulses.size();
  Known known{matrix, speedsAfter, impulses};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) known.speeds[i] -= matrix[i * n + j] * impulses[j];
  }
  return known;
}

Known anyProblem(Random& random, std::size_t n, int pushing) {
  Reals g(n * n), matrix(n * n, 0), impulses(n, 0), after(n, 0);
  for (Real& x : g) x = random.between(-1, 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) matrix[i * n + j] += g[i * n + k] * g[j * n + k];
    }
    matrix[i * n + i] += 0.3;
    const bool pushes = static_cast<int>(i) % 3 < pushing;
    (pushes ? impulses : after)[i] = random.between(0.2, 2);
  }
  return knownProblem(matrix, impulses, after);
}

void ask(const Known& known, const char* what) {
  GRADE(lcpSmall(known.matrix, known.speeds), known.impulses,
        withinRelative(1e-8, "elimination of a few rows"), given("matrix", known.matrix, "1/kg"),
        given("speeds", known.speeds, "m/s"), unit("N s"), about(what));
}

}  // namespace

TEST_CASE("all_push") {
  ask(knownProblem({1, -1, -1, 2}, {2, 1}, {0, 0}), "two boxes of 1 kg on the ground");
  ask(knownProblem({1, -1, 0, -1, 2, -1, 0, -1, 2}, {3, 2, 1}, {0, 0, 0}),
      "three boxes of 1 kg on the ground");
  Random random(seed());
  ask(anyProblem(random, 4, 3), "four rows, of which all push");
}

TEST_CASE("some") {
  // A bar on two feet that turns fast: one foot parts. 1 kg, 1 m: A = (4, -2; -2, 4).
  ask(knownProblem({4, -2, -2, 4}, {0.5, 0}, {0, 2}), "a bar of 1 kg lands on one of its feet");
  // A push on the first makes the second approach that had parted slowly.
  ask(knownProblem({2, -1.5, -1.5, 2}, {1, 0.6}, {0, 0}), "a push wakes a neighbour");
  ask(knownProblem({2, 1.5, 1.5, 2}, {1, 0}, {0, 0.5}), "one push is enough for two");
}

TEST_CASE("back") {
  // Stopped all together, rows that have to push pull; let go, they would be missed.
  ask(knownProblem({2, -1, 1, -1, 2, -1.5, 1, -1.5, 2}, {1, 0.2, 0}, {0, 0, 2}),
      "three rows: the second one is needed after all");
  ask(knownProblem({2, 0.5, -1, 0.5, 2, -0.5, -1, -0.5, 2}, {0.5, 0.2, 0}, {0, 0, 2}),
      "three rows: the first one is needed after all");
}

TEST_CASE("crowd") {
  Random random(seed() + 1);
  for (int n = 0; n < 4; ++n) {
    ask(anyProblem(random, 6, 1 + n % 2), "six rows, of which some push");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(lcpSmall(Reals{0}, Reals{-1}), given("matrix", Reals{0}, "1/kg"),
                given("speeds", Reals{-1}, "m/s"));
}

PROBES() {
  Random random(930);
  for (int n = 0; n < 20; ++n) {
    const Known known = anyProblem(random, 3 + static_cast<std::size_t>(n % 3), 1 + n % 3);
    PROBE(lcpSmall(known.matrix, known.speeds));
  }
  const Known back = knownProblem({2, -1, 1, -1, 2, -1.5, 1, -1.5, 2}, {1, 0.2, 0}, {0, 0, 2});
  PROBE(lcpSmall(back.matrix, back.speeds));
  PROBE(lcpSmall(knownProblem({2, -1.5, -1.5, 2}, {1, 0.6}, {0, 0}).matrix,
                 knownProblem({2, -1.5, -1.5, 2}, {1, 0.6}, {0, 0}).speeds));
}

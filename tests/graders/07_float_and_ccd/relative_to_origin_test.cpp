// Grader of 07.relative_to_origin: two bodies are made from the vector between them, in multiples
// of 2^-20 m, so that the answer is known exactly.

#include "carom/precision/relative_to_origin.hpp"

#include <cmath>

#include "carom/core/random.hpp"
#include "grading/fields_precision.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "differences of small numbers; only the last addition rounds";

struct Pair {
  CellPosition body, origin;
  Vector3 between;
};

Real fine(Random& random, Real size) {
  return std::round(random.between(-size, size) * 0x1p20) * 0x1p-20;
}

// An origin in a cell up to `reach` away, and a body a few cells from it.
Pair anyPair(Random& random, std::int64_t reach, int cellsApart) {
  Pair pair;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int apart = random.integer(-cellsApart, cellsApart);
    const auto far = static_cast<std::int64_t>(static_cast<Real>(reach) * random.between(0.5, 1));
    pair.origin.cell[k] = random.integer(0, 1) ? far : -far;
    pair.body.cell[k] = pair.origin.cell[k] + apart;
    pair.origin.offset(i) = fine(random, 512);
    pair.body.offset(i) = fine(random, 512);
    pair.between(i) = 1024.0 * apart + pair.body.offset(i) - pair.origin.offset(i);
  }
  return pair;
}

void ask(const Pair& pair, const char* what) {
  GRADE(relativeToOrigin(pair.body, pair.origin), pair.between, within(1e-12, kExact),
        given("position", pair.body), given("origin", pair.origin), unit("m"), about(what));
}

}  // namespace

TEST_CASE("same") {
  CellPosition body, origin;
  body.offset = {3, 2, 1};
  origin.offset = {1, 1, 1};
  GRADE(relativeToOrigin(body, origin), Vector3(2, 1, 0), within(0, kExact),
        given("position", body), given("origin", origin), unit("m"),
        about("both in the first cell"));
  Random random(seed());
  for (int n = 0; n < 4; ++n) ask(anyPair(random, 100, 0), "both in one cell");
}

TEST_CASE("neighbours") {
  Random random(seed() + 1);
  for (int n = 0; n < 8; ++n) {
    Pair pair = anyPair(random, 100, 2);
    pair.body.cell[0] += 3;  // not the same one, in any case
    pair.between.x() += 3072;
    ask(pair, "a few cells apart");
  }
}

TEST_CASE("far") {
  Random random(seed() + 2);
  for (int n = 0; n < 8; ++n) {
    ask(anyPair(random, 4000000000000, 1), "near each other, in cells very far away");
  }
}

PROBES() {
  Random random(705);
  for (int n = 0; n < 16; ++n) {
    const Pair pair = anyPair(random, 4000000000000, 2);
    PROBE(relativeToOrigin(pair.body, pair.origin));
  }
}

// Grader of 10.lanes_solver: rows solved one by one are the judge, to the last bit.

#include "lanes_solver.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "grading/grade.hpp"
#include "speed_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Reals = std::vector<Real>;
using Speeds = std::vector<BodySpeeds>;
using Rows = std::vector<PlainRow>;
using Blocks = std::vector<RowBlock>;

constexpr const char* kBits = "the same sums in the same order";
const Real kNone = std::numeric_limits<Real>::quiet_NaN();

PlainRow randomRow(Random& random, std::int32_t a, std::int32_t b) {
  PlainRow row;
  row.bodyA = a;
  row.bodyB = b;
  Real squared = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    row.alongA[i] = random.between(-1, 1);
    row.alongB[i] = random.between(-1, 1);
    const Real lightA = random.between(0.2, 2), lightB = random.between(0.2, 2);
    row.changeA[i] = lightA * row.alongA[i];
    row.changeB[i] = lightB * row.alongB[i];
    if (a != kNobody) squared += row.alongA[i] * row.changeA[i];
    if (b != kNobody) squared += row.alongB[i] * row.changeB[i];
  }
  row.mass = 1 / squared;
  row.target = random.between(-0.2, 0.2);
  return row;
}

Speeds randomSpeeds(Random& random, int count) {
  Speeds speeds(static_cast<std::size_t>(count));
  for (BodySpeeds& body : speeds) {
    for (Real& x : body.x) x = random.between(-1, 1);
  }
  return speeds;
}

// Rows side by side, four to a block; empty lanes are filled with a number.
Blocks blocksOf(const Rows& rows, Real filling = 0) {
  Blocks blocks((rows.size() + 3) / 4);
  for (std::size_t r = 0; r < 4 * blocks.size(); ++r) {
    RowBlock& block = blocks[r / 4];
    const std::size_t k = r % 4;
    PlainRow row;
    if (r < rows.size()) {
      row = rows[r];
    } else {
      row.mass = row.target = row.impulse = filling;
      row.alongA.fill(filling);
      row.alongB.fill(filling);
      row.changeA.fill(filling);
      row.changeB.fill(filling);
    }
    block.bodyA[k] = row.bodyA;
    block.bodyB[k] = row.bodyB;
    for (std::size_t i = 0; i < 6; ++i) {
      block.alongA[i].x[k] = row.alongA[i];
      block.alongB[i].x[k] = row.alongB[i];
      block.changeA[i].x[k] = row.changeA[i];
      block.changeB[i].x[k] = row.changeB[i];
    }
    block.mass.x[k] = row.mass;
    block.target.x[k] = row.target;
    block.impulse.x[k] = row.impulse;
  }
  return blocks;
}

struct Outcome {
  Speeds speeds;
  Reals impulses;
};

Outcome plainly(Rows rows, Speeds speeds, int sweeps) {
  for (int n = 0; n < sweeps; ++n) {
    for (PlainRow& row : rows) solveRow(row, speeds);
  }
  Outcome outcome{speeds, {}};
  for (const PlainRow& row : rows) outcome.impulses.push_back(row.impulse);
  return outcome;
}

Outcome inLanes(const Rows& rows, Speeds speeds, int sweeps, Real filling = 0) {
  Blocks blocks = blocksOf(rows, filling);
  for (int n = 0; n < sweeps; ++n) lanesSolver(blocks, speeds);
  Outcome outcome{speeds, {}};
  for (std::size_t r = 0; r < rows.size(); ++r) {
    outcome.impulses.push_back(blocks[r / 4].impulse.x[r % 4]);
  }
  return outcome;
}

Reals all(const Speeds& speeds, int from = 0) {
  Reals numbers;
  for (std::size_t i = static_cast<std::size_t>(from); i < speeds.size(); ++i) {
    numbers.insert(numbers.end(), speeds[i].x.begin(), speeds[i].x.end());
  }
  return numbers;
}

// Eight bodies, four rows of one colour.
Rows fullBlock(Random& random) {
  Rows rows;
  for (std::int32_t k = 0; k < 4; ++k) rows.push_back(randomRow(random, k, 7 - k));
  return rows;
}

// Body 0 on the ground, alone in its block or with one more.
Rows onGround(Random& random, int count) {
  Rows rows;
  for (std::int32_t k = 0; k < count; ++k) rows.push_back(randomRow(random, kNobody, k));
  for (PlainRow& row : rows) row.target = 3;  // all of them push
  return rows;
}

// Bodies in a ring: one colour is 0-1, 2-3, ..., the other 1-2, 3-4, ...
Rows ring(Random& random) {
  Rows rows;
  for (std::int32_t k = 0; k < 4; ++k) rows.push_back(randomRow(random, 2 * k, 2 * k + 1));
  for (std::int32_t k = 0; k < 4; ++k) {
    rows.push_back(randomRow(random, 2 * k + 1, (2 * k + 2) % 8));
  }
  for (PlainRow& row : rows) row.target = 1;
  return rows;
}

}  // namespace

TEST_CASE("bits") {
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    Rows rows = fullBlock(random);
    for (PlainRow& row : rows) row.target = 3;
    const Speeds speeds = randomSpeeds(random, 8);
    const Outcome plain = plainly(rows, speeds, 3);
    GRADE(all(inLanes(rows, speeds, 3).speeds), all(plain.speeds), within(0, kBits),
          given("blocks", blocksOf(rows)), given("speeds", speeds), given("visits", 3),
          unit("m/s and rad/s"), about("the speeds of eight bodies after three visits"));
    GRADE(inLanes(rows, speeds, 3).impulses, plain.impulses, within(0, kBits),
          given("blocks", blocksOf(rows)), given("speeds", speeds), given("visits", 3), unit("N s"),
          about("the impulses of four rows after three visits"));
  }
}

TEST_CASE("each") {
  Random random(seed() + 1);
  for (int n = 0; n < 4; ++n) {
    Rows rows = fullBlock(random);
    for (std::size_t k = 0; k < 4; ++k) {
      // Every second one parts fast enough.
      rows[k].target = (k + static_cast<std::size_t>(n)) % 2 == 0 ? -20 : 20;
    }
    const Speeds speeds = randomSpeeds(random, 8);
    const Outcome plain = plainly(rows, speeds, 1);
    GRADE(inLanes(rows, speeds, 1).impulses, plain.impulses,
          withinRelative(1e-6, "right but for its digits"), given("blocks", blocksOf(rows)),
          given("speeds", speeds), unit("N s"),
          about("every second row parts faster than it has to: the impulses"));
  }
}

TEST_CASE("nobody") {
  Random random(seed() + 2);
  for (int count = 1; count <= 3; ++count) {
    const Rows rows = onGround(random, count);
    const Speeds speeds = randomSpeeds(random, 4);
    const Outcome plain = plainly(rows, speeds, 1);
    GRADE(all(inLanes(rows, speeds, 1, 1).speeds), all(plain.speeds),
          withinRelative(1e-6, "right but for its digits"), given("blocks", blocksOf(rows, 1)),
          given("speeds", speeds), unit("m/s and rad/s"),
          about("bodies on the ground, which is nobody, in a block that is not full: all speeds"));
  }
  const Rows rows = onGround(random, 2);
  const Speeds speeds = randomSpeeds(random, 4);
  GRADE(all(inLanes(rows, speeds, 1, kNone).speeds), all(plainly(rows, speeds, 1).speeds),
        withinRelative(1e-6, "right but for its digits"), given("speeds", speeds),
        unit("m/s and rad/s"), about("the same, with lanes that hold what is no number"));
}

TEST_CASE("no_number") {
  Random random(seed() + 3);
  for (int n = 0; n < 2; ++n) {
    // Body 0 is lost; it touches body 7.
    Rows rows = fullBlock(random);
    for (PlainRow& row : rows) row.target = 3;
    Speeds speeds = randomSpeeds(random, 8);
    speeds[0].x[2] = kNone;
    const Outcome plain = plainly(rows, speeds, 1);
    GRADE(all(inLanes(rows, speeds, 1).speeds, 1), all(plain.speeds, 1),
          withinRelative(1e-6, "right but for its digits"), given("blocks", blocksOf(rows)),
          given("speeds", speeds), unit("m/s and rad/s"),
          about("speed 2 of body 0 is no number: the speeds of bodies 1 to 7"));
  }
}

TEST_CASE("later") {
  Random random(seed() + 4);
  for (int n = 0; n < 2; ++n) {
    const Rows rows = ring(random);
    const Speeds speeds = randomSpeeds(random, 8);
    const Outcome plain = plainly(rows, speeds, 1);
    GRADE(all(inLanes(rows, speeds, 1).speeds), all(plain.speeds),
          withinRelative(1e-6, "right but for its digits"), given("blocks", blocksOf(rows)),
          given("speeds", speeds), unit("m/s and rad/s"),
          about("eight bodies in a ring, two blocks of different colours: all speeds"));
  }
}

TEST_CASE("refuses") {
  Random random(seed() + 5);
  const Speeds speeds = randomSpeeds(random, 2);
  for (const std::int32_t body : {2, -2}) {
    Rows rows = {randomRow(random, 0, 1)};
    rows[0].bodyB = body;
    GRADE_REFUSES(inLanes(rows, speeds, 1).impulses, given("body", body), given("bodies", 2));
  }
}

PROBES() {
  Random random(1030);
  for (int n = 0; n < 6; ++n) {
    Rows rows = ring(random);
    const Speeds speeds = randomSpeeds(random, 8);
    for (std::size_t k = 0; k < 4; ++k) rows[k].target = random.between(-4, 4);
    PROBE(all(inLanes(rows, speeds, 2).speeds));
    // Differences in the last bits alone.
    const Reals lanes = all(inLanes(rows, speeds, 3).speeds);
    const Reals plain = all(plainly(rows, speeds, 3).speeds);
    int differing = 0;
    for (std::size_t i = 0; i < lanes.size(); ++i) differing += lanes[i] != plain[i] ? 1 : 0;
    PROBE(differing);
    const Rows few = onGround(random, 1 + n % 3);
    PROBE(all(inLanes(few, speeds, 1, 1).speeds));
    Rows three = fullBlock(random);
    three.pop_back();
    PROBE(inLanes(three, speeds, 1).impulses);
    Rows old = fullBlock(random);
    old[0].impulse = random.between(1, 2);
    PROBE(inLanes(old, speeds, 1).impulses);
    Speeds lost = speeds;
    lost[0].x[1] = kNone;
    int numbers = 0;
    for (const Real x : all(inLanes(old, lost, 1).speeds, 1)) numbers += std::isnan(x) ? 0 : 1;
    PROBE(numbers);
  }
}

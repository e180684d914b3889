// Grader of 10.soa_layout: copies are exact, so every number is compared to the last bit.

#include "soa_layout.hpp"

#include <cmath>
#include <limits>

#include "grading/grade.hpp"
#include "speed_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Reals = std::vector<Real>;
using Bodies = std::vector<WholeBody>;

constexpr const char* kCopy = "a copy is exact";

Bodies someBodies(Random& random, int count) {
  Bodies bodies;
  for (int i = 0; i < count; ++i) {
    WholeBody body;
    body.name = 100 + i;
    body.position = random.vector(10);
    body.velocity = random.vector(3);
    body.angularVelocity = random.vector(2);
    body.inverseMass = random.between(0.1, 2);
    const Real inertia = random.between(0.5, 2);
    body.inverseInertia = inertia * Matrix3::Identity();
    body.friction = random.between(0.1, 0.9);
    body.restitution = random.between(0.1, 0.9);
    bodies.push_back(body);
  }
  return bodies;
}

Reals hotOf(const WholeBody& body) {
  const Vector3 &p = body.position, &v = body.velocity;
  return {p.x(), p.y(), p.z(), v.x(), v.y(), v.z(), body.inverseMass};
}

// What a lane of a block holds; no numbers where there is no such block.
Reals laneOf(const std::vector<BodyBlock>& blocks, std::size_t block, std::size_t lane) {
  if (block >= blocks.size()) return Reals(7, std::numeric_limits<Real>::quiet_NaN());
  Reals all;
  for (const LaneValues& row : blocks[block].position) all.push_back(row.x[lane]);
  for (const LaneValues& row : blocks[block].velocity) all.push_back(row.x[lane]);
  all.push_back(blocks[block].inverseMass.x[lane]);
  return all;
}

// Blocks whose numbers say where they stand: block, lane, number.
std::vector<BodyBlock> markedBlocks(std::size_t count) {
  std::vector<BodyBlock> blocks(count);
  for (std::size_t b = 0; b < count; ++b) {
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
      const Real base = 100 * static_cast<Real>(b + 1) + 10 * static_cast<Real>(lane);
      for (std::size_t k = 0; k < 3; ++k) {
        blocks[b].position[k].x[lane] = base + static_cast<Real>(k);
        blocks[b].velocity[k].x[lane] = base + 3 + static_cast<Real>(k);
      }
      blocks[b].inverseMass.x[lane] = base + 6;
    }
  }
  return blocks;
}

Bodies backInto(const std::vector<BodyBlock>& blocks, Bodies bodies) {
  aosLayout(blocks, bodies);
  return bodies;
}

Reals coldOf(const Bodies& bodies) {
  Reals all;
  for (const WholeBody& body : bodies) {
    all.insert(all.end(),
               {static_cast<Real>(body.name), body.orientation.w(), body.angularVelocity.z(),
                body.inverseInertia(1, 1), body.friction, body.restitution});
  }
  return all;
}

}  // namespace

TEST_CASE("place") {
  Random random(seed());
  for (const int count : {8, 11, 1}) {
    const Bodies bodies = someBodies(random, count);
    for (int n = 0; n < 3; ++n) {
      const int i = n == 0 ? count - 1 : random.integer(0, count - 1);
      const std::size_t at = static_cast<std::size_t>(i);
      GRADE(laneOf(soaLayout(bodies), at / 4, at % 4), hotOf(bodies[at]), within(0, kCopy),
            given("bodies", count), given("i", i),
            about("x, y, z of the position, x, y, z of the velocity, and the inverse mass, in lane "
                  "i % 4 of block i / 4"));
    }
  }
}

TEST_CASE("padding") {
  Random random(seed() + 1);
  for (const int count : {8, 9, 10, 12, 0}) {
    const Bodies bodies = someBodies(random, count);
    GRADE(soaLayout(bodies).size(), static_cast<std::size_t>((count + 3) / 4), within(0, "a count"),
          given("bodies", count), about("the number of blocks"));
  }
  const Bodies five = someBodies(random, 5);
  const auto blocks = [&] { return soaLayout(five); };
  GRADE(laneOf(blocks(), 1, 0), hotOf(five[4]), within(0, kCopy), given("bodies", 5),
        about("lane 0 of block 1: body 4"));
  for (std::size_t lane = 1; lane < 4; ++lane) {
    GRADE(laneOf(blocks(), 1, lane), Reals(7, 0), within(0, "nobody is at rest in the origin"),
          given("bodies", 5), given("lane", lane), about("block 1: a lane without a body"));
  }
}

TEST_CASE("back") {
  Random random(seed() + 2);
  for (const int count : {8, 6, 13}) {
    const Bodies bodies = someBodies(random, count);
    const std::vector<BodyBlock> blocks = markedBlocks(static_cast<std::size_t>((count + 3) / 4));
    for (int n = 0; n < 3; ++n) {
      const int i = n == 0 ? count - 1 : random.integer(0, count - 1);
      const std::size_t at = static_cast<std::size_t>(i);
      const Real base = 100 * static_cast<Real>(i / 4 + 1) + 10 * static_cast<Real>(i % 4);
      const Reals expected = {base, base + 1, base + 2, base + 3, base + 4, base + 5, base + 6};
      GRADE(hotOf(backInto(blocks, bodies)[at]), expected, within(0, kCopy), given("bodies", count),
            given("i", i),
            about("back from blocks that hold 100 (block + 1) + 10 lane + number: position, "
                  "velocity and inverse mass of body i"));
    }
  }
}

TEST_CASE("cold") {
  Random random(seed() + 3);
  for (const int count : {4, 7}) {
    const Bodies bodies = someBodies(random, count);
    const std::vector<BodyBlock> blocks = markedBlocks(static_cast<std::size_t>((count + 3) / 4));
    GRADE(hotOf(backInto(blocks, bodies)[1])[0], 110, within(0, kCopy), given("bodies", count),
          about("x of the position of body 1"));
    GRADE(coldOf(backInto(blocks, bodies)), coldOf(bodies), within(0, kCopy),
          given("bodies", count),
          about("what no block holds: name, orientation, rate, inertia, friction, restitution"));
  }
}

TEST_CASE("refuses") {
  Random random(seed() + 4);
  const Bodies bodies = someBodies(random, 5);
  GRADE_REFUSES(backInto(markedBlocks(1), bodies), given("blocks", 1), given("bodies", 5));
  GRADE_REFUSES(backInto(markedBlocks(3), bodies), given("blocks", 3), given("bodies", 5));
}

PROBES() {
  Random random(1010);
  for (int n = 0; n < 9; ++n) {
    const int count = 4 + n;
    const Bodies bodies = someBodies(random, count);
    const std::size_t last = static_cast<std::size_t>(count - 1);
    PROBE(soaLayout(bodies).size());
    PROBE(laneOf(soaLayout(bodies), last / 4, 3));
    PROBE(laneOf(soaLayout(bodies), 0, static_cast<std::size_t>(n % 4)));
    const std::vector<BodyBlock> blocks = markedBlocks(static_cast<std::size_t>((count + 3) / 4));
    PROBE(hotOf(backInto(blocks, bodies)[last]));
    if (n < 2) PROBE(coldOf(backInto(blocks, bodies)));
  }
}

// Colours, lanes and threads: what is solved at the same time is solved as if one by one.

#include "carom/solver/soft_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/solver/soft_rows_widths.hpp"
#include "support/catch.hpp"

using carom::ColorEdge;
using carom::MovingBody;
using carom::PileContact;
using carom::Real;
using carom::Vector3;

namespace {

constexpr Real kStep = 1.0 / 60;

// Bodies that touch at random, the last two of which nothing moves.
struct Heap {
  std::vector<MovingBody> bodies;
  std::vector<ColorEdge> edges;
  std::vector<PileContact> contacts;
  std::size_t movable = 0;
};

Heap randomHeap(std::uint64_t seed, std::size_t movable, int contacts) {
  carom::Random random(seed);
  Heap heap;
  heap.movable = movable;
  for (std::size_t i = 0; i < movable + 2; ++i) {
    MovingBody body;
    if (i < movable) {
      body.mass.inverseMass = random.between(0.1, 2);
      const Real inertia = random.between(0.5, 5);
      body.mass.inverseInertia = inertia * carom::Matrix3::Identity();
      body.velocity.linear = random.between(0.1, 2) * random.direction();
      body.velocity.angular = random.between(0.1, 2) * random.direction();
    }
    heap.bodies.push_back(body);
  }
  const Real last = static_cast<Real>(movable) + 1.999;
  while (static_cast<int>(heap.edges.size()) < contacts) {
    const std::int32_t a = static_cast<std::int32_t>(random.between(0, last));
    const std::int32_t b = static_cast<std::int32_t>(random.between(0, last - 2));
    if (a == b) continue;
    PileContact contact;
    contact.normal = random.direction();
    contact.count = 1 + static_cast<int>(random.between(0, 3.999));
    for (int i = 0; i < contact.count; ++i) {
      carom::SoftPoint& point = contact.points[static_cast<std::size_t>(i)];
      point.armA = 0.5 * random.direction();
      point.armB = 0.5 * random.direction();
      point.separation = random.between(-0.01, 0.005);
      point.force = random.between(0, 5);
    }
    contact.friction = random.between(0, 1);
    contact.restitution = random.between(0, 1) > 0.5 ? 0.5 : 0;
    contact.rub = random.between(0, 1) * random.direction();
    heap.edges.push_back({a, b});
    heap.contacts.push_back(contact);
  }
  return heap;
}

struct Outcome {
  std::vector<carom::SoftMotion> motions;
  std::vector<Real> forces;
};

Outcome solved(const Heap& heap, const carom::SoftSettings& settings, carom::RowNumbers numbers,
               int threads, Vector3 gravity = Vector3(0, 0, -9.81)) {
  carom::SoftSteps steps;
  carom::KeptThreads crew(threads);
  const Real part = kStep / settings.shortSteps;
  std::vector<std::uint8_t> counts;
  for (const PileContact& contact : heap.contacts) {
    counts.push_back(static_cast<std::uint8_t>(contact.count));
  }
  steps.begin(heap.bodies.size(), heap.movable, numbers);
  for (std::size_t i = 0; i < heap.bodies.size(); ++i) {
    carom::Velocity gain;
    if (i < heap.movable) gain.linear = kStep * gravity;
    steps.setBody(i, heap.bodies[i], gain, settings.shortSteps);
  }
  steps.place(heap.edges, counts);
  for (std::size_t place = 0; place < steps.places(); ++place) {
    const std::int32_t contact = steps.contactAt(place);
    if (contact < 0) continue;
    steps.setContact(place, heap.contacts[static_cast<std::size_t>(contact)], part);
  }
  steps.run(settings, kStep, crew);
  Outcome outcome;
  for (std::size_t i = 0; i < heap.bodies.size(); ++i) outcome.motions.push_back(steps.body(i));
  for (std::size_t place = 0; place < steps.places(); ++place) {
    for (const Real force : steps.contact(place, part).normal) outcome.forces.push_back(force);
  }
  return outcome;
}

bool same(const Outcome& a, const Outcome& b) {
  if (a.forces != b.forces) return false;
  for (std::size_t i = 0; i < a.motions.size(); ++i) {
    const carom::SoftMotion &p = a.motions[i], &q = b.motions[i];
    if (p.velocity.linear != q.velocity.linear || p.velocity.angular != q.velocity.angular ||
        p.way != q.way || p.turn != q.turn || p.touched != q.touched) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("no two contacts of a colour move the same body, however many a body has") {
  const int contacts = GENERATE(1, 50, 3000);
  const Heap heap = randomHeap(7, 40, contacts);  // up to some 150 contacts of one body
  carom::GraphColors graph;
  std::vector<std::int32_t> colors;
  const int count = graph.color(heap.edges, 40, colors);
  std::set<std::pair<std::int32_t, std::int32_t>> taken;
  for (std::size_t e = 0; e < heap.edges.size(); ++e) {
    CHECK(colors[e] >= 0);
    CHECK(colors[e] < count);
    for (const std::int32_t body : {heap.edges[e].a, heap.edges[e].b}) {
      if (body >= 40) continue;
      const bool isNew = taken.insert({colors[e], body}).second;
      CHECK(isNew);
    }
  }
}

TEST_CASE("the plain function colours as the one with memory does, but for who comes last") {
  const Heap heap = randomHeap(12, 40, 300);
  std::vector<ColorEdge> moving;
  for (const ColorEdge& edge : heap.edges) {
    if (edge.a < 40) moving.push_back(edge);
  }
  carom::GraphColors graph;
  std::vector<std::int32_t> colors;
  const int count = graph.color(moving, 40, colors);
  CHECK(colors == carom::colorGraph(moving, 40));
  CHECK(count == *std::max_element(colors.begin(), colors.end()) + 1);
}

TEST_CASE("a body may have more contacts than a number has bits") {
  std::vector<ColorEdge> star;
  for (std::int32_t i = 1; i <= 150; ++i) star.push_back({0, i});
  carom::GraphColors graph;
  std::vector<std::int32_t> colors;
  CHECK(graph.color(star, 151, colors) == 150);
  CHECK(colors == carom::colorGraph(star, 151));
}

TEST_CASE("edges that are none are refused") {
  using carom_test::ContainsSubstring;
  const auto colored = [](ColorEdge edge, std::int32_t movable) {
    return carom::colorGraph(std::vector<ColorEdge>{edge}, movable);
  };
  CHECK_THROWS_WITH(colored({0, -3}, 2), ContainsSubstring("body = -3"));
  CHECK_THROWS_WITH(colored({1, 1}, 2), ContainsSubstring("must join two bodies"));
  CHECK_THROWS_WITH(colored({0, 1}, -1), ContainsSubstring("movable = -1"));
  CHECK(colored({5, 5}, 2) == std::vector<std::int32_t>{0});
}

TEST_CASE("contacts with what cannot be moved come after all others") {
  const Heap heap = randomHeap(8, 40, 300);
  carom::GraphColors graph;
  std::vector<std::int32_t> colors;
  graph.color(heap.edges, 40, colors);
  std::int32_t lastMoving = -1, firstStill = 1'000'000;
  for (std::size_t e = 0; e < heap.edges.size(); ++e) {
    if (heap.edges[e].a < 40) {
      lastMoving = std::max(lastMoving, colors[e]);
    } else {
      firstStill = std::min(firstStill, colors[e]);
    }
  }
  CHECK(lastMoving < firstStill);
}

TEST_CASE("lanes do what one number at a time does, to the last bit") {
  const auto numbers = GENERATE(carom::RowNumbers::floats, carom::RowNumbers::doubles);
  const Heap heap = randomHeap(9, 60, 200);
  carom::SoftSettings wide, narrow, plain;
  narrow.width = carom::RowWidth::narrow;
  plain.width = carom::RowWidth::plain;
  const Outcome outcome = solved(heap, plain, numbers, 1);
  CHECK(same(solved(heap, wide, numbers, 1), outcome));
  CHECK(same(solved(heap, narrow, numbers, 1), outcome));
}

TEST_CASE("any number of threads comes to the same bits") {
  const auto numbers = GENERATE(carom::RowNumbers::floats, carom::RowNumbers::doubles);
  const Heap heap = randomHeap(10, 400, 1500);
  const Outcome one = solved(heap, {}, numbers, 1);
  for (const int threads : {2, 3, 5}) CHECK(same(one, solved(heap, {}, numbers, threads)));
}

TEST_CASE("contacts between bodies that move keep momentum") {
  Heap heap = randomHeap(11, 60, 200);
  // Only contacts among those that move, and no bounce, whose order does not matter here.
  for (ColorEdge& edge : heap.edges) edge.a = edge.a >= 60 ? (edge.b + 1) % 60 : edge.a;
  const Outcome outcome = solved(heap, {}, carom::RowNumbers::doubles, 1, Vector3::Zero());
  Vector3 before = Vector3::Zero(), after = Vector3::Zero();
  Real size = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    const Real mass = 1 / heap.bodies[i].mass.inverseMass;
    before += mass * heap.bodies[i].velocity.linear;
    after += mass * outcome.motions[i].velocity.linear;
    size += mass * outcome.motions[i].velocity.linear.norm();
  }
  // Some thousand impulses, each rounded.
  CHECK((after - before).norm() <= 1e-12 * size);
}

TEST_CASE("a body at rest on a floor stays there, carried by its weight") {
  Heap heap;
  heap.movable = 1;
  heap.bodies.resize(2);
  heap.bodies[0].mass.inverseMass = 0.5;
  heap.bodies[0].mass.inverseInertia = 3 * carom::Matrix3::Identity();
  PileContact contact;
  contact.count = 4;
  contact.friction = 0.5;
  const Real weight = 2 * 9.81;
  for (int i = 0; i < 4; ++i) {
    carom::SoftPoint& point = contact.points[static_cast<std::size_t>(i)];
    point.armB = {i % 2 == 0 ? -0.5 : 0.5, i < 2 ? -0.5 : 0.5, -0.5};
    point.armA = point.armB;
    point.force = weight / 4;
  }
  heap.edges = {{1, 0}};
  heap.contacts = {contact};
  const Outcome outcome = solved(heap, {}, carom::RowNumbers::doubles, 1);
  CHECK(outcome.motions[0].velocity.linear.norm() <= 1e-15);
  CHECK(outcome.motions[0].way.norm() <= 1e-16);
  CHECK(outcome.motions[0].touched);
  for (int i = 0; i < 4; ++i) {
    CHECK_THAT(outcome.forces[static_cast<std::size_t>(i)],
               carom_test::WithinRel(weight / 4, 1e-12));
  }
}

TEST_CASE("a body that nothing touches is not said to be touched") {
  Heap heap = randomHeap(12, 5, 1);
  heap.contacts[0].points = {};
  heap.contacts[0].count = 1;
  heap.contacts[0].rub = Vector3::Zero();
  heap.contacts[0].points[0].separation = 1;
  const Outcome outcome = solved(heap, {}, carom::RowNumbers::floats, 1);
  for (const carom::SoftMotion& motion : outcome.motions) CHECK(!motion.touched);
}

TEST_CASE("a loop that threads share is done once, all of it") {
  for (const int threads : {1, 2, 3, 5}) {
    carom::KeptThreads crew(threads);
    for (const std::size_t count : {0, 1, 7, 100}) {
      std::vector<int> done(count, 0);
      crew.loop(count, 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++done[i];
      });
      CHECK(done == std::vector<int>(count, 1));
    }
  }
  CHECK_THROWS_AS(carom::KeptThreads(0), carom::InvalidInput);
}

TEST_CASE("the wide kernel is used where the machine has it") {
  const int lanes = carom::widestKernel<float>().lanes;
  CHECK(lanes == (carom::detail::runsWide() ? 8 : 4));
  CHECK(carom::plainKernel<float>().lanes == 1);
}

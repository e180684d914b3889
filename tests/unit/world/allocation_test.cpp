// A step takes no memory once a scene has come to its largest size, as long as nothing is about to
// meet: the search for first contacts of two solids that are not both balls still does.

#include "scene_parts.hpp"
#include "support/catch.hpp"
#include "support/counted_memory.hpp"

TEST_CASE("a step of a scene at rest takes no memory, although nothing sleeps") {
  using namespace carom_test;
  using carom_test::addPlane;
  World world(awake());
  addPlane(world, 0.5, 0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        addBox(world, {0.25, 0.2, 0.15},
               {.position = {i * 0.8, j * 0.8, 0.15 + 0.3 * k}, .friction = 0.5});
      }
    }
  }
  for (int i = 0; i < 20; ++i) {
    addBall(world, 0.1, {.position = {4 + 0.3 * (i % 5), 0.3 * (i / 5), 0.3}, .friction = 0.3});
  }
  run(world, 60);
  const std::size_t before = allocations;
  run(world, 60);
  CHECK(allocations == before);
}

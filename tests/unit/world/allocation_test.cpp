// A step takes no memory once a scene has come to its largest size, as long as nothing is about to
// meet: the search for first contacts of two solids that are not both balls still does.

#include <cstdlib>
#include <new>

#include "scene_parts.hpp"
#include "support/catch.hpp"

namespace {

long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

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
  const long before = allocations;
  run(world, 60);
  CHECK(allocations == before);
}

#include "bench/allocations.hpp"

#include <malloc.h>

#include <atomic>
#include <cstddef>

namespace {

std::atomic<long> asked{0};

}  // namespace

// The C library's own, under the names by which it lets others stand in front of them.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);

void* malloc(std::size_t size) {
  asked.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  asked.fetch_add(1, std::memory_order_relaxed);
  return __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) {
  asked.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(block, size);
}
}

namespace carom::bench {

long allocationsSoFar() {
  return asked.load(std::memory_order_relaxed);
}

Real bytesTaken() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<Real>(info.uordblks) + static_cast<Real>(info.hblkhd);
}

}  // namespace carom::bench

#pragma once
// Counts who asks for memory. Replaces the operators of the whole program: include it in one of its files.

#include <cstddef>
#include <cstdlib>
#include <new>

namespace carom_test {

/// How often this program has asked for memory so far.
inline std::size_t allocations = 0;

}  // namespace carom_test

// Not inlined: g++ 12 would take them for a mismatched pair. The form that does not throw is one of them, or the address
// sanitizer finds memory of its own given back to us.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++carom_test::allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++carom_test::allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

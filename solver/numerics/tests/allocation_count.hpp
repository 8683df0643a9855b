#pragma once
/// How often the program has asked for memory: for tests and benchmarks of what must not. Replaces the global
/// operators, so it belongs into one source file of a program only.

#include <atomic>
#include <cstdlib>
#include <new>

namespace sunder::numerics {
inline std::atomic<long> allocations{0};
}

// Not inlined, or GCC takes malloc and delete for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  sunder::numerics::allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

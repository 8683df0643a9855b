#pragma once
/// How often the program has asked for memory: for tests and benchmarks of what must not. Replaces glibc's malloc,
/// through which operator new, Eigen and CHOLMOD all go, so it belongs into one source file of a program only. A
/// sanitizer has a malloc of its own: under it nothing is counted.

#include <atomic>
#include <cstdlib>

namespace sunder::numerics {
inline std::atomic<long> allocations{0};
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);
extern "C" void* __libc_realloc(void* memory, std::size_t size);

// Not inlined, or GCC takes malloc and delete for a mismatch.
extern "C" [[gnu::noinline]] void* malloc(std::size_t size) {
  sunder::numerics::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
extern "C" [[gnu::noinline]] void* calloc(std::size_t count, std::size_t size) {
  sunder::numerics::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_calloc(count, size);
}
extern "C" [[gnu::noinline]] void* realloc(void* memory, std::size_t size) {
  sunder::numerics::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(memory, size);
}
#endif

#pragma once
/// How often the program has asked for memory: for tests and benchmarks of what must not. Replaces glibc's malloc,
/// through which operator new, Eigen and CHOLMOD all go. A sanitizer has a malloc of its own: under it nothing is
/// counted, and a test that wants a count skips.

#include <atomic>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SUNDER_COUNTS_ALLOCATIONS 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define SUNDER_COUNTS_ALLOCATIONS 0
#endif
#endif
#ifndef SUNDER_COUNTS_ALLOCATIONS
#define SUNDER_COUNTS_ALLOCATIONS 1
#endif

namespace sunder::numerics {
inline std::atomic<long> allocations{0};
inline constexpr bool counts_allocations = SUNDER_COUNTS_ALLOCATIONS != 0;
}  // namespace sunder::numerics

#if SUNDER_COUNTS_ALLOCATIONS
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);
extern "C" void* __libc_realloc(void* memory, std::size_t size);

// Weak: several source files of a program may count. Not inlined, or GCC takes malloc and delete for a mismatch.
extern "C" [[gnu::noinline, gnu::weak]] void* malloc(std::size_t size) {
  sunder::numerics::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
extern "C" [[gnu::noinline, gnu::weak]] void* calloc(std::size_t count, std::size_t size) {
  sunder::numerics::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_calloc(count, size);
}
extern "C" [[gnu::noinline, gnu::weak]] void* realloc(void* memory, std::size_t size) {
  sunder::numerics::allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(memory, size);
}
#endif

// Preloaded (LD_PRELOAD), it sees every block that the program and all its libraries ask for: how many, and the largest
// number of bytes held at once since `sunder_heap_start`. With glibc every block comes by one of these functions.

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstddef>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace {

std::atomic<long long> allocations{0}, held{0}, start{0}, peak{0};

void* taken(void* block) {
  if (block == nullptr) return block;
  allocations.fetch_add(1, std::memory_order_relaxed);
  const long long now = held.fetch_add(static_cast<long long>(malloc_usable_size(block))) +
                        static_cast<long long>(malloc_usable_size(block));
  if (now > peak.load(std::memory_order_relaxed)) peak.store(now, std::memory_order_relaxed);
  return block;
}

void given_back(void* block) {
  if (block != nullptr) held.fetch_sub(static_cast<long long>(malloc_usable_size(block)));
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) {
  return taken(__libc_malloc(size));
}
void* calloc(std::size_t count, std::size_t size) {
  return taken(__libc_calloc(count, size));
}
void* realloc(void* block, std::size_t size) {
  given_back(block);
  return taken(__libc_realloc(block, size));
}
void* memalign(std::size_t alignment, std::size_t size) {
  return taken(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return taken(__libc_memalign(alignment, size));
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = taken(__libc_memalign(alignment, size));
  return *block != nullptr ? 0 : ENOMEM;
}
void free(void* block) {
  given_back(block);
  __libc_free(block);
}

long long sunder_heap_start() {
  allocations = 0;
  start = held.load();
  peak = held.load();
  return 0;
}
long long sunder_heap_allocations() {
  return allocations;
}
/// Bytes beyond those held at the start.
long long sunder_heap_peak() {
  return peak - start;
}
}

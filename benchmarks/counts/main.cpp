/// sunder-counts REGION [SIZE] [EXTRA]: does one piece of work with callgrind's instrumentation switched on around it,
/// and prints what the heap counter saw where it is preloaded (heap_counter.cpp). `sunder-counts --list` names them
/// all. EXTRA instructions are wasted inside the region: the slow-down with which the gate is tested. Exit status: 0
/// the answer is right, 1 it is wrong, 2 there is no such region.

#include <dlfcn.h>
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "benchmarks/counts/region.hpp"

namespace {

using namespace sunder::counts;

std::vector<Region> all_regions() {
  std::vector<Region> regions = kernel_regions();
  for (Region& region : dam_regions()) regions.push_back(std::move(region));
  return regions;
}

/// `instructions` and a few more: two a round.
void waste(long instructions) {
  for (long round = instructions / 2; round > 0; --round) asm volatile("");
}

long long heap(const char* name) {
  using Reading = long long (*)();
  void* found = ::dlsym(RTLD_DEFAULT, name);
  return found != nullptr ? reinterpret_cast<Reading>(found)() : -1;
}

int count(const Region& region, long size, long extra) {
  const Work work = region.make(size);
  long long allocations = 0, peak = 0;
  work.run(
      [&] {
        (void)heap("sunder_heap_start");
        CALLGRIND_START_INSTRUMENTATION;
      },
      [&] {
        waste(extra);
        CALLGRIND_STOP_INSTRUMENTATION;
        allocations = heap("sunder_heap_allocations");
        peak = heap("sunder_heap_peak");
      });
  const bool right = work.is_right();
  std::printf("{\"region\": \"%s\", \"size\": %ld, \"right\": %s", region.name.c_str(), size, right ? "true" : "false");
  if (allocations >= 0) std::printf(", \"allocations\": %lld, \"peak_bytes\": %lld", allocations, peak);
  std::printf("}\n");
  return right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  try {
    for (const Region& region : all_regions()) {
      if (name == "--list") {
        std::printf("%s\t%ld\t%s\n", region.name.c_str(), region.size, region.meaning.c_str());
      } else if (name == region.name) {
        return count(region, argc > 2 ? std::atol(argv[2]) : region.size, argc > 3 ? std::atol(argv[3]) : 0);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sunder-counts: %s\n", error.what());
    return 1;
  }
  if (name == "--list") return 0;
  std::fprintf(stderr, "sunder-counts: there is no region \"%s\"; accepted: a name that --list prints\n", name.c_str());
  return 2;
}

/// What a step asks for in a run with water, crack, contact, moving water and propagation: no memory, unless a crack
/// grows in it.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "solver/scene/reader.hpp"
#include "solver/simulation/tests/scene_runs.hpp"

namespace {
std::atomic<long> allocations{0};
}

// A sanitizer has a malloc of its own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SUNDER_COUNTS_BLOCKS 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define SUNDER_COUNTS_BLOCKS 0
#endif
#endif
#ifndef SUNDER_COUNTS_BLOCKS
#define SUNDER_COUNTS_BLOCKS 1
#endif

#if SUNDER_COUNTS_BLOCKS
// Eigen allocates past operator new, and operator new comes here too: with glibc every block does.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" [[gnu::noinline]] void* malloc(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif

namespace sunder::simulation {
namespace {

const char* const wall = R"(
name = "cracked wall in water"
analysis = "dynamic"
[geometry]
outline = [[0, 0], [30, 0], [10, 40], [0, 40]]
boundaries = { base = [0], crest = [2], upstream = [3] }
[mesh]
size = 4
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 2450
[gravity]
[[support]]
boundary = "base"
fix = ["x", "y"]
[[crack]]
path = [[0, 20], [6, 20]]
[reservoir]
boundary = "upstream"
level = 36
model = "compressible"
[ground_motion]
horizontal = "shaking.csv"
[dynamics]
time_step = 0.005
duration = 1.6
damping_modes = 1
[contact]
[crack_water]
model = "moving"
minimum_aperture = 0.01
aperture = "sum"
[propagation]
fracture_toughness = 1e9
increment = 0.5
)";

TEST(CoupledStep, AsksForNoMemory) {
  if (SUNDER_COUNTS_BLOCKS == 0) GTEST_SKIP() << "blocks are the sanitizer's";
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "coupled-step-allocation";
  std::filesystem::create_directories(folder);
  {
    std::ofstream record(folder / "shaking.csv");
    for (int i = 0; i <= 160; ++i) record << 0.01 * i << ',' << (i % 14 - 6.5) * 0.5 << '\n';
  }
  const long before_vector = allocations;
  std::vector<long> counts(1, 0);
  counts.reserve(1000);
  ASSERT_GT(allocations, before_vector);  // the count counts
  const auto note = [&counts](std::string_view phase, double) {
    if (phase == "steps") counts.push_back(allocations.load());
  };
  const results::RunSummary summary =
      run(scene::read_scene_text(wall, folder / "wall.toml", {}), {.threads = 1, .progress = note});
  ASSERT_TRUE(summary.completed()) << summary.status;
  // every part takes part: faces press on each other, and the crack opens, with water in it
  EXPECT_GT(tests::number(summary, "max_crack_mouth_opening"), 0.0);
  ASSERT_TRUE(summary.history);
  ASSERT_GT(counts.size(), 10u);
  for (std::size_t i = 3; i < counts.size(); ++i) EXPECT_EQ(counts[i], counts[i - 1]) << "between notes " << i;
}

}  // namespace
}  // namespace sunder::simulation

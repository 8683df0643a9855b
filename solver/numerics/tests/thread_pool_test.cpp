#include "solver/numerics/thread_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace sunder::numerics {
namespace {

TEST(ThreadPool, VisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 5}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    for (const int count : {0, 1, 2, 3, 1000}) {
      std::vector<int> visits(static_cast<std::size_t>(count), 0);
      pool.parallel_for(count, [&](int i) { ++visits[static_cast<std::size_t>(i)]; });
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), count);
      for (const int v : visits) EXPECT_EQ(v, 1);
    }
  }
}

TEST(ThreadPool, ChunksAreConsecutiveAndAlwaysTheSame) {
  ThreadPool pool(3);
  std::vector<int> begins(3, -1), ends(3, -1);
  for (int repetition = 0; repetition < 200; ++repetition) {
    pool.chunks(10, [&](int begin, int end, int thread) {
      begins[static_cast<std::size_t>(thread)] = begin;
      ends[static_cast<std::size_t>(thread)] = end;
    });
    EXPECT_EQ(begins, (std::vector<int>{0, 3, 6}));
    EXPECT_EQ(ends, (std::vector<int>{3, 6, 10}));
  }
}

TEST(ThreadPool, ThrowsOnTheFirstChunksExceptionAndGoesOn) {
  ThreadPool pool(2);
  for (int repetition = 0; repetition < 20; ++repetition) {
    try {
      pool.parallel_for(2, [](int i) { throw std::runtime_error("index " + std::to_string(i)); });
      FAIL() << "nothing thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "index 0");
    }
  }
  std::atomic<int> sum = 0;
  pool.parallel_for(100, [&](int i) { sum += i; });
  EXPECT_EQ(sum, 4950);
}

TEST(ThreadPool, RefusesNoThreads) {
  EXPECT_THROW(ThreadPool(0), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::numerics

#pragma once
/// A few standing threads that share a loop.
///
/// A loop is cut into as many consecutive chunks as there are threads, always at the same places; whoever writes only
/// to what belongs to its index gets the same bits for any number of threads.

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace sunder::numerics {

class ThreadPool {
 public:
  /// `threads` >= 1, the calling one included. Throws std::invalid_argument otherwise.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const { return static_cast<int>(workers_.size()) + 1; }

  /// body(begin, end, thread) once for every thread whose chunk is not empty; returns when all are done. The exception
  /// of the lowest chunk is thrown on. Not to be called from inside a body.
  void chunks(int count, const std::function<void(int begin, int end, int thread)>& body);

  /// body(i) for i = 0 … count - 1.
  template <class Body>
  void parallel_for(int count, const Body& body) {
    chunks(count, [&body](int begin, int end, int) {
      for (int i = begin; i < end; ++i) body(i);
    });
  }

 private:
  void work(int thread);
  void run_chunk(int thread);

  std::vector<std::thread> workers_;
  std::vector<std::exception_ptr> errors_;
  std::mutex mutex_;
  std::condition_variable start_, done_;
  const std::function<void(int, int, int)>* body_ = nullptr;
  int count_ = 0, running_ = 0;
  std::uint64_t loop_ = 0;
  bool stopping_ = false;
};

}  // namespace sunder::numerics

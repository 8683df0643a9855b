#include "solver/numerics/thread_pool.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace sunder::numerics {

ThreadPool::ThreadPool(int threads) {
  if (threads < 1) {
    throw std::invalid_argument("threads = " + std::to_string(threads) + ", accepted is threads >= 1");
  }
  errors_.resize(static_cast<std::size_t>(threads));
  workers_.reserve(static_cast<std::size_t>(threads - 1));
  for (int thread = 1; thread < threads; ++thread) workers_.emplace_back([this, thread] { work(thread); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  start_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::run_chunk(int thread) {
  const std::int64_t count = count_, total = threads();
  const int begin = static_cast<int>(count * thread / total), end = static_cast<int>(count * (thread + 1) / total);
  if (begin == end) return;
  try {
    (*body_)(begin, end, thread);
  } catch (...) {
    errors_[static_cast<std::size_t>(thread)] = std::current_exception();
  }
}

void ThreadPool::work(int thread) {
  std::uint64_t finished = 0;
  std::unique_lock lock(mutex_);
  while (true) {
    start_.wait(lock, [&] { return stopping_ || loop_ != finished; });
    if (stopping_) return;
    finished = loop_;
    lock.unlock();
    run_chunk(thread);
    lock.lock();
    if (--running_ == 0) done_.notify_one();
  }
}

void ThreadPool::chunks(int count, const std::function<void(int, int, int)>& body) {
  {
    const std::lock_guard lock(mutex_);
    body_ = &body;
    count_ = count;
    running_ = static_cast<int>(workers_.size());
    ++loop_;
  }
  if (!workers_.empty()) start_.notify_all();
  run_chunk(0);
  {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return running_ == 0; });
    body_ = nullptr;
  }
  std::exception_ptr first;
  for (std::exception_ptr& error : errors_) {
    if (!first) first = error;
    error = nullptr;
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace sunder::numerics

// Internal: threads that share the work of one step after another.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace changeover {

/// run(n, task) calls task(0), …, task(n−1), each once, on the calling thread and the others, and
/// returns when all are done. After an exception the remaining tasks are left out, and the first
/// exception is rethrown to the caller.
class ComputePool {
 public:
  /// @throws MissingResource if a thread cannot be started
  explicit ComputePool(unsigned threads);
  ~ComputePool();
  ComputePool(const ComputePool&) = delete;
  ComputePool& operator=(const ComputePool&) = delete;

  void run(std::size_t count, const std::function<void(std::size_t)>& task);

 private:
  void close();
  void serve();
  void work(const std::function<void(std::size_t)>& task, std::size_t count);

  std::mutex mutex_;
  std::condition_variable begin_;
  std::condition_variable end_;
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t count_ = 0;
  std::uint64_t round_ = 0;
  unsigned busy_ = 0;
  bool closing_ = false;
  std::exception_ptr fault_;
  std::atomic<std::size_t> next_{0};
  std::vector<std::thread> threads_;
};

}  // namespace changeover

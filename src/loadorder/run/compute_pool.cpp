#include "loadorder/run/compute_pool.hpp"

#include <utility>

#include "run/threads.hpp"

namespace changeover {

ComputePool::ComputePool(unsigned threads) {
  start_threads(
      threads_, threads > 0 ? threads - 1 : 0, [this](unsigned) { serve(); }, [this] { close(); });
}

void ComputePool::close() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  begin_.notify_all();
}

ComputePool::~ComputePool() {
  close();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void ComputePool::work(const std::function<void(std::size_t)>& task, std::size_t count) {
  try {
    for (std::size_t i = next_.fetch_add(1); i < count; i = next_.fetch_add(1)) {
      task(i);
    }
  } catch (...) {
    next_ = count;  // leaves out the rest
    const std::lock_guard lock(mutex_);
    if (!fault_) {
      fault_ = std::current_exception();
    }
  }
}

void ComputePool::serve() {
  std::uint64_t seen = 0;
  std::unique_lock lock(mutex_);
  while (true) {
    begin_.wait(lock, [&] { return closing_ || round_ != seen; });
    if (closing_) {
      return;
    }
    seen = round_;
    const auto& task = *task_;
    const std::size_t count = count_;
    lock.unlock();
    work(task, count);
    lock.lock();
    if (--busy_ == 0) {
      end_.notify_one();
    }
  }
}

void ComputePool::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (count == 0) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    next_ = 0;
    fault_ = nullptr;
    // One task needs no other thread.
    if (count > 1 && !threads_.empty()) {
      task_ = &task;
      count_ = count;
      busy_ = static_cast<unsigned>(threads_.size());
      ++round_;
      begin_.notify_all();
    }
  }
  work(task, count);
  std::unique_lock lock(mutex_);
  end_.wait(lock, [this] { return busy_ == 0; });
  if (fault_) {
    std::rethrow_exception(std::exchange(fault_, nullptr));
  }
}

}  // namespace changeover

#include "serve/http/lanes.hpp"

#include <utility>

#include "run/threads.hpp"

namespace changeover::serve {

Lanes::Lanes(const Settings& settings) {
  start_threads(
      threads_, settings.quick + settings.slow,
      [this, quick = settings.quick](unsigned i) { serve(lanes_[i < quick ? 0 : 1]); },
      [this] { stop(std::chrono::seconds(0)); });
}

Lanes::~Lanes() {
  stop(std::chrono::seconds(0));
  for (std::thread& each : threads_) {
    each.join();
  }
}

void Lanes::add(Lane lane, std::function<void()> task) {
  One& one = lanes_[lane == Lane::slow ? 1 : 0];
  {
    const std::scoped_lock lock(mutex_);
    if (!stopping_) {
      one.tasks.push_back(std::move(task));
      task = nullptr;
    }
  }
  if (task) {
    task();
  } else {
    one.more.notify_one();
  }
}

bool Lanes::stop(std::chrono::duration<double> patience) {
  std::deque<std::function<void()>> left;
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
    for (One& lane : lanes_) {
      std::move(lane.tasks.begin(), lane.tasks.end(), std::back_inserter(left));
      lane.tasks.clear();
      lane.more.notify_all();
    }
  }
  for (const auto& task : left) {
    task();
  }
  std::unique_lock lock(mutex_);
  return idle_.wait_for(lock, patience, [this] { return busy_ == 0; });
}

void Lanes::serve(One& lane) {
  std::unique_lock lock(mutex_);
  for (;;) {
    lane.more.wait(lock, [&] { return stopping_ || !lane.tasks.empty(); });
    if (stopping_) {
      return;
    }
    const std::function<void()> task = std::move(lane.tasks.front());
    lane.tasks.pop_front();
    ++busy_;
    lock.unlock();
    task();
    lock.lock();
    --busy_;
    idle_.notify_all();
  }
}

}  // namespace changeover::serve

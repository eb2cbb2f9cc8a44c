// Threads that answer, in two lanes, so that long answers never stand in the way of short ones.
//
//     Lanes lanes({.quick = 2, .slow = 2});
//     lanes.add(Lane::quick, [] { … });
//     lanes.stop(1s);
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace changeover::serve {

enum class Lane : std::uint8_t {
  here,   ///< no work at all: the thread that read the request answers
  quick,  ///< milliseconds
  slow,   ///< a second or more
};

class Lanes {
 public:
  struct Settings {
    unsigned quick = 2;
    unsigned slow = 2;
  };

  /// @throws MissingResource if the system has no room for the threads.
  explicit Lanes(const Settings& settings);
  ~Lanes();
  Lanes(const Lanes&) = delete;
  Lanes& operator=(const Lanes&) = delete;

  /// The task is called once, on a thread of that lane, in the order in which tasks came; it must
  /// not throw.
  void add(Lane lane, std::function<void()> task);

  /// Lets no task begin that has not begun: those are called one after another by the caller, who
  /// has seen to it that they end at once. Waits so long for those that have; whether all ended.
  bool stop(std::chrono::duration<double> patience);

 private:
  struct One {
    std::deque<std::function<void()>> tasks;
    std::condition_variable more;
  };
  void serve(One& lane);

  std::mutex mutex_;
  std::condition_variable idle_;
  std::array<One, 2> lanes_;
  unsigned busy_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace changeover::serve

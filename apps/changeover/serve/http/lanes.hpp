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
#include <map>
#include <mutex>
#include <optional>
#include <string>
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

// Connections that take too long are closed: who sends a letter a second holds nothing for long.

/// What a connection is waited for.
enum class Stage : std::uint8_t {
  head,      ///< the lines of a request
  body,      ///< its body
  answer,    ///< us: no limit here
  reading,   ///< that it takes the answer
  listening  ///< it listens to events, as long as it likes
};

class Deadlines {
 public:
  using Seconds = std::chrono::duration<double>;

  struct Settings {
    Seconds head{20};
    Seconds body{60};
    Seconds reading{300};
    // With more connections than this, those that were waited for longest make room, after this
    // time: a client that only holds connections keeps no other out. Of one address the server
    // takes twice as many.
    std::size_t crowd = 250;
    Seconds in_a_crowd{0.5};
  };

  /// `timed_out` is sent to who is too slow with a request that has begun, before the connection is
  /// closed.
  Deadlines(const Settings& settings, std::string timed_out);
  ~Deadlines();
  Deadlines(const Deadlines&) = delete;
  Deadlines& operator=(const Deadlines&) = delete;

  /// A connection that is open until close(), and not closed by another thread meanwhile.
  void open(int socket);
  void enter(int socket, Stage stage);
  /// A request has begun on it: its first line is there.
  void hear(int socket);
  void close(int socket);

  /// Waits until no answer is being made or read, but no longer than this.
  void wait_for_answers(Seconds patience);

  /// How many connections are open.
  [[nodiscard]] std::size_t open_connections();

 private:
  using Clock = std::chrono::steady_clock;
  struct Open {
    Stage stage = Stage::head;
    Clock::time_point since;
    bool begun = false;
    std::optional<Clock::time_point> ended = std::nullopt;  ///< when its end was first seen
  };
  void run();
  void make_room(Clock::time_point now);
  void let_go(int socket, Open& open, Clock::time_point now) const;
  [[nodiscard]] static bool is_abandoned(int socket, Open& open, Clock::time_point now);
  [[nodiscard]] bool is_late(const Open& open, Clock::time_point now) const;

  Settings settings_;
  std::string timed_out_;
  std::mutex mutex_;
  std::condition_variable ending_;
  std::condition_variable answered_;
  bool ended_ = false;
  std::map<int, Open> open_;
  std::thread thread_;
};

}  // namespace changeover::serve

// Connections that take too long are closed: who sends a letter a second holds nothing for long.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace changeover::serve {

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

  /// How many connections are open.
  [[nodiscard]] std::size_t open_connections();

 private:
  using Clock = std::chrono::steady_clock;
  struct Open {
    Stage stage = Stage::head;
    Clock::time_point since;
    bool begun = false;
  };
  void run();
  void make_room(Clock::time_point now);
  void let_go(int socket, Open& open, Clock::time_point now) const;
  [[nodiscard]] bool is_late(const Open& open, Clock::time_point now) const;

  Settings settings_;
  std::string timed_out_;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool ended_ = false;
  std::map<int, Open> open_;
  std::thread thread_;
};

}  // namespace changeover::serve

// Server-sent events: what happens is published once and reaches every client that listens.
//
//     EventHub hub;
//     auto feed = hub.listen();                       // for one client: Response::events
//     hub.publish("search", "1", R"({"id":1})");  // the last of each key, at most 5 a second
//     hub.close();                                    // every feed ends
//
// A feed that nothing was said in for a while says so in a comment, so that a client that has gone
// is noticed.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace changeover::serve {

/// What one client has not read yet. Thread-safe.
class EventFeed {
 public:
  enum class Read : std::uint8_t { some, nothing_yet, ended };

  /// Moves up to room.size() bytes there, and says how many. If there are none yet, `pause` is
  /// called before anything can come, and the function given to on_more() once something has.
  Read read(std::span<char> room, std::size_t& count, const std::function<void()>& pause);

  /// Called from another thread when a feed that paused has more, or has ended.
  void on_more(std::function<void()> go_on);

 private:
  friend class EventHub;
  void put(std::string_view frames);
  void end();
  void wake(std::unique_lock<std::mutex> lock);

  std::mutex mutex_;
  std::string text_;
  bool ended_ = false;
  bool paused_ = false;
  std::function<void()> go_on_;
  std::map<std::pair<std::string, std::string>, std::string>
      pending_;  // of the hub, under its mutex
};

class EventHub {
 public:
  EventHub();
  ~EventHub();
  EventHub(const EventHub&) = delete;
  EventHub& operator=(const EventHub&) = delete;

  /// A feed that begins with `event: hello`. It is dropped when the caller lets go of it.
  [[nodiscard]] std::shared_ptr<EventFeed> listen();

  /// How many feeds are held.
  [[nodiscard]] std::size_t listeners();

  /// `data` is one line.
  void publish(const std::string& event, const std::string& key, const std::string& data);

  /// Ends all feeds; no function of on_more() is called any more when it returns. Not from two
  /// threads at once.
  void close();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable closing_;
  bool closed_ = false;
  std::vector<std::weak_ptr<EventFeed>> feeds_;
  std::thread thread_;
};

}  // namespace changeover::serve

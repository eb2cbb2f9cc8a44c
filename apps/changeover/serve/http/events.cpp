#include "serve/http/events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace changeover::serve {
namespace {

constexpr std::chrono::milliseconds between_events{200};
constexpr int beats_of_silence = 40;  // eight seconds
// Who does not read is not waited for: a feed that holds more than this has ended.
constexpr std::size_t most_unread = 1 << 20;

}  // namespace

EventFeed::Read EventFeed::read(std::span<char> room, std::size_t& count,
                                const std::function<void()>& pause) {
  const std::scoped_lock lock(mutex_);
  count = std::min(room.size(), text_.size());
  if (count > 0) {
    std::copy_n(text_.begin(), count, room.begin());
    text_.erase(0, count);
    return Read::some;
  }
  if (ended_) {
    return Read::ended;
  }
  paused_ = true;
  pause();
  return Read::nothing_yet;
}

void EventFeed::on_more(std::function<void()> go_on) {
  const std::scoped_lock lock(mutex_);
  go_on_ = std::move(go_on);
}

void EventFeed::wake(std::unique_lock<std::mutex> lock) {
  if (!paused_) {
    return;
  }
  paused_ = false;
  const std::function<void()> go_on = go_on_;
  lock.unlock();
  if (go_on) {
    go_on();
  }
}

void EventFeed::put(std::string_view frames) {
  std::unique_lock lock(mutex_);
  if (text_.size() + frames.size() > most_unread) {
    ended_ = true;
    text_.clear();
  } else {
    text_ += frames;
  }
  wake(std::move(lock));
}

void EventFeed::end() {
  std::unique_lock lock(mutex_);
  ended_ = true;
  wake(std::move(lock));
}

EventHub::EventHub() : thread_([this] { run(); }) {}

EventHub::~EventHub() { close(); }

std::shared_ptr<EventFeed> EventHub::listen() {
  auto feed = std::make_shared<EventFeed>();
  feed->put("event: hello\ndata: {}\n\n");
  const std::scoped_lock lock(mutex_);
  if (closed_) {
    feed->end();
  } else {
    feeds_.push_back(feed);
  }
  return feed;
}

std::size_t EventHub::listeners() {
  const std::scoped_lock lock(mutex_);
  std::erase_if(feeds_, [](const auto& each) { return each.expired(); });
  return feeds_.size();
}

void EventHub::publish(const std::string& event, const std::string& key, const std::string& data) {
  const std::scoped_lock lock(mutex_);
  for (const auto& each : feeds_) {
    if (const auto feed = each.lock()) {
      feed->pending_[{event, key}] = data;
    }
  }
}

void EventHub::close() {
  std::vector<std::weak_ptr<EventFeed>> feeds;
  {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    feeds.swap(feeds_);
    closing_.notify_all();
  }
  // It wakes no listener from here on: the listener may go away.
  if (thread_.joinable()) {
    thread_.join();
  }
  for (const auto& each : feeds) {
    if (const auto feed = each.lock()) {
      feed->end();
    }
  }
}

void EventHub::run() {
  int beat = 0;
  std::unique_lock lock(mutex_);
  while (!closing_.wait_for(lock, between_events, [this] { return closed_; })) {
    beat = (beat + 1) % beats_of_silence;
    std::erase_if(feeds_, [](const auto& each) { return each.expired(); });
    std::vector<std::pair<std::shared_ptr<EventFeed>, std::string>> sent;
    for (const auto& each : feeds_) {
      const auto feed = each.lock();
      if (!feed) {
        continue;
      }
      std::string frames;
      for (const auto& [what, data] : feed->pending_) {
        frames += fmt::format("event: {}\ndata: {}\n\n", what.first, data);
      }
      feed->pending_.clear();
      frames += frames.empty() && beat == 0 ? ": still here\n\n" : "";
      if (!frames.empty()) {
        sent.emplace_back(feed, std::move(frames));
      }
    }
    lock.unlock();
    for (const auto& [feed, frames] : sent) {
      feed->put(frames);
    }
    sent.clear();
    lock.lock();
  }
}

}  // namespace changeover::serve

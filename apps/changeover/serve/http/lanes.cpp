#include "serve/http/lanes.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <utility>
#include <vector>

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

Deadlines::Deadlines(const Settings& settings, std::string timed_out)
    : settings_(settings), timed_out_(std::move(timed_out)), thread_([this] { run(); }) {}

Deadlines::~Deadlines() {
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    ending_.notify_all();
  }
  thread_.join();
}

void Deadlines::open(int socket) {
  const std::scoped_lock lock(mutex_);
  open_[socket] = {Stage::head, Clock::now()};
}

void Deadlines::enter(int socket, Stage stage) {
  const std::scoped_lock lock(mutex_);
  if (const auto found = open_.find(socket); found != open_.end()) {
    found->second = {stage, Clock::now()};
    answered_.notify_all();
  }
}

void Deadlines::hear(int socket) {
  const std::scoped_lock lock(mutex_);
  if (const auto found = open_.find(socket); found != open_.end()) {
    found->second.begun = true;
  }
}

void Deadlines::close(int socket) {
  const std::scoped_lock lock(mutex_);
  open_.erase(socket);
  answered_.notify_all();
}

void Deadlines::wait_for_answers(Seconds patience) {
  const auto waits = [](const std::map<int, Open>::value_type& each) {
    return each.second.stage == Stage::answer || each.second.stage == Stage::reading;
  };
  std::unique_lock lock(mutex_);
  answered_.wait_for(lock, patience, [&] { return std::ranges::none_of(open_, waits); });
}

std::size_t Deadlines::open_connections() {
  const std::scoped_lock lock(mutex_);
  return open_.size();
}

bool Deadlines::is_late(const Open& open, Clock::time_point now) const {
  const Seconds waited = now - open.since;
  switch (open.stage) {
    case Stage::head:
      return waited > settings_.head;
    case Stage::body:
      return waited > settings_.body;
    case Stage::reading:
      return waited > settings_.reading;
    case Stage::answer:
    case Stage::listening:
      break;
  }
  return false;
}

// Whether all that came was read, and no more will come: libmicrohttpd does not see an end that
// came with the last bytes, and waits for the rest of a head or a body.
static bool has_ended(int socket) {
  char byte = 0;
  const ssize_t got = ::recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  // An error, such as a reset, is reported once: libmicrohttpd will not see it.
  return got == 0 || (got < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
}

// What has ended may be a whole request that a thread is about to answer: that takes it no second.
bool Deadlines::is_abandoned(int socket, Open& open, Clock::time_point now) {
  constexpr std::chrono::seconds about_to_be_answered{1};
  const bool waits = open.stage == Stage::body || (open.stage == Stage::head && open.begun);
  if (!waits || !has_ended(socket)) {
    return false;
  }
  open.ended = open.ended.value_or(now);
  return now - *open.ended > about_to_be_answered;
}

void Deadlines::let_go(int socket, Open& open, Clock::time_point now) const {
  if (open.stage == Stage::body || (open.stage == Stage::head && open.begun)) {
    static_cast<void>(
        ::send(socket, timed_out_.data(), timed_out_.size(), MSG_DONTWAIT | MSG_NOSIGNAL));
  }
  // The thread that reads from it sees the end, and closes it.
  ::shutdown(socket, SHUT_RDWR);
  open = {Stage::answer, now};
}

void Deadlines::make_room(Clock::time_point now) {
  if (open_.size() <= settings_.crowd) {
    return;
  }
  using Waiting = std::map<int, Open>::value_type;
  std::vector<Waiting*> waiting;
  for (Waiting& each : open_) {
    const Stage stage = each.second.stage;
    if (stage != Stage::answer && stage != Stage::listening &&
        now - each.second.since > settings_.in_a_crowd) {
      waiting.push_back(&each);
    }
  }
  std::ranges::sort(waiting, {}, [](const Waiting* each) { return each->second.since; });
  waiting.resize(std::min(waiting.size(), open_.size() - settings_.crowd));
  for (Waiting* const each : waiting) {
    let_go(each->first, each->second, now);
  }
}

void Deadlines::run() {
  constexpr std::chrono::milliseconds between_looks{200};
  std::unique_lock lock(mutex_);
  while (!ending_.wait_for(lock, between_looks, [this] { return ended_; })) {
    const Clock::time_point now = Clock::now();
    for (auto& [socket, open] : open_) {
      if (is_abandoned(socket, open, now)) {
        ::shutdown(socket, SHUT_RDWR);
        open = {Stage::answer, now};
      } else if (is_late(open, now)) {
        let_go(socket, open, now);
      }
    }
    make_room(now);
  }
}

}  // namespace changeover::serve

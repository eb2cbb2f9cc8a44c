// Jobs that run beside the server's answers, each on its own thread: begun up to a limit,
// found by number, stopped, and the last that ended remembered.
//
//     JobList<Job> jobs(2, 50);                // at once; remembered
//     const std::uint64_t id = jobs.start("searches that run", make, run);
//     jobs.find(id);
//     jobs.stop_all(900ms);
//
// A Job is a ListedJob with a static `missing_defect(id)`, which says that find() has none; if it
// has `bytes()`, jobs that ended are also forgotten, oldest first, while together they hold more
// than a limit. The last that ended stays.
#pragma once

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "changeover/run/control.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// What all jobs have.
struct ListedJob {
  std::uint64_t id = 0;
  std::unique_ptr<RunControl> control;
  std::thread thread;

  mutable std::mutex mutex;  // of all below, and of what the job itself has
  std::string state = "running";
  double seconds = 0;

  [[nodiscard]] bool running() const {
    const std::scoped_lock lock(mutex);
    return state == "running";
  }
};

template <typename Job>
class JobList {
 public:
  JobList(unsigned at_once, std::size_t remembered,
          std::size_t most_bytes = std::numeric_limits<std::size_t>::max())
      : at_once_(at_once), remembered_(remembered), most_bytes_(most_bytes) {}
  /// Stops all and waits for them.
  ~JobList() {
    ask_all();
    for (const auto& [id, job] : jobs_) {
      job->thread.join();
    }
  }
  JobList(const JobList&) = delete;
  JobList& operator=(const JobList&) = delete;

  /// Begins the job that `make` fills in, its control included, and returns its number; `run` is
  /// called on its thread, which gives way to those that answer. @throws Refusal 429 if as many run
  /// as may, which `what` names.
  template <typename Make, typename Run>
  std::uint64_t start(std::string_view what, Make&& make, Run run) {
    const std::scoped_lock lock(mutex_);
    const auto running =
        std::ranges::count_if(jobs_, [](const auto& each) { return each.second->running(); });
    if (running >= static_cast<std::ptrdiff_t>(at_once_)) {
      throw Refusal{429, fmt::format("{}: {}, as many as may; wait for one to end, or stop it",
                                     what, running)};
    }
    forget_old(remembered_ - 1);
    const auto job = std::make_shared<Job>();
    job->id = next_++;
    make(*job);
    job->thread = std::thread([run, one = job.get()] {
      constexpr int gives_way = 10;
      static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), gives_way));
      run(*one);
    });
    jobs_[job->id] = job;
    return job->id;
  }

  /// @throws Refusal 404 if it is not remembered
  [[nodiscard]] std::shared_ptr<Job> find(std::uint64_t id) {
    const std::scoped_lock lock(mutex_);
    forget_old(remembered_);
    const auto found = jobs_.find(id);
    if (found == jobs_.end()) {
      throw Refusal{404, Job::missing_defect(id)};
    }
    return found->second;
  }

  /// Asks it to stop. @throws as find()
  void stop(std::uint64_t id) { find(id)->control->stop(WhyStopped::interrupted); }

  /// All, latest first.
  [[nodiscard]] std::vector<std::shared_ptr<Job>> all() const {
    const std::scoped_lock lock(mutex_);
    std::vector<std::shared_ptr<Job>> list;
    for (auto at = jobs_.rbegin(); at != jobs_.rend(); ++at) {
      list.push_back(at->second);
    }
    return list;
  }

  /// Asks all to stop and waits so long; whether all have.
  [[nodiscard]] bool stop_all(std::chrono::duration<double> patience) {
    ask_all();
    const auto list = all();
    constexpr std::chrono::milliseconds between_looks{10};
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::ranges::any_of(list, [](const auto& job) { return job->running(); })) {
      if (std::chrono::steady_clock::now() >= end) {
        return false;
      }
      std::this_thread::sleep_for(between_looks);
    }
    return true;
  }

 private:
  void ask_all() {
    for (const auto& job : all()) {
      job->control->stop(WhyStopped::interrupted);
    }
  }

  // With mutex_ held. Of jobs that ended the oldest go first.
  void forget_old(std::size_t remembered) {
    std::vector<std::uint64_t> ended;
    std::size_t bytes = 0;
    for (const auto& [id, job] : jobs_) {
      if (!job->running()) {
        ended.push_back(id);
        bytes += bytes_of(*job);
      }
    }
    for (const std::uint64_t id : ended) {
      const bool is_last = id == ended.back();
      if (jobs_.size() <= remembered && (bytes <= most_bytes_ || is_last)) {
        return;
      }
      const auto at = jobs_.find(id);
      bytes -= bytes_of(*at->second);
      at->second->thread.join();
      jobs_.erase(at);
    }
  }

  static std::size_t bytes_of(const Job& job) {
    if constexpr (requires { job.bytes(); }) {
      return job.bytes();
    }
    return 0;
  }

  unsigned at_once_;
  std::size_t remembered_;
  std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::map<std::uint64_t, std::shared_ptr<Job>> jobs_;
  std::uint64_t next_ = 1;
};

}  // namespace changeover::serve

// Plans that are searched for while their page looks on: begun, followed, stopped with the best so
// far, and written as files.
//
//     PlanJobs jobs(events, {.at_once = 4});
//     const std::uint64_t id = jobs.start(std::move(opened), std::move(asked), 60);
//     jobs.json(id);            // state, the best so far against its bound; the answer at last
//     jobs.stop(id);                 // the best so far is the answer
//     jobs.file(id, "xlsx");
//
// Each has a thread that gives way to those that answer. The last ten that ended are remembered,
// fewer if they are large. An answer that is too large for one document is told of in `message`;
// its files are there.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "changeover/plan/job_request.hpp"
#include "serve/http/events.hpp"
#include "serve/http/message.hpp"
#include "serve/jobs/job_list.hpp"

namespace changeover::serve {

class PlanJobs {
 public:
  struct Settings {
    unsigned at_once = 4;
    std::uint64_t memory_bytes = 0;                         ///< of each
    std::size_t answer_bytes = std::size_t{32} << 20;       ///< of an answer or a file
    std::size_t remembered_bytes = std::size_t{256} << 20;  ///< of all that have ended
  };

  PlanJobs(EventHub& events, const Settings& settings);
  /// Stops all and waits for them.
  ~PlanJobs();
  PlanJobs(const PlanJobs&) = delete;
  PlanJobs& operator=(const PlanJobs&) = delete;

  /// Begins to plan, for so many seconds at most. @throws Refusal 429 if as many plans are searched
  /// for as may be.
  std::uint64_t start(const CheckedJobRequest& asked, double seconds);

  /// Asks for the best so far. @throws Refusal 404, as all below.
  void stop(std::uint64_t id);

  /// Asks all to stop and waits so long; whether all have.
  bool stop_all(std::chrono::duration<double> patience);

  /// {"id", "state", "seconds", "limit", "phase", "tests", "best", "bound", "message", "answer"};
  /// the answer is null until there is one. All who ask share the bytes of one that has ended.
  [[nodiscard]] Response answer(std::uint64_t id) const;

  /// The answer in a format of changeover plan. @throws Refusal 404 until there is one,
  /// 413 if it is too large; BadOption
  [[nodiscard]] std::string file(std::uint64_t id, const std::string& format) const;

 private:
  struct Job;
  void run(Job& job);
  void publish(const Job& job);

  EventHub& events_;
  Settings settings_;
  std::unique_ptr<JobList<Job>> jobs_;
};

}  // namespace changeover::serve

#include "serve/plans/plan_jobs.hpp"

#include <fmt/format.h>

#include <mutex>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"
#include "io/write/json_writer.hpp"
#include "serve/http/message.hpp"
#include "serve/plans/plan_answers.hpp"

namespace changeover::serve {
namespace {

constexpr std::size_t most_remembered = 10;

}  // namespace

struct PlanJobs::Job : ListedJob {
  static std::string missing_defect(std::uint64_t id) {
    return fmt::format("plan {} is not remembered any more; plan again", id);
  }

  std::optional<CheckedJobRequest> asked = {};
  double limit = 0;
  std::string message = {};  // why there is no answer, or that it may not be the best
  std::string phase = "reading the job";
  std::optional<PlanNews> best = {};
  std::optional<PlanAnswer> answer = {};
  std::size_t answer_bytes = 0;
  std::optional<std::string> answer_json = {};
  std::optional<Response> ended = {};  // once it was asked for; it holds the answer then

  [[nodiscard]] std::size_t bytes() const {
    const std::scoped_lock lock(mutex);
    return answer_bytes;
  }
  // With the mutex held.
  void write(JsonWriter& json, bool with_answer) const;
};

void PlanJobs::Job::write(JsonWriter& json, bool with_answer) const {
  json.begin_object().key("id").value(id).key("state").value(state);
  json.key("seconds").value(seconds).key("limit").value(limit).key("phase").value(phase);
  const auto amount = [&](Amount PlanNews::*field) {
    best ? json.raw(to_string((*best).*field)) : json.null();
  };
  json.key("tests").value(best ? std::optional(best->tests) : std::nullopt);
  json.key("best");
  amount(&PlanNews::cost);
  json.key("bound");
  amount(&PlanNews::bound);
  json.key("message").value(message);
  if (with_answer) {
    json.key("answer");
    answer_json ? json.raw(*answer_json) : json.null();
  }
  json.end_object();
}

PlanJobs::PlanJobs(EventHub& events, const Settings& settings)
    : events_(events),
      settings_(settings),
      jobs_(std::make_unique<JobList<Job>>(settings.at_once, most_remembered,
                                           settings.remembered_bytes)) {}

PlanJobs::~PlanJobs() = default;

std::uint64_t PlanJobs::start(const CheckedJobRequest& asked, double seconds) {
  return jobs_->start(
      "plans that are searched for",
      [&](Job& job) {
        job.asked = asked;
        job.limit = seconds;
        RunControl::Settings settings;
        settings.time = std::chrono::duration<double>(seconds);
        settings.seed = asked.request().seed.value_or(settings.seed);
        settings.memory_bytes = settings_.memory_bytes;
        settings.progress_interval = std::chrono::duration<double>(0.25);
        settings.on_progress = [this, one = &job](const Progress& progress) {
          {
            const std::scoped_lock own(one->mutex);
            one->seconds = progress.elapsed.count();
            one->phase = progress.phase;
          }
          publish(*one);
        };
        job.control = std::make_unique<RunControl>(std::move(settings));
      },
      [this](Job& job) { run(job); });
}

void PlanJobs::run(Job& job) {
  publish(job);
  std::optional<PlanAnswer> answer;
  std::optional<std::string> json;
  std::string fault;
  std::string shortage;
  try {
    const RunScope scope(*job.control);
    answer = answer_to(*job.asked, *job.control, [&](const PlanNews& news) {
      {
        const std::scoped_lock lock(job.mutex);
        job.best = news;
        job.seconds = job.control->elapsed().count();
      }
      publish(job);
    });
    if (const auto& short_of = answer->shortage()) {
      shortage = "the plan may not be the best that could be found: " + *short_of;
    }
    json = plan_json(*job.asked, *answer, settings_.answer_bytes);
    json->pop_back();  // its end of line
  } catch (const Refusal& refusal) {
    shortage = refusal.message;
  } catch (const Stopped&) {
    fault = "stopped before there was a plan";
  } catch (const std::exception& failure) {
    fault = failure.what();
  }
  {
    const std::scoped_lock lock(job.mutex);
    job.seconds = job.control->elapsed().count();
    job.state = !fault.empty()                                          ? "failed"
                : job.control->why_stopped() == WhyStopped::interrupted ? "stopped"
                                                                        : "done";
    job.message = !fault.empty() ? fault : shortage;
    job.answer_bytes = (answer ? bytes_of(*answer) : 0) + (json ? json->size() : 0);
    job.answer = std::move(answer);
    job.answer_json = std::move(json);
  }
  publish(job);
}

void PlanJobs::publish(const Job& job) {
  JsonWriter json;
  {
    const std::scoped_lock lock(job.mutex);
    job.write(json, false);
  }
  events_.publish("plan", std::to_string(job.id), json.take());
}

void PlanJobs::stop(std::uint64_t id) { jobs_->stop(id); }

bool PlanJobs::stop_all(std::chrono::duration<double> patience) {
  return jobs_->stop_all(patience);
}

Response PlanJobs::answer(std::uint64_t id) const {
  const auto job = jobs_->find(id);
  const std::scoped_lock lock(job->mutex);
  if (job->ended) {
    return *job->ended;
  }
  JsonWriter json;
  job->write(json, true);
  Response response = json_response(json.take() + "\n");
  if (job->state != "running") {
    job->ended = response;
    job->answer_json.reset();
  }
  return response;
}

std::string PlanJobs::file(std::uint64_t id, const std::string& format) const {
  const auto job = jobs_->find(id);
  const std::scoped_lock lock(job->mutex);
  if (!job->answer) {
    throw Refusal{404, job->state == "running"
                           ? fmt::format("plan {} has no answer yet; wait for it, or stop it", id)
                           : fmt::format("plan {} ended without an answer; plan again", id)};
  }
  return plan_file(*job->asked, *job->answer, format, settings_.answer_bytes);
}

}  // namespace changeover::serve

#include "plan/search/one_list.hpp"

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

class OneList {
 public:
  OneList(const Job& job, const PlanOptions& options, RunControl& control, const ListWork& work)
      : job_(job), options_(options), control_(control), work_(work) {}

  RunPlan run() {
    const RunScope scope(control_);
    plan_.objective = options_.objective;
    plan_.bound = bound_of_valid_job(job_);
    if (options_.budget && work_.most_weight) {  // before the time is up
      most_weight_ = work_.most_weight(*options_.budget);
    }
    if (job_.needed.size() == 0 && job_.triples.empty()) {
      plan_.candidates.push_back(counted(job_, {"no test", "nothing is left to test", {}}));
    } else {
      find_complete();
    }
    std::ranges::stable_sort(plan_.candidates, work_.better);
    if (options_.budget) {
      plan_.complete = plan_.candidates.front();
    }
    if (options_.budget && plan_.complete->cost > *options_.budget) {
      find_affordable(*options_.budget);
    } else if (work_.at_last) {
      keep_what_there_is(plan_, [&] { put_in_better_order(plan_.candidates.front()); });
    }
    settle(job_, plan_, control_);
    return std::move(plan_);
  }

 private:
  void find_complete() {
    for (const Start& start : work_.sure(plan_)) {
      add_complete(job_, plan_, options_, start, work_.better);
    }
    add_rest();
    keep_what_there_is(plan_, [&] { work_.search(plan_); });
  }

  // The remaining set-ups of the current list that break no constraint: unchanged if they do the
  // job; and mended.
  void add_rest() {
    const std::vector<Block> rest = sound_rest(job_, options_);
    if (rest.empty()) {
      return;
    }
    if (run_sheet(job_, rest).does_the_job()) {
      add_complete(job_, plan_, options_, rest_as_it_is(rest), work_.better);
    }
    keep_what_there_is(plan_, [&] {
      if (auto whole = work_.mended(rest)) {
        add_complete(job_, plan_, options_, rest_mended(*std::move(whole)), work_.better);
      }
    });
  }

  // What was searched for is listed only if it is better than the beginnings of complete lists.
  void find_affordable(Amount budget) {
    std::vector<Candidate> within = affordable(job_, plan_.candidates, budget, control_);
    plan_.most_weight = most_weight_;
    keep_what_there_is(plan_, [&] {
      if (control_.stop_wanted()) {
        return;
      }
      std::vector<Candidate> found;
      for (const Start& start : work_.within(plan_, budget, within.front())) {
        found.push_back(counted(job_, start));
      }
      const auto best = std::ranges::min_element(found, tests_more);
      if (best != found.end() && tests_more(*best, within.front())) {
        within.insert(within.begin(), std::move(*best));
      }
    });
    check_within(within, budget, plan_.most_weight);
    plan_.candidates = std::move(within);
  }

  void put_in_better_order(Candidate& candidate) const {
    const Start better = work_.at_last(candidate);
    if (better.setups == candidate.setups) {
      return;
    }
    Candidate other = counted_complete(job_, better);
    if (other.cost > candidate.cost) {
      throw InternalError("a better order costs more");
    }
    candidate = std::move(other);
  }

  const Job& job_;
  const PlanOptions& options_;
  RunControl& control_;
  const ListWork& work_;
  RunPlan plan_;
  std::optional<Amount> most_weight_;
};

}  // namespace

RunPlan plan_one_list(const Job& job, const PlanOptions& options, RunControl& control,
                      const ListWork& work) {
  return OneList(job, options, control, work).run();
}

}  // namespace changeover

// The data for a search on several benches: the job of each working bench, the job after the first
// set-ups, scarce parts and hours.
//
//     const BenchField field(job, benches);
//     // lists of what comes after the first set-ups
//     Lists lists(field.lists_job(100), BenchLists(field.size()));
//     count_benches(job, benches, field.schedule(lists.lists()));
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

class BenchField {
 public:
  /// Needs benches without defects. Both must outlive this. @throws Stopped
  BenchField(const Job& job, const std::vector<Bench>& benches)
      : BenchField(job, benches, nullptr) {}
  /// For some of the pairs of a field without triples, and some of its working benches; the others
  /// are down. What can meet where is taken from the field.
  BenchField(const Job& job, const std::vector<Bench>& benches, const BenchField& wider)
      : BenchField(job, benches, &wider) {}
  BenchField(const BenchField&) = delete;
  BenchField& operator=(const BenchField&) = delete;

  /// The number of working benches; they are counted from 0, without those that are down.
  [[nodiscard]] std::size_t size() const { return working_.size(); }
  [[nodiscard]] const Job& asked() const { return *job_; }
  [[nodiscard]] const std::vector<Bench>& benches() const { return *benches_; }
  [[nodiscard]] const Bench& bench(std::size_t w) const { return (*benches_)[working_[w]]; }
  /// What must meet after all first set-ups.
  [[nodiscard]] const Job& common() const { return common_; }
  /// The job of a bench, with its first set-ups.
  [[nodiscard]] const Job& whole(std::size_t w) const { return *whole_[w]; }
  /// The same without them: the pairs that they test are not needed, and the last one is the start.
  [[nodiscard]] const Job& rest(std::size_t w) const { return *rest_[w]; }
  /// The cost of the first set-ups of a bench.
  [[nodiscard]] Amount spent(std::size_t w) const { return spent_[w]; }
  /// Whether all benches have the same job, except for scarce parts and hours.
  [[nodiscard]] bool alike() const { return jobs_.size() <= 2; }
  /// Whether parts are scarce or benches rest: then the makespan is more than a sum.
  [[nodiscard]] bool has_clock() const { return rules_.has_value(); }
  /// Whether several benches share a part of which there is one.
  [[nodiscard]] bool has_single_parts() const;
  [[nodiscard]] const std::optional<ClockRules>& rules() const { return rules_; }
  /// The number of benches that may hold a part at a time.
  [[nodiscard]] std::uint64_t most_holders(Element x) const { return holders_[x]; }

  /// More tests than any list needs.
  [[nodiscard]] std::uint64_t most_tests() const {
    return common_.needed.size() + common_.triples.size() + 64;
  }
  /// For lists with this many tests. If `exact`, things that cost nothing have weight 0.
  [[nodiscard]] ListsJob lists_job(std::uint64_t tests, bool exact = false) const;

  /// Gives times to the first set-ups of each bench and these lists, each step as early as
  /// possible; by bench, including those that are down. @throws ImpossibleParameters if a time
  /// overflows.
  [[nodiscard]] BenchSchedule schedule(const BenchLists& lists) const;

 private:
  BenchField(const Job& job, const std::vector<Bench>& benches, const BenchField* wider);
  void add_jobs(const BenchField* wider);
  [[nodiscard]] Job own_job(std::size_t w, const BenchField* wider) const;
  void set_rules();

  const Job* job_;
  const std::vector<Bench>* benches_;
  std::vector<std::size_t> working_;
  std::deque<Job> jobs_;  // owns the jobs, two for each kind of bench
  std::vector<const Job*> whole_;
  std::vector<const Job*> rest_;
  std::vector<Amount> spent_;
  Job common_;
  std::optional<ClockRules> rules_;
  std::shared_ptr<const CompiledRules> values_;  // of the model
  std::vector<std::uint64_t> holders_;
};

}  // namespace changeover

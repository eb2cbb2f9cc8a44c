// What a search for several benches works on: the job of each bench that works, what is left when
// the first set-ups are run, scarce parts and hours.
//
//     const BenchField field(job, benches);
//     // lists of what comes after the first set-ups
//     Lists lists(field.lists_job(100), BenchLists(field.size()));
//     count_benches(job, benches, field.schedule(lists.lists()));
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

class BenchField {
 public:
  /// Benches without defects. Both must outlive this. @throws Stopped
  BenchField(const Job& job, const std::vector<Bench>& benches);
  BenchField(const BenchField&) = delete;
  BenchField& operator=(const BenchField&) = delete;

  /// How many benches work; they are counted from 0, without those that are down.
  [[nodiscard]] std::size_t size() const { return working_.size(); }
  [[nodiscard]] const Job& asked() const { return *job_; }
  [[nodiscard]] const std::vector<Bench>& benches() const { return *benches_; }
  [[nodiscard]] const Bench& bench(std::size_t w) const { return (*benches_)[working_[w]]; }
  /// What must meet when all first set-ups have been run.
  [[nodiscard]] const Job& common() const { return common_; }
  /// The job of a bench, with its first set-ups.
  [[nodiscard]] const Job& whole(std::size_t w) const { return *whole_[w]; }
  /// The same without them: what they test is tested, the last one is mounted.
  [[nodiscard]] const Job& rest(std::size_t w) const { return *rest_[w]; }
  /// What the first set-ups of a bench cost.
  [[nodiscard]] Amount spent(std::size_t w) const { return spent_[w]; }
  /// All benches have the same job, up to what is scarce and how long they work.
  [[nodiscard]] bool alike() const { return jobs_.size() <= 2; }
  /// Parts are scarce, or benches rest: the makespan is more than a sum.
  [[nodiscard]] bool has_clock() const { return rules_.has_value(); }
  [[nodiscard]] const std::optional<ClockRules>& rules() const { return rules_; }
  /// How many benches may hold a part at a time.
  [[nodiscard]] std::uint64_t most_holders(Element x) const { return holders_[x]; }

  /// For lists of so many tests. If `exact`, what costs nothing weighs nothing.
  [[nodiscard]] ListsJob lists_job(std::uint64_t tests, bool exact = false) const;

  /// The first set-ups of each bench and these lists, each step as early as it can be; by bench,
  /// with those that are down.
  /// @throws ImpossibleParameters if a time cannot be counted.
  [[nodiscard]] BenchSchedule schedule(const BenchLists& lists) const;

 private:
  void add_jobs();
  void set_rules();

  const Job* job_;
  const std::vector<Bench>* benches_;
  std::vector<std::size_t> working_;
  std::deque<Job> jobs_;  // what the pointers point to, two for each kind of bench
  std::vector<const Job*> whole_;
  std::vector<const Job*> rest_;
  std::vector<Amount> spent_;
  Job common_;
  std::optional<ClockRules> rules_;
  std::vector<std::uint64_t> holders_;
};

}  // namespace changeover

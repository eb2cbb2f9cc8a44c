// Decides which sets of parts can be mounted together, and completes a set that lacks parts in some
// slot.
//
//     const Fitting fitting(job);
//     fitting.completed({cpu, disk}, job.start);  // with a power supply too, if a set-up needs one
//
// The planners use this; run_sheet() (plan/run_plan.hpp), which checks plans, counts independently.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

class Fitting {
 public:
  /// The job must outlive this, unchanged.
  explicit Fitting(const Job& job);

  [[nodiscard]] bool has_slots() const { return !least_.empty(); }
  [[nodiscard]] std::size_t slots() const { return least_.size(); }
  /// The slot of a part; slots() for a part in no slot.
  [[nodiscard]] std::size_t slot(Element x) const {
    return job_->slot_of.empty() || job_->slot_of[x] == no_slot ? slots() : job_->slot_of[x];
  }
  [[nodiscard]] std::uint64_t least(std::size_t slot) const {
    return slot < slots() ? least_[slot] : 0;
  }
  [[nodiscard]] std::uint64_t most(std::size_t slot) const {
    return slot < slots() ? most_[slot] : job_->room();
  }

  /// Completes the set with as few further parts as its slots need: those of `liked` first, then
  /// cheap ones. Nullopt if that is impossible, or neither this nor simplest() finds a way. The set
  /// must have the mounted parts and no part twice; all else is checked. O(v) per choice.
  [[nodiscard]] std::optional<Block> completed(Block setup, std::span<const Element> liked) const;

  /// The set with what its slots lack and then with those of `beside` for which there is room and
  /// that may_join(setup, part). Nullopt as completed().
  template <typename MayJoin>
  [[nodiscard]] std::optional<Block> grown(Block setup, std::span<const Element> beside,
                                           MayJoin&& may_join) const {
    std::optional<Block> whole = has_slots() ? completed(std::move(setup), beside) : setup;
    for (std::size_t i = 0; whole && i < beside.size() && whole->size() < job_->room(); ++i) {
      const std::size_t where = slot(beside[i]);
      const auto is_there = [&](Element x) { return slot(x) == where; };
      const bool has_place = where == slots() || static_cast<std::uint64_t>(std::ranges::count_if(
                                                     *whole, is_there)) < most(where);
      if (has_place && std::ranges::find(*whole, beside[i]) == whole->end() &&
          may_join(*whole, beside[i])) {
        whole->push_back(beside[i]);
      }
    }
    return whole;
  }

  struct Found {
    std::optional<Block> setup;
    bool all_tried = true;  ///< false if 100,000 choices were tried: there may still be a solution
  };
  /// The same with the first parts of each slot. The result depends only on the slots, the
  /// forbidden pairs and the room. So what is found when a job is checked is also found for jobs
  /// derived from it, with other costs or fewer needed pairs. Without forbidden pairs no choice is
  /// wrong.
  [[nodiscard]] Found simplest(Block setup) const;

 private:
  [[nodiscard]] Found search(Block setup, std::span<const Element> liked,
                             const std::vector<std::vector<Element>>& order) const;

  const Job* job_;
  std::vector<std::uint64_t> least_, most_;    // by slot
  std::vector<std::vector<Element>> members_;  // by slot
  std::vector<std::vector<Element>> cheap_;    // by slot, the cheapest first
  std::vector<std::vector<Element>> enemies_;  // by part: the parts that it must not meet
};

/// The mounted parts of a job and these, each once.
[[nodiscard]] Block with_mounted(const Job& job, std::initializer_list<Element> parts);

}  // namespace changeover

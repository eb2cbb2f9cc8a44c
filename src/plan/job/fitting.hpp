// Which sets of parts can be mounted together, and how a set that lacks parts in some slot is
// filled up.
//
//     const Fitting fitting(job);
//     fitting.completed({cpu, disk}, job.start);  // with a power supply too, if a set-up needs one
//
// This serves those who make plans. The referee (plan/run_plan.hpp) counts for itself.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

class Fitting {
 public:
  /// The job must outlive this, unchanged.
  explicit Fitting(const Job& job);

  [[nodiscard]] bool has_slots() const { return !least_.empty(); }
  [[nodiscard]] std::size_t slots() const { return least_.size(); }
  /// The slot of a part; slots() if it has none.
  [[nodiscard]] std::size_t slot(Element x) const {
    return job_->slot_of.empty() || job_->slot_of[x] == no_slot ? slots() : job_->slot_of[x];
  }
  [[nodiscard]] std::uint64_t least(std::size_t slot) const {
    return slot < slots() ? least_[slot] : 0;
  }
  [[nodiscard]] std::uint64_t most(std::size_t slot) const {
    return slot < slots() ? most_[slot] : job_->room();
  }

  /// The set with as few parts more as its slots need: those of `liked` first, then cheap ones.
  /// Nothing if that cannot be, or was not found, nor by simplest(). The set must have the mounted
  /// parts and no part twice; whether it obeys all else is found out. O(v) a choice.
  [[nodiscard]] std::optional<Block> completed(Block setup, std::span<const Element> liked) const;

  struct Found {
    std::optional<Block> setup;
    bool all_tried = true;  ///< otherwise 100,000 choices were: there may be one all the same
  };
  /// The same with the parts that come first. This depends on the slots, the forbidden pairs and
  /// the room only, so that what is found when a job is checked is found in all that is made of it,
  /// at other costs and when some pairs have met. Without forbidden pairs no choice is wrong.
  [[nodiscard]] Found simplest(Block setup) const;

 private:
  [[nodiscard]] Found search(Block setup, std::span<const Element> liked,
                             const std::vector<std::vector<Element>>& order) const;

  const Job* job_;
  std::vector<std::uint64_t> least_, most_;    // by slot
  std::vector<std::vector<Element>> members_;  // by slot
  std::vector<std::vector<Element>> cheap_;    // by slot, the cheapest first
  std::vector<std::vector<Element>> enemies_;  // by part: those that it must not meet
};

/// The mounted parts of a job and these, each once.
[[nodiscard]] Block with_mounted(const Job& job, std::initializer_list<Element> parts);

}  // namespace changeover

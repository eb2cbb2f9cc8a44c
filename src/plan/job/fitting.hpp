// Which sets of parts can be mounted together, and how a set that lacks parts in some slot is filled up.
//
//     const Fitting fitting(job);
//     fitting.completed({cpu, disk}, job.start);   // with a power supply too, if a set-up needs one
//
// This serves those who make plans. The referee (plan/run_sheet.hpp) counts for itself.
#pragma once

#include <cstdint>
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

  /// The set with as few parts more as its slots need: those of `liked` first, then cheap ones. Nothing if
  /// that cannot be, or is not found by looking 2,000,000 times at a part that may join; without forbidden pairs, the
  /// first choice is right. The set must have the mounted parts and no part twice; whether it obeys all else is found out.
  [[nodiscard]] std::optional<Block> completed(Block setup, std::span<const Element> liked) const;

 private:
  bool choose(Block& setup, std::span<const Element> liked, std::size_t slot, std::size_t from,
              std::uint64_t missing, std::uint64_t& looks) const;
  [[nodiscard]] bool joins(const Block& setup, Element y) const;

  const Job* job_;
  bool forbids_;                               // some pairs
  std::vector<std::uint64_t> least_, most_;    // by slot
  std::vector<std::vector<Element>> members_;  // by slot, the cheapest first
};

}  // namespace changeover

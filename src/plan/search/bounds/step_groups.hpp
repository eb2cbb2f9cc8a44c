// The quantities of Theorem 18 (docs/theorems.md): the parts of a job in groups, the needed pairs
// between these, and the kinds of steps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/plan/job.hpp"
#include "core/each.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/bounds/costliest_parts.hpp"
#include "plan/search/bounds/job_numbers.hpp"

namespace changeover {

/// Parts with a limit for their number in a set-up: those of a slot, or all.
struct PartGroup {
  std::vector<std::size_t> parts = {};  // indices in JobNumbers::parts
  std::uint64_t room = 0;  // c of the theorem: at least the number of parts at the start
  std::uint64_t in_a_test = 0;
};

/// Groups whose changes are counted together.
struct StepBlock {
  std::vector<std::size_t> groups;
  std::vector<std::vector<std::uint64_t>> kinds = {};  // of steps: number of parts put in, by group
  std::size_t first_column = 0;  // column of the number of steps of the first kind

  [[nodiscard]] std::optional<std::size_t> place_of(std::size_t group) const {
    const auto found = std::find(groups.begin(), groups.end(), group);
    return found == groups.end() ? std::nullopt
                                 : std::optional<std::size_t>(found - groups.begin());
  }
};

/// The groups of a job, and blocks of them. The columns of the program are those of the parts, one
/// for tests, and one for each kind of steps of each block.
class StepGroups {
 public:
  StepGroups(const Job& job, const JobNumbers& n, const CostliestParts& parts);

  [[nodiscard]] const std::vector<PartGroup>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<StepBlock>& blocks() const { return blocks_; }
  [[nodiscard]] std::size_t columns() const {
    return blocks_.empty() ? v_ + 1 : blocks_.back().first_column + blocks_.back().kinds.size();
  }

  [[nodiscard]] bool needed(std::size_t x, std::size_t y) const { return needed_[x * v_ + y]; }
  /// The number of needed pairs of a part with a group.
  [[nodiscard]] std::uint64_t degree(std::size_t x, std::size_t group) const {
    return degree_[group * v_ + x];
  }
  /// The least number of tests of a part: t_x of the theorem.
  [[nodiscard]] std::uint64_t least_on(std::size_t x) const { return least_on_[x]; }
  /// The number of needed pairs between two groups, or within one.
  [[nodiscard]] std::uint64_t pairs(std::size_t a, std::size_t b) const {
    const std::uint64_t all =
        sum_of(groups_[a].parts, [&](const std::size_t x) { return degree(x, b); });
    return a == b ? all / 2 : all;
  }
  /// The most new pairs of a step of this kind.
  [[nodiscard]] std::uint64_t brought(const StepBlock& block, std::size_t kind, std::size_t at_a,
                                      std::size_t at_b) const {
    const std::uint64_t i = block.kinds[kind][at_a];
    const std::uint64_t j = block.kinds[kind][at_b];
    const std::uint64_t c = groups_[block.groups[at_a]].room;
    const std::uint64_t d = groups_[block.groups[at_b]].room;
    return at_a == at_b ? choose_two(i) + i * (c - i) : c * d - (c - i) * (d - j);
  }

 private:
  void make_groups(const Job& job, const JobNumbers& n, const CostliestParts& parts);
  void count_needed();
  void make_blocks();
  void add_block(std::vector<std::size_t> groups);

  std::size_t v_;
  std::vector<bool> needed_;
  std::vector<PartGroup> groups_;
  std::vector<std::uint64_t> degree_;
  std::vector<std::uint64_t> least_on_;
  std::vector<StepBlock> blocks_;
};

}  // namespace changeover

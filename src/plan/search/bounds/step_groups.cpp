#include "plan/search/bounds/step_groups.hpp"

#include <numeric>
#include <utility>

#include "core/checked.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_kinds = 2100;  // of steps, per block
constexpr std::size_t most_step_columns = 7000;

}  // namespace

StepGroups::StepGroups(const Job& job, const JobNumbers& n, const CostliestParts& parts)
    : v_(parts.parts.size()), needed_(v_ * v_, false) {
  for (std::size_t x = 0; x < v_; ++x) {
    for (std::size_t y = 0; y < v_; ++y) {
      needed_[x * v_ + y] = x != y && job.needed.contains(n.parts[x], n.parts[y]);
    }
  }
  make_groups(job, n, parts);
  count_needed();
  make_blocks();
}

void StepGroups::make_groups(const Job& job, const JobNumbers& n, const CostliestParts& parts) {
  for (std::size_t s = 0; s < n.most.size(); ++s) {
    PartGroup group;
    std::uint64_t there = 0;
    for (std::size_t x = 0; x < v_; ++x) {
      if (n.slot_of[n.parts[x]] == s) {
        group.parts.push_back(x);
        there += parts.at_start[x];
      }
    }
    group.in_a_test = std::min(n.most[s], n.room);
    group.room = std::min<std::uint64_t>(std::max(group.in_a_test, there), group.parts.size());
    if (!group.parts.empty() && group.room > 0) {
      groups_.push_back(std::move(group));
    }
  }
  const std::uint64_t all = std::accumulate(
      groups_.begin(), groups_.end(), std::uint64_t{0},
      [](std::uint64_t sum, const PartGroup& group) { return sum + group.in_a_test; });
  if (all > n.room || job.slots.empty()) {
    PartGroup whole{.room = std::min<std::uint64_t>(parts.room, v_), .in_a_test = n.room};
    whole.parts.resize(v_);
    std::iota(whole.parts.begin(), whole.parts.end(), 0);
    groups_.resize(job.slots.empty() ? 0 : groups_.size());
    groups_.push_back(std::move(whole));
  }
}

void StepGroups::count_needed() {
  degree_.assign(groups_.size() * v_, 0);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (std::size_t x = 0; x < v_; ++x) {
      for (const std::size_t y : groups_[g].parts) {
        degree_[g * v_ + x] += needed(x, y) ? 1U : 0U;
      }
    }
  }
  least_on_.assign(v_, 1);
  for (const PartGroup& group : groups_) {
    const std::size_t g = static_cast<std::size_t>(&group - groups_.data());
    for (std::size_t x = 0; x < v_; ++x) {
      const bool within = std::find(group.parts.begin(), group.parts.end(), x) != group.parts.end();
      const std::uint64_t places = group.in_a_test - (within ? 1 : 0);
      if (degree(x, g) > 0 && places > 0) {
        least_on_[x] = std::max(least_on_[x], ceil_div(degree(x, g), places));
      }
    }
  }
}

// Makes blocks until every two groups with needed pairs are in one, or there are many columns.
void StepGroups::make_blocks() {
  const bool has_whole = groups_.back().parts.size() == v_;
  const std::size_t slots = has_whole ? groups_.size() - 1 : groups_.size();
  if (has_whole) {
    add_block({slots});
  }
  std::vector<std::uint64_t> open(slots * slots, 0);
  for (std::size_t a = 0; a < slots; ++a) {
    for (std::size_t b = 0; b < slots; ++b) {
      open[a * slots + b] = pairs(a, b);
    }
  }
  while (slots > 0) {
    const std::size_t first =
        static_cast<std::size_t>(std::max_element(open.begin(), open.end()) - open.begin());
    if (open[first] == 0) {
      return;
    }
    std::vector<std::size_t> groups{first / slots};
    std::size_t kinds = groups_[first / slots].room + 1;
    for (;;) {
      std::optional<std::size_t> best;
      std::uint64_t most = 0;
      for (std::size_t b = 0; b < slots; ++b) {
        std::uint64_t gain = 0;
        for (const std::size_t a : groups) {
          gain += a == b ? 0 : open[a * slots + b];
        }
        const bool fits = kinds * (groups_[b].room + 1) <= most_kinds;
        if (gain > most && fits && std::find(groups.begin(), groups.end(), b) == groups.end()) {
          most = gain;
          best = b;
        }
      }
      if (!best) {
        break;
      }
      groups.push_back(*best);
      kinds *= groups_[*best].room + 1;
    }
    if (blocks_.empty() ? kinds > 2 * most_kinds : columns() + kinds > most_step_columns) {
      return;
    }
    open[first] = open[first % slots * slots + first / slots] = 0;
    for (const std::size_t a : groups) {
      for (const std::size_t b : groups) {
        open[a * slots + b] = 0;
      }
    }
    add_block(std::move(groups));
  }
}

void StepGroups::add_block(std::vector<std::size_t> groups) {
  StepBlock block{.groups = std::move(groups)};
  block.first_column = columns();
  std::vector<std::uint64_t> kind(block.groups.size(), 0);
  for (;;) {
    std::size_t place = 0;
    while (place < kind.size() && kind[place] == groups_[block.groups[place]].room) {
      kind[place++] = 0;
    }
    if (place == kind.size()) {
      break;
    }
    ++kind[place];
    block.kinds.push_back(kind);
  }
  blocks_.push_back(std::move(block));
}

}  // namespace changeover

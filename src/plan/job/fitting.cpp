#include "plan/job/fitting.hpp"

#include <algorithm>

namespace changeover {
namespace {

constexpr std::uint64_t most_looks = 2'000'000;

bool holds(std::span<const Element> parts, Element x) {
  return std::find(parts.begin(), parts.end(), x) != parts.end();
}

}  // namespace

Fitting::Fitting(const Job& job)
    : job_(&job), forbids_(job.never.size() > 0), members_(job.slots.size()) {
  for (const Slot& slot : job.slots) {
    least_.push_back(slot.least);
    most_.push_back(std::min(slot.most, job.room()));
  }
  for (Element x = 0; x < job.parts(); ++x) {
    if (slot(x) < slots()) {
      members_[slot(x)].push_back(x);
    }
  }
  for (std::vector<Element>& members : members_) {
    std::stable_sort(members.begin(), members.end(), [&](Element x, Element y) {
      return job.change_costs[x] < job.change_costs[y];
    });
  }
}

bool Fitting::joins(const Block& setup, Element y) const {
  return std::none_of(setup.begin(), setup.end(), [&](Element z) {
    return z == y || (forbids_ && job_->never.contains(y, z));
  });
}

// Adds `missing` members of this slot, from number `from` on, and what the slots after it lack. The liked ones
// are numbered first.
bool Fitting::choose(Block& setup, std::span<const Element> liked, std::size_t slot,
                     std::size_t from, std::uint64_t missing, std::uint64_t& looks) const {
  if (missing == 0) {
    if (++slot == slots()) {
      return true;
    }
    const auto there = static_cast<std::uint64_t>(std::count_if(
        setup.begin(), setup.end(), [&](Element x) { return this->slot(x) == slot; }));
    return choose(setup, liked, slot, 0, least_[slot] - std::min(least_[slot], there), looks);
  }
  const std::vector<Element>& members = members_[slot];
  for (std::size_t i = from; i < liked.size() + members.size(); ++i) {
    const Element y = i < liked.size() ? liked[i] : members[i - liked.size()];
    if (++looks > most_looks) {
      return false;
    }
    const bool mine = i < liked.size() ? this->slot(y) == slot : !holds(liked, y);
    if (!mine || !joins(setup, y)) {
      continue;
    }
    setup.push_back(y);
    if (choose(setup, liked, slot, i + 1, missing - 1, looks)) {
      return true;
    }
    setup.pop_back();
  }
  return false;
}

std::optional<Block> Fitting::completed(Block setup, std::span<const Element> liked) const {
  std::vector<std::uint64_t> count(slots() + 1, 0);
  for (const Element x : setup) {
    ++count[slot(x)];
  }
  std::uint64_t lacking = 0;
  for (std::size_t s = 0; s < slots(); ++s) {
    if (count[s] > most_[s]) {
      return std::nullopt;
    }
    lacking += least_[s] - std::min(least_[s], count[s]);
  }
  if (setup.size() + lacking > job_->room()) {
    return std::nullopt;
  }
  if (lacking == 0) {
    return setup;
  }
  std::uint64_t looks = 0;
  const std::uint64_t missing = least_[0] - std::min(least_[0], count[0]);
  return choose(setup, liked, 0, 0, missing, looks) ? std::optional(setup) : std::nullopt;
}

}  // namespace changeover

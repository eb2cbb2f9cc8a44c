#include "plan/job/fitting.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace changeover {
namespace {

using Parts = std::vector<std::vector<Element>>;

constexpr std::uint64_t most_choices = 100'000;

// Completes a set slot by slot, as long as each slot still has enough parts that may join.
class Completion {
 public:
  // In each slot the liked parts are tried first, then its members in this order.
  Completion(const Fitting& fitting, const Parts& enemies, std::span<const Element> liked,
             const Parts& members)
      : fitting_(&fitting),
        enemies_(&enemies),
        liked_(liked),
        members_(&members),
        missing_(members.size()),
        free_(members.size()),
        against_(enemies.size()) {
    for (std::size_t s = 0; s < members.size(); ++s) {
      missing_[s] = fitting.least(s);
      free_[s] = members[s].size();
    }
  }

  void put(Element x) {
    setup_.push_back(x);
    const std::size_t s = fitting_->slot(x);
    if (s < missing_.size()) {
      missing_[s] -= missing_[s] > 0 ? 1U : 0U;
    }
    block(x);
    for (const Element enemy : (*enemies_)[x]) {
      block(enemy);
    }
  }

  bool complete() { return enough() && choose(0, 0); }

  [[nodiscard]] bool all_tried() const { return choices_ <= most_choices; }
  [[nodiscard]] Block take() { return std::move(setup_); }

 private:
  void block(Element x) {
    const std::size_t s = fitting_->slot(x);
    if (against_[x]++ == 0 && s < missing_.size()) {
      --free_[s];
    }
  }

  void unblock(Element x) {
    const std::size_t s = fitting_->slot(x);
    if (--against_[x] == 0 && s < missing_.size()) {
      ++free_[s];
    }
  }

  // Undoes put() of a part that its slot lacked.
  void take_back(Element x) {
    setup_.pop_back();
    ++missing_[fitting_->slot(x)];
    unblock(x);
    for (const Element enemy : (*enemies_)[x]) {
      unblock(enemy);
    }
  }

  [[nodiscard]] bool enough() const {
    for (std::size_t s = 0; s < missing_.size(); ++s) {
      if (free_[s] < missing_[s]) {
        return false;
      }
    }
    return true;
  }

  // Fills this slot, from number `from` of its parts on, and the slots after it.
  bool choose(std::size_t slot, std::size_t from) {
    while (slot < missing_.size() && missing_[slot] == 0) {
      ++slot;
      from = 0;
    }
    if (slot == missing_.size()) {
      return true;
    }
    const std::vector<Element>& members = (*members_)[slot];
    for (std::size_t i = from; i < liked_.size() + members.size(); ++i) {
      const Element y = i < liked_.size() ? liked_[i] : members[i - liked_.size()];
      if (against_[y] > 0 || fitting_->slot(y) != slot) {
        continue;
      }
      if (++choices_ > most_choices) {
        return false;
      }
      put(y);
      if (enough() && choose(slot, i + 1)) {
        return true;
      }
      take_back(y);
    }
    return false;
  }

  const Fitting* fitting_;
  const Parts* enemies_;  // by part
  std::span<const Element> liked_;
  const Parts* members_;                // by slot
  std::vector<std::uint64_t> missing_;  // by slot
  std::vector<std::uint64_t> free_;     // by slot: number of parts that may join
  std::vector<std::uint32_t>
      against_;  // by part: how many parts of the set-up, including itself, exclude it
  Block setup_;
  std::uint64_t choices_ = 0;
};

}  // namespace

Fitting::Fitting(const Job& job)
    : job_(&job), members_(job.slots.size()), enemies_(job.slots.empty() ? 0 : job.parts()) {
  for (const Slot& slot : job.slots) {
    least_.push_back(slot.least);
    most_.push_back(std::min(slot.most, job.room()));
  }
  for (Element x = 0; x < job.parts(); ++x) {
    if (slot(x) < slots()) {
      members_[slot(x)].push_back(x);
    }
  }
  cheap_ = members_;
  for (std::vector<Element>& members : cheap_) {
    std::ranges::stable_sort(
        members, [&](Element x, Element y) { return job.change_costs[x] < job.change_costs[y]; });
  }
  if (has_slots()) {
    job.never.for_each(std::numeric_limits<std::uint64_t>::max(), [&](Element x, Element y) {
      enemies_[x].push_back(y);
      enemies_[y].push_back(x);
    });
  }
}

Fitting::Found Fitting::search(Block setup, std::span<const Element> liked,
                               const std::vector<std::vector<Element>>& order) const {
  std::vector<std::uint64_t> count(slots() + 1, 0);
  for (const Element x : setup) {
    ++count[slot(x)];
  }
  std::uint64_t missing = 0;
  for (std::size_t s = 0; s < slots(); ++s) {
    if (count[s] > most_[s]) {
      return {};
    }
    missing += least_[s] - std::min(least_[s], count[s]);
  }
  if (setup.size() + missing > job_->room()) {
    return {};
  }
  if (missing == 0) {
    return {.setup = std::move(setup)};
  }
  Completion completion(*this, enemies_, liked, order);
  for (const Element x : setup) {
    completion.put(x);
  }
  if (completion.complete()) {
    return {.setup = completion.take()};
  }
  return {.setup = std::nullopt, .all_tried = completion.all_tried()};
}

std::optional<Block> Fitting::completed(Block setup, std::span<const Element> liked) const {
  Found found = search(setup, liked, cheap_);
  return found.all_tried ? std::move(found.setup) : simplest(std::move(setup)).setup;
}

Fitting::Found Fitting::simplest(Block setup) const {
  return search(std::move(setup), {}, members_);
}

Block with_mounted(const Job& job, std::initializer_list<Element> parts) {
  Block setup = job.mounted;
  for (const Element x : parts) {
    if (std::ranges::find(setup, x) == setup.end()) {
      setup.push_back(x);
    }
  }
  return setup;
}

}  // namespace changeover

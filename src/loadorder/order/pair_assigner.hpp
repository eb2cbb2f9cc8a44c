// Internal: assigns each pair to the step that computes it.
//
// A pair belongs to the first step that has both items in memory, or on the accelerator; workers
// follow one another, or step together. If pairs have owners, it is the first such step of its
// owner. Within a step, pairs are sorted by the arrival of the later item; of the last arrival,
// pairs with an item that is evicted next come first. An item that is evicted next is evicted early
// only if the next loads need its place. In each epoch all pairs are computed again, those in
// memory at its beginning first.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/pairs/wanted_set.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {

struct AssignedStep {
  Step step;
  std::vector<Element>
      stayed;                  ///< items in memory at the beginning of an epoch: computed alone now
  std::size_t stayed_end = 0;  ///< number of pairs, the first ones, of such items
  std::vector<Element> evicted_first;  ///< evicted by the next step, before its loads start
  std::vector<Element> evicted_late;   ///< evicted by the next step, when this one is over
  std::vector<bool> is_new;  ///< by loaded item: computed alone now, and never before at any worker
  std::vector<ItemPair> pairs;           ///< sorted by the arrival of the later item
  std::vector<std::size_t> arrival_end;  ///< by loaded item: end of its pairs
  std::size_t before = 0;                ///< number of pairs computed before the next evictions
};

class PairAssigner {
 public:
  /// `lockstep`: number of workers that step together; 0 if they follow one another. Pairs meet in
  /// memory, or on the `accelerator`, where `room` is counted. `owners`, if given, assigns the
  /// pairs, for one worker at a time. With `sizes` room is counted in bytes.
  PairAssigner(std::uint64_t items, std::uint64_t room, const WantedPairs& wanted = {},
               std::size_t lockstep = 0, bool accelerator = false,
               std::shared_ptr<const PairOwners> owners = nullptr,
               std::shared_ptr<const ItemSizes> sizes = nullptr)
      // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): it is asked before
      : room_(sizes != nullptr ? sizes->memory : room),
        sizes_(std::move(sizes)),
        come_(accelerator ? &Step::fast_load : &Step::load),
        leave_(accelerator ? &Step::fast_evict : &Step::evict),
        wanted_(wanted),
        in_lockstep_(lockstep > 0),
        owners_(std::move(owners)),
        memories_(std::max<std::size_t>(1, lockstep)),
        at_(static_cast<std::size_t>(items), 0),
        loaded_(static_cast<std::size_t>(items), false) {
    begin_epoch(1);
  }

  /// Starts with other steps: memory is empty, and pairs that were computed stay computed.
  void start(std::unique_ptr<StepSource> steps) {
    forget();
    steps_ = std::move(steps);
    has_ahead_ = !in_lockstep_ && steps_->next(ahead_);
    worker_ = ahead_.worker;
    if (has_ahead_) {
      take_rule();
    }
  }

  /// The next step, for one worker at a time; a new worker starts with an empty memory.
  bool next(AssignedStep& out) {
    if (!has_ahead_) {
      return false;
    }
    std::swap(out.step, ahead_);
    has_ahead_ = steps_->next(ahead_);
    if (out.step.worker != worker_) {
      forget();
      worker_ = out.step.worker;
      take_rule();
    }
    evict(out.step, 0);
    const bool begins = out.step.epoch != epoch_;
    if (begins) {
      begin_epoch(out.step.epoch);
    }
    const std::size_t last_arrival = arrive(out, 0, begins);
    choose_first(out);
    for (const Element x : out.evicted_first) {
      at_[x] = 0;  // temporarily: marks evicted items
    }
    const auto middle = std::stable_partition(
        out.pairs.begin() + static_cast<std::ptrdiff_t>(last_arrival), out.pairs.end(),
        [&](const ItemPair& pair) { return at_[pair.first] == 0 || at_[pair.second] == 0; });
    out.before = static_cast<std::size_t>(middle - out.pairs.begin());
    for (const Element x : out.evicted_first) {
      at_[x] = 1;
    }
    return true;
  }

  /// The next step of all workers, which all evict before any loads.
  bool next_round(std::vector<AssignedStep>& out) {
    for (std::size_t w = 0; w < out.size(); ++w) {
      if (!steps_->next(out[w].step)) {
        return false;
      }
      evict(out[w].step, w);
    }
    const bool begins = out.front().step.epoch != epoch_;
    if (begins) {
      begin_epoch(out.front().step.epoch);
    }
    for (std::size_t w = 0; w < out.size(); ++w) {
      arrive(out[w], w, begins);
    }
    return true;
  }

  /// The items that the step after the last one loads; empty at the end.
  [[nodiscard]] const std::vector<Element>& loaded_next() const {
    return goes_on() ? ahead_.load : nothing_;
  }

  /// The items in memory after the last step, in order of arrival.
  [[nodiscard]] const std::vector<Element>& memory() const { return memories_[0]; }

 private:
  // All pairs are computed again.
  void begin_epoch(std::uint64_t epoch) {
    epoch_ = epoch;
    loaded_.assign(loaded_.size(), false);
    if (loaded_.size() <= max_elements_in_memory || wanted_.graph() != nullptr) {
      done_.emplace(wanted_, loaded_.size());
    }
  }

  void forget() {
    std::ranges::fill(at_, 0);
    memories_.assign(memories_.size(), {});
  }

  void take_rule() {
    if (owners_ != nullptr) {
      rule_ = owners_->of(worker_);
    }
  }

  // Whether the worker computes the pair, or the item alone, in its step.
  [[nodiscard]] bool is_due(std::uint64_t step, Element x, Element y) const {
    return rule_ == nullptr || rule_->computes(step, x, y);
  }

  // Whether the worker has another step.
  [[nodiscard]] bool goes_on() const { return has_ahead_ && ahead_.worker == worker_; }

  void evict(const Step& step, std::size_t memory) {
    if ((step.*leave_).empty()) {
      return;
    }
    for (const Element x : step.*leave_) {
      at_[x] = 0;
    }
    std::erase_if(memories_[memory], [&](Element x) { return at_[x] == 0; });
  }

  // Returns the index of the first pair of the last arrival. At the beginning of an epoch, items in
  // memory arrive, too.
  std::size_t arrive(AssignedStep& out, std::size_t memory, bool begins) {
    out.pairs.clear();
    out.arrival_end.clear();
    out.is_new.clear();
    out.stayed.clear();
    if (begins) {
      for (const Element x : memories_[memory]) {
        at_[x] = 0;
      }
      for (const Element x : std::exchange(memories_[memory], {})) {
        if (come(out, x, memory)) {
          out.stayed.push_back(x);
        }
      }
    }
    out.stayed_end = out.pairs.size();
    std::size_t last_arrival = 0;
    for (const Element x : out.step.*come_) {
      last_arrival = out.pairs.size();
      out.is_new.push_back(come(out, x, memory));
      out.arrival_end.push_back(out.pairs.size());
    }
    return last_arrival;
  }

  // Whether the item is computed alone now.
  bool come(AssignedStep& out, Element x, std::size_t worker) {
    std::vector<Element>& memory = memories_[worker];
    const auto here = static_cast<std::uint32_t>(worker + 1);
    const auto add = [&](Element y) { out.pairs.emplace_back(std::min(x, y), std::max(x, y)); };
    const std::uint64_t number = out.step.number;
    if (done_) {
      done_->insert_all(
          x, memory, [&](Element y) { return at_[y] == here; },
          [&](Element y) { return is_due(number, x, y); }, add);
    } else {
      for (const Element y : memory) {
        if (wanted_.contains(x, y) && is_due(number, x, y)) {
          add(y);
        }
      }
    }
    memory.push_back(x);
    at_[x] = here;
    const bool is_new = !loaded_[x] && is_due(number, x, x);
    loaded_[x] = loaded_[x] || is_new;
    return is_new;
  }

  // Of the items evicted next, those that arrived in this step are evicted last: their pairs are
  // not computed yet.
  void choose_first(AssignedStep& out) const {
    out.evicted_first.clear();
    out.evicted_late.clear();
    if (!goes_on()) {
      return;
    }
    std::uint64_t needed = room_taken(memories_[0]) + room_taken(ahead_.*come_);
    const std::vector<Element>& came = out.step.*come_;
    std::vector<Element> evicted = ahead_.*leave_;
    std::stable_partition(evicted.begin(), evicted.end(),
                          [&](Element x) { return std::ranges::find(came, x) == came.end(); });
    auto middle = evicted.begin();
    for (; middle != evicted.end() && needed > room_; ++middle) {
      needed -= sizes_ != nullptr ? sizes_->bytes[*middle] : 1;
    }
    out.evicted_first.assign(evicted.begin(), middle);
    out.evicted_late.assign(middle, evicted.end());
  }

  [[nodiscard]] std::uint64_t room_taken(const std::vector<Element>& items) const {
    return sizes_ == nullptr ? items.size() : bytes_of(*sizes_, items);
  }

  std::uint64_t room_;
  std::shared_ptr<const ItemSizes> sizes_;
  std::vector<Element> Step::*come_;
  std::vector<Element> Step::*leave_;
  WantedPairs wanted_;
  bool in_lockstep_;
  std::shared_ptr<const PairOwners> owners_;
  std::unique_ptr<const PairRule> rule_;  // of the current worker
  std::unique_ptr<StepSource> steps_;
  Step ahead_;
  std::vector<Element> nothing_;
  bool has_ahead_ = false;
  std::uint64_t worker_ = 0;
  std::uint64_t epoch_ = 1;
  std::vector<std::vector<Element>> memories_;  // by worker, in lockstep
  std::vector<std::uint32_t> at_;               // by item: its memory plus one, 0 if in none
  std::vector<bool> loaded_;
  std::optional<WantedSet> done_;
};

}  // namespace changeover

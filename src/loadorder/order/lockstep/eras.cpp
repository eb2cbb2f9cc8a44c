#include "loadorder/order/lockstep/eras.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

/// The task of a worker in a round: the group that stays, and the one that passes.
struct Duty {
  std::optional<std::uint64_t> stays;
  std::optional<std::uint64_t> passes;
};

/// The tasks of all workers, round by round.
class Rounds {
 public:
  explicit Rounds(const EraShape& shape)
      : workers_(shape.workers), groups_(shape.groups), duties_(workers_), block_of_(workers_) {
    begin_era();
  }

  /// Moves to the next round; false at the end.
  bool next() {
    while (round_ == rounds_) {
      if (!begin_blocks()) {
        first_ += workers_;
        if (first_ >= groups_) {
          return false;
        }
        begin_era();
      }
    }
    for (std::uint64_t w = 0; w < present(); ++w) {
      duties_[w].passes.reset();
      const auto& [first_passing, passing, place, turns, stays] = block_of_[w];
      if (stays && turns > 0) {
        const std::uint64_t turn = (round_ + place) % turns;
        if (round_ < turns && turn < passing) {
          duties_[w].passes = first_passing + turn;
        }
      }
    }
    ++round_;
    return true;
  }

  [[nodiscard]] const std::vector<Duty>& duties() const { return duties_; }

 private:
  struct Block {
    std::uint64_t first_passing = 0;
    std::uint64_t passing = 0;
    std::uint64_t place = 0;  // of the worker, within its block
    std::uint64_t turns = 0;
    bool stays = false;
  };

  // Number of groups that stay in this era.
  [[nodiscard]] std::uint64_t present() const { return std::min(workers_, groups_ - first_); }

  void begin_era() {
    const std::uint64_t others = groups_ - first_ - present();
    size_ = 2 * std::bit_ceil(present());
    round_ = 0;
    // The pairs within a group meet here, even if no group passes.
    rounds_ = others > 0 ? std::max(others, present()) : 1;
    for (std::uint64_t w = 0; w < workers_; ++w) {
      const bool stays = w < present();
      duties_[w] = {stays ? std::optional(first_ + w) : std::nullopt, std::nullopt};
      block_of_[w] = {first_ + present(), others, w, others > 0 ? rounds_ : 0, stays};
    }
  }

  // Continues with blocks of half the size; false if all groups have met.
  bool begin_blocks() {
    size_ /= 2;
    if (size_ < 2) {
      return false;
    }
    round_ = 0;
    rounds_ = 0;
    for (std::uint64_t begin = 0; begin < present(); begin += size_) {
      const std::uint64_t end = std::min(begin + size_, present());
      const std::uint64_t half = std::min(begin + size_ / 2, end);
      const std::uint64_t turns = half < end ? std::max(half - begin, end - half) : 0;
      rounds_ = std::max(rounds_, turns);
      for (std::uint64_t w = begin; w < end; ++w) {
        const bool stays = w < half && turns > 0;
        duties_[w] = {stays ? std::optional(first_ + w) : std::nullopt, std::nullopt};
        block_of_[w] = {first_ + half, end - half, w - begin, turns, stays};
      }
    }
    return true;
  }

  std::uint64_t workers_, groups_;
  std::uint64_t first_ = 0;   // first group of the era
  std::uint64_t size_ = 0;    // of its blocks
  std::uint64_t round_ = 0;   // within this phase
  std::uint64_t rounds_ = 0;  // of this phase
  std::vector<Duty> duties_;
  std::vector<Block> block_of_;
};

std::uint64_t begin_of(const EraShape& shape, std::uint64_t group) {
  return group * shape.items / shape.groups;
}

std::uint64_t size_of(const EraShape& shape, const std::optional<std::uint64_t>& group) {
  return group ? begin_of(shape, *group + 1) - begin_of(shape, *group) : 0;
}

/// Turns rounds into steps: one that loads the groups that stay, if they change; then one for each
/// item that passes.
class EraSteps final : public StepSource {
 public:
  EraSteps(const EraShape& shape, std::uint64_t worker)
      : shape_(shape), worker_(static_cast<std::size_t>(worker)), rounds_(shape) {}

  bool next(Step& step) override {
    if (place_ == length_ && !begin_round()) {
      return false;
    }
    step.number = ++number_;
    step.evict.clear();
    step.load.clear();
    if (place_ == 0 && passing_) {  // from the round before
      step.evict.push_back(*passing_);
      passing_.reset();
    }
    if (changes_ && place_ == 0) {
      if (held_ != duty_.stays) {
        put(held_, step.evict);
        put(duty_.stays, step.load);
        held_ = duty_.stays;
      }
    } else {
      const std::uint64_t item = place_ - (changes_ ? 1 : 0);
      if (item < size_of(shape_, duty_.passes)) {
        if (passing_) {
          step.evict.push_back(*passing_);
        }
        passing_ = static_cast<Element>(begin_of(shape_, *duty_.passes) + item);
        step.load.push_back(*passing_);
      }
    }
    ++place_;
    return true;
  }

 private:
  void put(const std::optional<std::uint64_t>& group, std::vector<Element>& into) const {
    for (std::uint64_t i = 0; i < size_of(shape_, group); ++i) {
      into.push_back(static_cast<Element>(begin_of(shape_, *group) + i));
    }
  }

  // Starts a round; false if it is empty.
  bool begin_round() {
    place_ = length_ = 0;
    while (length_ == 0) {
      stayed_.resize(rounds_.duties().size());
      if (!rounds_.next()) {
        return false;
      }
      changes_ = false;
      for (std::size_t w = 0; w < stayed_.size(); ++w) {
        const Duty& duty = rounds_.duties()[w];
        changes_ = changes_ || duty.stays != stayed_[w];
        stayed_[w] = duty.stays;
        length_ = std::max(length_, size_of(shape_, duty.passes));
      }
      length_ += changes_ ? 1 : 0;
    }
    duty_ = rounds_.duties()[worker_];
    return true;
  }

  EraShape shape_;
  std::size_t worker_;
  Rounds rounds_;
  std::vector<std::optional<std::uint64_t>>
      stayed_;  // group that stayed at each worker in the round before
  Duty duty_;
  bool changes_ = false;      // whether other groups stay in this round
  std::uint64_t place_ = 0;   // within the round
  std::uint64_t length_ = 0;  // of the round
  std::optional<std::uint64_t> held_;
  std::optional<Element> passing_;
  std::uint64_t number_ = 0;
};

}  // namespace

EraCost cost_of_eras(const EraShape& shape) {
  EraCost cost;
  Rounds rounds(shape);
  std::vector<std::optional<std::uint64_t>> stayed(static_cast<std::size_t>(shape.workers));
  while (rounds.next()) {
    stop_if_asked();
    std::uint64_t to_stay = 0;
    std::uint64_t to_pass = 0;
    bool changes = false;
    for (std::size_t w = 0; w < stayed.size(); ++w) {
      const Duty& duty = rounds.duties()[w];
      if (duty.stays != stayed[w]) {
        changes = true;
        stayed[w] = duty.stays;
        to_stay = std::max(to_stay, size_of(shape, duty.stays));
        cost.loads += size_of(shape, duty.stays);
      }
      to_pass = std::max(to_pass, size_of(shape, duty.passes));
      cost.loads += size_of(shape, duty.passes);
    }
    cost.span += to_stay + to_pass;
    cost.steps += to_pass + (changes ? 1 : 0);
  }
  return cost;
}

EraShape best_eras(std::uint64_t items, std::uint64_t room, std::uint64_t workers) {
  const std::uint64_t fewest = ceil_div(items, room - 1);
  EraShape best{items, workers, fewest};
  constexpr std::uint64_t rounds_to_compare = 1'000'000;
  const std::uint64_t others =
      fewest * fewest < rounds_to_compare ? std::min<std::uint64_t>(workers, 16) : 0;
  EraCost least = cost_of_eras(best);
  for (std::uint64_t groups = fewest + 1; groups <= std::min(items, fewest + others); ++groups) {
    const EraShape shape{items, workers, groups};
    const EraCost cost = cost_of_eras(shape);
    if (std::pair(cost.span, cost.loads) < std::pair(least.span, least.loads)) {
      least = cost;
      best = shape;
    }
  }
  return best;
}

std::unique_ptr<StepSource> era_steps(const EraShape& shape, std::uint64_t worker) {
  return std::make_unique<EraSteps>(shape, worker);
}

}  // namespace changeover

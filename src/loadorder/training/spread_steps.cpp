#include "loadorder/training/spread_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

/// The rounds of steps in which an item is at a worker.
struct Stay {
  std::uint32_t worker = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

class SpreadSteps final : public StepSource {
 public:
  SpreadSteps(std::unique_ptr<StepSource> steps, const ScheduleRules& rules, std::uint64_t seed)
      : source_(std::move(steps)),
        seed_(seed),
        lockstep_(rules.lockstep > 0),
        workers_(static_cast<std::size_t>(std::max<std::uint64_t>(1, rules.lockstep))),
        come_(rules.fast_room ? &Step::fast_load : &Step::load),
        leave_(rules.fast_room ? &Step::fast_evict : &Step::evict),
        stays_(static_cast<std::size_t>(rules.items)) {
    more_ = source_->next(ahead_);
  }

  bool next(Step& step) override {
    if (given_ == steps_.size()) {
      if (!more_) {
        return false;
      }
      read();
      spread();
      given_ = 0;
    }
    std::swap(step, steps_[given_++]);
    return true;
  }

 private:
  // Reads all steps of an epoch, of one worker or, in lockstep, of all.
  void read() {
    const std::uint64_t worker = ahead_.worker;
    const std::uint64_t epoch = ahead_.epoch;
    std::vector<std::pair<Element, std::uint32_t>> stayed;  // with the worker
    for (std::size_t x = 0; x < stays_.size(); ++x) {
      std::vector<Stay>& its = stays_[x];
      if (!its.empty() && its.back().end == open && last_worker_ == worker && epoch > 1) {
        stayed.emplace_back(static_cast<Element>(x), its.back().worker);
      }
      its.clear();
    }
    for (const auto& [x, with] : stayed) {
      stays_[x].push_back({with, 0, open});
    }
    last_worker_ = worker;
    steps_.clear();
    pairs_.clear();
    do {
      take(ahead_);
      steps_.push_back(std::move(ahead_));
      ahead_ = {};
      more_ = source_->next(ahead_);
    } while (more_ && ahead_.epoch == epoch && (lockstep_ || ahead_.worker == worker));
    random_ = Random(seed_, checked_add(checked_multiply(epoch, 65'536), lockstep_ ? 0 : worker));
  }

  void take(Step& step) {
    const auto round = static_cast<std::uint32_t>(steps_.size() / workers_);
    const std::uint32_t worker = lockstep_ ? static_cast<std::uint32_t>(step.worker) : 0;
    for (const Element x : step.*leave_) {
      // Another worker, whose step was read before, may have it from now on.
      std::vector<Stay>& its = stays_[x];
      (its.back().worker == worker ? its.back() : its[its.size() - 2]).end = round;
    }
    for (const Element x : step.*come_) {
      stays_[x].push_back({worker, round, open});
    }
    pairs_.insert(pairs_.end(), step.compute.begin(), step.compute.end());
    if (pairs_.size() > most_pairs_spread) {
      throw ImpossibleParameters(
          fmt::format("more than {} pairs cannot be given to random steps; group items into larger "
                      "ones",
                      most_pairs_spread));
    }
    step.compute.clear();
  }

  // Calls visit(first step, number of rounds) for each run of rounds in which both items are held.
  template <typename Visit>
  void each_run(const ItemPair& pair, Visit&& visit) const {
    const std::vector<Stay>& a = stays_[pair.first];
    const std::vector<Stay>& b = stays_[pair.second];
    const auto rounds = static_cast<std::uint32_t>(steps_.size() / workers_);
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      const std::uint32_t begin = std::max(a[i].begin, b[j].begin);
      const std::uint32_t end = std::min({a[i].end, b[j].end, rounds});
      if (begin < end && a[i].worker == b[j].worker) {
        visit(std::size_t{begin} * workers_ + a[i].worker, end - begin);
      }
      a[i].end <= b[j].end ? ++i : ++j;
    }
  }

  [[nodiscard]] std::uint32_t choices(const ItemPair& pair) const {
    std::uint32_t count = 0;
    each_run(pair, [&](std::size_t, std::uint32_t rounds) { count += rounds; });
    return count;
  }

  [[nodiscard]] std::uint32_t choice(const ItemPair& pair, std::uint32_t number) const {
    std::size_t step = 0;
    each_run(pair, [&](std::size_t first, std::uint32_t rounds) {
      if (number < rounds) {
        step = first + number * workers_;
        number = ~std::uint32_t{0};
      } else if (number != ~std::uint32_t{0}) {
        number -= rounds;
      }
    });
    return static_cast<std::uint32_t>(step);
  }

  void spread() {
    std::vector<std::uint32_t> at(pairs_.size());
    std::vector<std::uint32_t> filled(steps_.size(), 0);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      at[i] = choice(pairs_[i], random_.below(choices(pairs_[i])));
      ++filled[at[i]];
    }
    even_out(at, filled);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      steps_[at[i]].compute.push_back(pairs_[i]);
    }
  }

  // Moves pairs from steps above the mean to the emptiest of some candidate steps.
  void even_out(std::vector<std::uint32_t>& at, std::vector<std::uint32_t>& filled) {
    constexpr int most_passes = 60;
    constexpr std::uint32_t looks = 12;
    const auto mean = static_cast<std::uint32_t>(
        ceil_div(pairs_.size(), std::max<std::size_t>(1, steps_.size())));
    bool moved = true;
    for (int pass = 0; pass < most_passes && moved; ++pass) {
      stop_if_asked();
      moved = false;
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (filled[at[i]] <= mean) {
          continue;
        }
        const std::uint32_t all = choices(pairs_[i]);
        std::uint32_t best = at[i];
        for (std::uint32_t look = 0; look < std::min(all, looks); ++look) {
          const std::uint32_t other = choice(pairs_[i], all <= looks ? look : random_.below(all));
          // A step that would then be as full as this one is accepted, too: the next move may
          // continue from there.
          if (filled[other] + 1 <= filled[at[i]] &&
              (best == at[i] || filled[other] < filled[best])) {
            best = other;
          }
        }
        if (best != at[i]) {
          --filled[at[i]];
          ++filled[best];
          at[i] = best;
          moved = true;
        }
      }
    }
  }

  static constexpr std::uint32_t open = ~std::uint32_t{0};

  std::unique_ptr<StepSource> source_;
  std::uint64_t seed_;
  Random random_{0};
  bool lockstep_;
  std::size_t workers_;
  std::vector<Element> Step::*come_;
  std::vector<Element> Step::*leave_;
  std::vector<std::vector<Stay>> stays_;  // by item, in this epoch
  Step ahead_;
  bool more_ = false;
  std::uint64_t last_worker_ = 0;
  std::vector<Step> steps_;
  std::size_t given_ = 0;
  std::vector<ItemPair> pairs_;
};

}  // namespace

std::unique_ptr<StepSource> spread_over_steps(std::unique_ptr<StepSource> steps,
                                              const ScheduleRules& rules, std::uint64_t seed) {
  return std::make_unique<SpreadSteps>(std::move(steps), rules, seed);
}

}  // namespace changeover

#include "loadorder/order/levels/loads_ahead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

/// From a load to its eviction.
struct MemoryStay {
  Element item = 0;
  std::size_t first = not_again;   // the step that transfers it first
  std::size_t last = not_again;    // the step in which it leaves the accelerator for good
  std::size_t needed = not_again;  // the first transfer of its next stay
  [[nodiscard]] bool is_used() const { return first != not_again; }
};

/// The stays of all items by their first transfers.
std::vector<MemoryStay> stays_in(const std::vector<Move>& steps, std::uint64_t items) {
  std::vector<MemoryStay> stays;
  std::vector<std::size_t> now(static_cast<std::size_t>(items), not_again);
  for (std::size_t t = 0; t < steps.size(); ++t) {
    for (const Element x : steps[t].fast_evict) {
      stays[now[x]].last = t;
    }
    for (const Element x : steps[t].load) {
      now[x] = stays.size();
      stays.push_back({x});
    }
    for (const Element x : steps[t].fast_load) {
      MemoryStay& stay = stays[now[x]];
      stay.first = std::min(stay.first, t);
      stay.last = not_again;
    }
  }
  std::erase_if(stays, [](const MemoryStay& stay) { return !stay.is_used(); });
  std::ranges::stable_sort(stays, {}, &MemoryStay::first);
  std::vector<std::size_t> next(now.size(), not_again);
  for (std::size_t i = stays.size(); i > 0; --i) {
    stays[i - 1].needed = std::exchange(next[stays[i - 1].item], stays[i - 1].first);
  }
  return stays;
}

std::uint64_t units_of(Element x, const ItemSizes* sizes) {
  return sizes != nullptr ? sizes->bytes[x] : 1;
}

/// Moves what memory evicts and loads.
class Ahead {
 public:
  Ahead(std::vector<Move>& steps, std::uint64_t items, std::uint64_t room, const ItemSizes* sizes)
      : steps_(steps),
        stays_(stays_in(steps, items)),
        room_(sizes != nullptr ? sizes->memory : room),
        sizes_(sizes),
        stay_of_(static_cast<std::size_t>(items), not_again) {}

  void run() {
    for (std::size_t t = 0; t < steps_.size(); ++t) {
      Move& step = steps_[t];
      step.evict.clear();
      step.load.clear();
      for (const Element x : step.fast_evict) {
        if (const MemoryStay& stay = stays_[stay_of_[x]]; stay.last == t) {
          done_.emplace(stay.needed, x);
        }
      }
      while (at_ < stays_.size() && start(stays_[at_], step)) {
        stay_of_[stays_[at_].item] = at_;
        ++at_;
      }
    }
  }

 private:
  // Whether the stay begins now: the item is still there, or there is room for it.
  bool start(const MemoryStay& stay, Move& step) {
    if (stay_of_[stay.item] != not_again) {
      return done_.erase({stay.first, stay.item}) == 1;
    }
    const std::uint64_t size = units_of(stay.item, sizes_);
    while (room_ - held_ < size && !done_.empty()) {
      const Element goes = done_.rbegin()->second;
      done_.erase(std::prev(done_.end()));
      stay_of_[goes] = not_again;
      held_ -= units_of(goes, sizes_);
      step.evict.push_back(goes);
    }
    if (room_ - held_ < size) {
      return false;
    }
    held_ += size;
    step.load.push_back(stay.item);
    return true;
  }

  std::vector<Move>& steps_;
  std::vector<MemoryStay> stays_;
  std::uint64_t room_;
  const ItemSizes* sizes_;
  std::size_t at_ = 0;                // the next stay
  std::vector<std::size_t> stay_of_;  // by item in memory: its stay
  std::uint64_t held_ = 0;
  std::set<std::pair<std::size_t, Element>>
      done_;  // may leave memory, what is needed last at the end
};

}  // namespace

std::vector<Move> loads_ahead(StepSource& source, std::uint64_t items, std::uint64_t room,
                              std::uint64_t spare, const ItemSizes* sizes) {
  constexpr std::size_t most_moves = 50'000'000;  // 1 GB or so with their steps
  std::vector<Move> steps;
  std::size_t moves = 0;
  for (Step step; source.next(step);) {
    moves += 1 + step.load.size() + step.fast_load.size();
    if (moves > most_moves) {
      throw ImpossibleParameters(
          fmt::format("two levels whose loads start early have at most {} moves; group items into "
                      "larger ones",
                      most_moves));
    }
    steps.push_back({step.evict, step.load, step.fast_evict, step.fast_load, step.epoch});
  }
  if (spare > 0) {
    for (Move& step : steps) {
      step = {.evict = std::move(step.fast_evict),
              .load = std::move(step.fast_load),
              .epoch = step.epoch};
    }
    ItemSizes less;
    if (sizes != nullptr) {
      less = {sizes->bytes, sizes->memory - spare, sizes->fast_memory};
    }
    steps = with_a_cache(std::move(steps), room - (sizes != nullptr ? 0 : spare),
                         sizes != nullptr ? &less : nullptr);
  }
  Ahead(steps, items, room, sizes).run();
  return steps;
}

std::vector<std::uint64_t> spares_to_try(const ScheduleRules& rules) {
  const std::uint64_t room = rules.sizes ? rules.sizes->memory : rules.room;
  const std::uint64_t most = room - (rules.sizes ? rules.sizes->fast_memory : *rules.fast_room);
  std::vector<std::uint64_t> spares{0};
  for (const std::uint64_t spare : {room / *rules.fast_room / 4, room / 8, room / 4, room / 2}) {
    if (spare > 0 && spare <= most && std::ranges::find(spares, spare) == spares.end()) {
      spares.push_back(spare);
    }
  }
  return spares;
}

double time_ahead(StepSource& steps, const ScheduleRules& rules) {
  // A load takes as long as the pairs that it can bring together.
  std::uint64_t bytes = 0;
  for (Element x = 0; rules.sizes && x < rules.items; ++x) {
    bytes += rules.sizes->bytes[x];
  }
  const double mean =
      rules.sizes ? static_cast<double>(bytes) / static_cast<double>(rules.items) : 1;
  const double room = rules.sizes ? static_cast<double>(rules.sizes->memory) / mean
                                  : static_cast<double>(rules.room);
  std::vector<double> there(static_cast<std::size_t>(rules.items), 0);
  double now = 0;
  double disk = 0;
  double longest = 0;
  for (Step step; steps.next(step);) {
    if (step.number == 1) {
      now = disk = 0;
    }
    for (const Element x : step.load) {
      disk = std::max(disk, now) +
             (room - 1) * static_cast<double>(units_of(x, rules.sizes.get())) / mean;
      there[x] = disk;
    }
    for (const Element x : step.fast_load) {
      now = std::max(now, there[x]);
    }
    now += static_cast<double>(step.compute.size());
    longest = std::max(longest, now);
  }
  return longest;
}

LoadOrder start_loads_early(LoadOrder order) {
  LoadOrderFacts facts = order.facts();
  const ScheduleRules rules = order.rules(ComputeRules{});
  LoadOrder::Maker best;
  double least = 0;
  for (const std::uint64_t spare : spares_to_try(rules)) {
    stop_if_asked();
    LoadOrder::Maker maker =
        in_memory(loads_ahead(*order.stream(), facts.items, facts.room, spare, facts.sizes.get()));
    StepWork work(maker(), rules);
    if (const double time = time_ahead(work, rules); !best || time < least) {
      least = time;
      best = std::move(maker);
    }
  }
  static_cast<ScheduleFacts&>(facts) = static_cast<ScheduleFacts&&>(read_order(
      best, LoadOrder(facts, best).rules(), fmt::format("{} items with early loads", facts.items)));
  return {std::move(facts), best};
}

}  // namespace changeover

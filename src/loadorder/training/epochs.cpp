#include "loadorder/training/epochs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/order/read_order.hpp"

namespace changeover {

void check_moves_kept(std::uint64_t moves, std::uint64_t steps) {
  constexpr std::uint64_t moves_of_a_step = 8;  // memory for a step, apart from its moves
  if (moves > most_moves_kept || steps > (most_moves_kept - moves) / moves_of_a_step) {
    throw ImpossibleParameters(fmt::format(
        "an epoch has {} loads and evictions in {} steps; to repeat it backwards, they would need "
        "more than 1.6 GB of memory; group items into larger ones",
        moves, steps));
  }
}

namespace {

/// The moves of an epoch, step by step.
class Tape {
 public:
  void add(const Step& step) {
    for (const auto list : lists) {
      items_.insert(items_.end(), (step.*list).begin(), (step.*list).end());
      ends_.push_back(items_.size());
    }
    check_moves_kept(items_.size(), steps());
  }

  [[nodiscard]] std::size_t steps() const { return ends_.size() / lists.size(); }

  /// A step forward.
  void get(std::size_t step, Step& out) const {
    for (std::size_t i = 0; i < lists.size(); ++i) {
      take(step, i, out.*lists[i]);
    }
  }
  /// A step backward: loads become evictions, and evictions loads.
  void get_backward(std::size_t step, Step& out) const {
    for (std::size_t i = 0; i < lists.size(); ++i) {
      take(step, i ^ 1U, out.*lists[i]);
    }
  }

 private:
  static constexpr std::array<std::vector<Element> Step::*, 4> lists{
      &Step::evict, &Step::load, &Step::fast_evict, &Step::fast_load};

  void take(std::size_t step, std::size_t list, std::vector<Element>& out) const {
    const std::size_t at = step * lists.size() + list;
    const std::uint64_t begin = at == 0 ? 0 : ends_[at - 1];
    out.assign(items_.begin() + static_cast<std::ptrdiff_t>(begin),
               items_.begin() + static_cast<std::ptrdiff_t>(ends_[at]));
  }

  std::vector<Element> items_;
  std::vector<std::uint64_t> ends_;  // of the lists of a step
};

class BackAndForth final : public StepSource {
 public:
  BackAndForth(const LoadOrder::Maker& maker, std::uint64_t epochs, std::uint64_t lockstep)
      : source_(maker()),
        epochs_(epochs),
        workers_(static_cast<std::size_t>(std::max<std::uint64_t>(1, lockstep))) {}

  bool next(Step& step) override {
    if (epoch_ == 1) {
      if (source_->next(step)) {
        worker_ = step.worker;
        step.epoch = 1;
        if (epochs_ > 1) {
          tape_.add(step);
        }
        return true;
      }
      epoch_ = 2;
      at_ = 0;
      source_.reset();
    }
    if (at_ == tape_.steps()) {
      ++epoch_;
      at_ = 0;
    }
    if (epoch_ > epochs_ || tape_.steps() == 0) {
      return false;
    }
    put(step);
    return true;
  }

 private:
  // Rounds consist of the steps of all workers; a backward round undoes the round after it.
  void put(Step& step) {
    const std::size_t rounds = tape_.steps() / workers_;
    const std::size_t round = at_ / workers_;
    const std::size_t worker = at_ % workers_;
    ++at_;
    step.number = (epoch_ - 1) * rounds + round + 1;
    step.worker = workers_ > 1 ? worker : worker_;
    step.epoch = epoch_;
    if (round == 0) {
      for (std::vector<Element>* const list :
           {&step.evict, &step.load, &step.fast_evict, &step.fast_load}) {
        list->clear();
      }
    } else if (epoch_ % 2 == 1) {
      tape_.get(round * workers_ + worker, step);
    } else {
      tape_.get_backward((rounds - round) * workers_ + worker, step);
    }
  }

  std::unique_ptr<StepSource> source_;  // of the first epoch
  std::uint64_t epochs_;
  std::size_t workers_;
  Tape tape_;
  std::uint64_t epoch_ = 1;
  std::size_t at_ = 0;  // steps of this epoch so far
  std::uint64_t worker_ = 0;
};

}  // namespace

ScheduleFacts count_moves(StepSource& steps, std::uint64_t workers, const ItemSizes* sizes) {
  ScheduleFacts facts;
  std::uint64_t slowest = 0;
  std::uint64_t slowest_bytes = 0;
  const auto add = [](std::vector<std::uint64_t>& list, std::uint64_t at, std::uint64_t loads) {
    list.resize(std::max<std::size_t>(list.size(), static_cast<std::size_t>(at) + 1), 0);
    list[static_cast<std::size_t>(at)] += loads;
  };
  for (Step step; steps.next(step);) {
    stop_if_asked();
    if (facts.steps++ % workers == 0) {
      facts.span += std::exchange(slowest, 0);
      facts.span_bytes += std::exchange(slowest_bytes, 0);
    }
    slowest = std::max<std::uint64_t>(slowest, step.load.size());
    facts.loads += step.load.size();
    facts.transfers += step.fast_load.size();
    add(facts.worker_loads, step.worker, step.load.size());
    add(facts.epoch_loads, step.epoch - 1, step.load.size());
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; sizes != nullptr && i < step.load.size(); ++i) {
      bytes += sizes->bytes[step.load[i]];
    }
    slowest_bytes = std::max(slowest_bytes, bytes);
    facts.bytes += bytes;
    for (std::size_t i = 0; sizes != nullptr && i < step.fast_load.size(); ++i) {
      facts.transfer_bytes += sizes->bytes[step.fast_load[i]];
    }
    add(facts.worker_bytes, step.worker, bytes);
  }
  facts.span += slowest;
  facts.span_bytes += slowest_bytes;
  facts.steps /= workers;
  return facts;
}

void check_epochs(std::uint64_t epochs) {
  if (epochs == 0 || epochs > most_epochs) {
    throw BadInput(fmt::format("{} epochs: give 1 to {}", epochs, most_epochs));
  }
}

std::unique_ptr<StepSource> back_and_forth(const LoadOrder::Maker& maker, std::uint64_t epochs,
                                           std::uint64_t lockstep) {
  return std::make_unique<BackAndForth>(maker, epochs, lockstep);
}

std::string in_each_epoch(const std::string& certificate, std::uint64_t epochs) {
  return epochs == 1 ? certificate : fmt::format("{}, in each of {} epochs", certificate, epochs);
}

LoadBound epochs_lower_bound(const LoadBound& once, std::uint64_t pairs, std::uint64_t room,
                             std::uint64_t workers, std::uint64_t epochs) {
  if (epochs == 1) {
    return once;
  }
  // The items in memory at its start, together with the loads of an epoch, are an order of one
  // epoch.
  const std::uint64_t there = checked_multiply(room, workers);
  const std::uint64_t by_order = once.loads > there ? once.loads - there : 0;
  // Also, each load adds at most C - 1 pairs to those in memory.
  const std::uint64_t met = checked_multiply(binomial(room, 2), workers);
  const std::uint64_t by_pairs = pairs > met ? ceil_div(pairs - met, room - 1) : 0;
  const std::uint64_t later = std::max(by_order, by_pairs);
  const std::string why =
      by_pairs > by_order
          ? fmt::format(
                "of {} pairs {} can be in memory when it begins, and a load brings at most "
                "{} more",
                pairs, met, room - 1)
          : fmt::format(
                "its loads are an order of one epoch, together with the {} items that can "
                "be in memory when it begins",
                there);
  return {checked_add(once.loads, checked_multiply(epochs - 1, later)),
          fmt::format("{} in the first epoch, and {} in each other one: {}; {}",
                      count_of(once.loads, "load"), later, why, once.reason)};
}

LoadBound epochs_makespan_bound(const LoadBound& once, const LoadBound& all, std::uint64_t workers,
                                const std::string& what) {
  const std::uint64_t mean = ceil_div(all.loads, workers);
  return mean <= once.loads
             ? once
             : LoadBound{
                   mean,
                   fmt::format("{} at least {} {}: {}",
                               workers == 1 ? std::string("one worker has")
                                            : fmt::format("all {} workers together have", workers),
                               all.loads, what, all.reason)};
}

LoadBound epochs_byte_bound(const LoadBound& once, std::uint64_t memory, std::uint64_t workers,
                            std::uint64_t epochs) {
  const std::uint64_t left = memory > once.loads / workers ? 0 : once.loads - memory * workers;
  return {checked_add(once.loads, checked_multiply(epochs - 1, left)),
          fmt::format("{} bytes in the first epoch, and {} in each other one, whose loads are an "
                      "order of one epoch together with what is in memory when it begins; {}",
                      once.loads, left, once.reason)};
}

LoadOrder repeat_order(LoadOrder order, std::uint64_t epochs) {
  check_epochs(epochs);
  if (epochs == 1) {
    return order;
  }
  LoadOrderFacts facts = order.facts();
  if (facts.epochs != 1) {
    throw BadInput("an order of several epochs is not repeated; give that of one epoch");
  }
  const std::uint64_t all_workers = std::max<std::uint64_t>(1, facts.lockstep);
  // Items in memory at the end are not evicted.
  const std::uint64_t stays = std::min(facts.loads, checked_multiply(facts.room, all_workers));
  check_moves_kept(checked_add(facts.loads, facts.loads - stays),
                   checked_multiply(facts.steps, all_workers));
  const LoadOrder::Maker once = order.maker();
  const std::uint64_t lockstep = facts.lockstep;
  LoadOrder::Maker maker = [once, epochs, lockstep] {
    return back_and_forth(once, epochs, lockstep);
  };
  const std::uint64_t workers = std::max<std::uint64_t>(1, lockstep);
  facts.epochs = epochs;
  const std::uint64_t pairs = facts.wanted.among(facts.items).count();
  facts.bound = epochs_lower_bound(facts.bound, pairs, facts.room, workers, epochs);
  if (facts.sizes) {
    facts.byte_bound = epochs_byte_bound(facts.byte_bound, facts.sizes->memory, workers, epochs);
  }
  if (facts.fast_room) {
    facts.transfer_bound =
        epochs_lower_bound(facts.transfer_bound, pairs, *facts.fast_room, workers, epochs);
    if (facts.sizes) {
      facts.transfer_byte_bound =
          epochs_byte_bound(facts.transfer_byte_bound, facts.sizes->fast_memory, workers, epochs);
    }
  }
  if (lockstep > 0) {
    facts.makespan_bound = epochs_makespan_bound(facts.makespan_bound, facts.bound, lockstep);
    if (facts.sizes) {
      facts.makespan_byte_bound =
          epochs_makespan_bound(facts.makespan_byte_bound, facts.byte_bound, lockstep, "bytes");
    }
  }
  const std::uint64_t steps = checked_multiply(facts.steps, epochs);
  facts.every_step_read =
      facts.every_step_read && checked_multiply(facts.loads, epochs) <= most_loads_read;
  if (!facts.every_step_read) {
    static_cast<ScheduleFacts&>(facts) = count_moves(*maker(), workers, facts.sizes.get());
    facts.certificate += ", and read back and forth";
  } else {
    const ScheduleRules rules = LoadOrder(facts, maker).rules();
    static_cast<ScheduleFacts&>(facts) = static_cast<ScheduleFacts&&>(read_order(
        maker, rules, fmt::format("{} epochs of {} items", epochs, facts.items), lockstep > 0));
    facts.certificate = in_each_epoch(facts.certificate, epochs);
  }
  if (facts.steps != steps || facts.loads < facts.bound.loads) {
    throw InternalError(fmt::format("the order of {} epochs does not keep its promise", epochs));
  }
  return {std::move(facts), std::move(maker)};
}

}  // namespace changeover

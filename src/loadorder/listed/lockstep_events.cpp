#include "loadorder/listed/lockstep_events.hpp"

#include <algorithm>
#include <utility>

namespace changeover {
namespace {

std::uint32_t steps_in(const LockstepEvents& events) {
  std::uint32_t steps = 0;
  for (const std::vector<LockstepEvent>& each : events) {
    steps = each.empty() ? steps : std::max(steps, each.back().step + 1);
  }
  return steps;
}

/// Which stays of items bring a pair together that has not met before, by playing all workers.
class UsedStays {
 public:
  UsedStays(const LockstepEvents& events, const PairGraph& graph)
      : graph_(graph),
        holder_(static_cast<std::size_t>(graph.items()), 0),
        stay_(holder_.size(), 0),
        met_(static_cast<std::size_t>(2 * graph.pairs()), false),
        loaded_(holder_.size(), false) {
    std::vector<std::size_t> at(events.size(), 0);
    const std::uint32_t steps = steps_in(events);
    for (std::uint32_t step = 0; step < steps; ++step) {
      for (const bool comes : {false, true}) {
        for (std::size_t w = 0; w < events.size(); ++w) {
          for (; at[w] < events[w].size() && events[w][at[w]].step == step &&
                 events[w][at[w]].comes == comes;
               ++at[w]) {
            comes ? load(w, events[w][at[w]].item) : void(holder_[events[w][at[w]].item] = 0);
          }
        }
      }
    }
  }

  /// By the number of the stay: stays are numbered by their loads, step by step, worker by worker.
  [[nodiscard]] const std::vector<bool>& are_used() const { return is_used_; }
  /// The number of a worker's stays in turn.
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& of_workers() const { return stays_; }

 private:
  void load(std::size_t w, Element x) {
    if (stays_.size() <= w) {
      stays_.resize(w + 1);
    }
    stays_[w].push_back(is_used_.size());
    stay_[x] = is_used_.size();
    // An item without pairs is loaded once.
    is_used_.push_back(graph_.partners(x).empty() && !loaded_[x]);
    loaded_[x] = true;
    holder_[x] = w + 1;
    for (const Element y : graph_.partners(x)) {
      if (holder_[y] != w + 1) {
        continue;
      }
      const auto place = static_cast<std::size_t>(*graph_.place(x, y));
      if (!met_[place]) {
        met_[place] = true;
        is_used_[stay_[x]] = is_used_[stay_[y]] = true;
      }
    }
  }

  const PairGraph& graph_;
  std::vector<std::size_t> holder_;  // by item: its worker plus one, or 0
  std::vector<std::size_t> stay_;    // by item
  std::vector<bool> met_;
  std::vector<bool> loaded_;
  std::vector<bool> is_used_;
  std::vector<std::vector<std::size_t>> stays_;
};

void leave_out_unused(LockstepEvents& events, const PairGraph& graph) {
  const UsedStays stays(events, graph);
  std::vector<bool> is_kept(static_cast<std::size_t>(graph.items()), false);  // at this worker
  for (std::size_t w = 0; w < events.size(); ++w) {
    std::size_t next = 0;
    std::erase_if(events[w], [&](const LockstepEvent& event) {
      if (event.comes) {
        is_kept[event.item] = stays.are_used()[stays.of_workers()[w][next++]];
      }
      return !is_kept[event.item];
    });
  }
}

}  // namespace

LockstepEvents events_of(StepSource& steps, std::uint64_t workers, const Groups& groups) {
  LockstepEvents events(static_cast<std::size_t>(workers));
  for (Step step; steps.next(step);) {
    const auto number = static_cast<std::uint32_t>(step.number);
    std::vector<LockstepEvent>& its = events[static_cast<std::size_t>(step.worker)];
    const auto add = [&](const std::vector<Element>& moved, bool comes) {
      for (const Element x : groups.empty() ? moved : items_in(groups, moved)) {
        its.push_back({number, x, comes});
      }
    };
    add(step.evict, false);
    add(step.load, true);
  }
  return events;
}

LockstepLists lists_of(LockstepEvents events, const PairGraph* graph, const ItemSizes* sizes) {
  if (graph != nullptr) {
    leave_out_unused(events, *graph);
  }
  // What goes after the last load stays.
  std::uint32_t end = 0;
  for (const std::vector<LockstepEvent>& each : events) {
    for (const LockstepEvent& event : each) {
      end = event.comes ? std::max(end, event.step + 1) : end;
    }
  }
  std::vector<bool> evicts(end, false);
  std::vector<bool> moves(end, false);
  for (std::vector<LockstepEvent>& each : events) {
    std::erase_if(each, [&](const LockstepEvent& event) { return event.step >= end; });
    for (const LockstepEvent& event : each) {
      moves[event.step] = true;
      evicts[event.step] = evicts[event.step] || !event.comes;
    }
  }
  LockstepLists result;
  std::vector<std::size_t> number(end, 0);
  for (std::size_t step = 0; step < end; ++step) {
    result.steps += moves[step] && (evicts[step] || result.steps == 0) ? 1U : 0U;
    number[step] = static_cast<std::size_t>(result.steps) - (result.steps > 0 ? 1 : 0);
  }
  std::vector<std::uint64_t> most(static_cast<std::size_t>(result.steps), 0);
  auto lists = std::make_shared<StepLists>();
  for (const std::vector<LockstepEvent>& each : events) {
    std::vector<Move> its(static_cast<std::size_t>(result.steps));
    std::vector<std::uint64_t> loaded(its.size(), 0);
    for (const LockstepEvent& event : each) {
      Move& move = its[number[event.step]];
      (event.comes ? move.load : move.evict).push_back(event.item);
      if (event.comes) {
        const std::uint64_t size = sizes != nullptr ? sizes->bytes[event.item] : 1;
        loaded[number[event.step]] += size;
        result.loads += size;
      }
    }
    for (std::size_t step = 0; step < its.size(); ++step) {
      most[step] = std::max(most[step], loaded[step]);
    }
    lists->add(its);
  }
  for (const std::uint64_t loads : most) {
    result.span += loads;
  }
  result.workers = events.size();
  result.lists = std::move(lists);
  return result;
}

namespace {

/// The steps of a worker that has nothing to do.
class EmptySteps final : public StepSource {
 public:
  explicit EmptySteps(std::uint64_t steps) : steps_(steps) {}

  bool next(Step& step) override {
    for (auto* const list : {&step.evict, &step.load, &step.fast_evict, &step.fast_load}) {
      list->clear();
    }
    step.number = number_ + 1;
    return number_++ < steps_;
  }

 private:
  std::uint64_t steps_;
  std::uint64_t number_ = 0;
};

/// The steps of all workers, alternating.
class InLockstep final : public StepSource {
 public:
  InLockstep(const WorkerMaker& maker, std::uint64_t workers) {
    for (std::uint64_t w = 0; w < workers; ++w) {
      workers_.push_back(maker(w));
    }
  }

  bool next(Step& step) override {
    step.worker = turn_;
    const bool more = workers_[turn_]->next(step);
    turn_ = (turn_ + 1) % workers_.size();
    return more;
  }

 private:
  std::vector<std::unique_ptr<StepSource>> workers_;
  std::size_t turn_ = 0;
};

}  // namespace

WorkerMaker with_idle(WorkerMaker maker, std::uint64_t busy, std::uint64_t steps) {
  return [maker = std::move(maker), busy, steps](std::uint64_t worker) {
    return worker < busy ? maker(worker) : std::make_unique<EmptySteps>(steps);
  };
}

WorkerMaker steps_in(const LockstepLists& lists) {
  return with_idle([lists](std::uint64_t worker) { return lists.lists->of(worker); }, lists.workers,
                   lists.steps);
}

std::unique_ptr<StepSource> in_lockstep(const WorkerMaker& maker, std::uint64_t workers) {
  return std::make_unique<InLockstep>(maker, workers);
}

}  // namespace changeover

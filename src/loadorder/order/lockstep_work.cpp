// What workers in lockstep compute, and whether they do it as they should.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/disjoint.hpp"
#include "loadorder/order/shuffle_pairs.hpp"
#include "loadorder/pairs/wanted_set.hpp"
#include "run/random.hpp"

namespace changeover {

struct LockstepWork::State {
  State(const DisjointOrder& order, const StepWorkOptions& how)
      : options(how),
        random(how.shuffle.value_or(0)),
        memory(static_cast<std::size_t>(order.facts().workers)),
        there(static_cast<std::size_t>(order.facts().items), false),
        loaded(there),
        done({}, order.facts().items) {
    for (std::uint64_t w = 0; w < order.facts().workers; ++w) {
      streams.push_back(order.stream(w));
    }
  }

  StepWorkOptions options;
  Random random;
  std::vector<std::unique_ptr<StepSource>> streams;
  std::vector<std::vector<Element>> memory;
  std::vector<bool> there;
  std::vector<bool> loaded;
  WantedSet done;
};

LockstepWork::LockstepWork(const DisjointOrder& order, const StepWorkOptions& options)
    : state_(std::make_unique<State>(order, options)) {}

LockstepWork::~LockstepWork() = default;
LockstepWork::LockstepWork(LockstepWork&&) noexcept = default;

bool LockstepWork::next(std::vector<WorkStep>& steps) {
  State& s = *state_;
  steps.resize(s.streams.size());
  for (std::size_t w = 0; w < steps.size(); ++w) {
    if (!s.streams[w]->next(steps[w].loads)) {
      return false;
    }
    for (const Element x : steps[w].loads.evict) {
      s.there[x] = false;
    }
    std::erase_if(s.memory[w], [&](Element x) { return !s.there[x]; });
  }
  for (std::size_t w = 0; w < steps.size(); ++w) {
    std::vector<ItemPair>& pairs = steps[w].pairs;
    pairs.clear();
    for (const Element x : steps[w].loads.load) {
      if (s.options.self && !s.loaded[x]) {
        pairs.emplace_back(x, x);
      }
      s.loaded[x] = true;
      for (const Element y : s.memory[w]) {
        if (s.done.insert(x, y)) {
          pairs.emplace_back(std::min(x, y), std::max(x, y));
          if (s.options.ordered) {
            pairs.emplace_back(std::max(x, y), std::min(x, y));
          }
        }
      }
      s.memory[w].push_back(x);
      s.there[x] = true;
    }
    if (s.options.shuffle) {
      shuffle_pairs(pairs, s.random);
    }
  }
  return true;
}

LockstepCheck::LockstepCheck(std::uint64_t items, std::uint64_t room, std::uint64_t workers,
                             const StepWorkOptions& options)
    : room_(room), options_(options) {
  if (items == 0 || room == 0 || workers == 0) {
    throw BadInput(fmt::format("{} items, room for {}, {} workers: give at least 1 of each", items,
                               room, workers));
  }
  if (items > max_elements_in_memory) {
    throw MissingResource(
        fmt::format("{} items have too many pairs to be followed one by one; {} is the most", items,
                    max_elements_in_memory));
  }
  owner_.assign(static_cast<std::size_t>(items), 0);
  held_.assign(static_cast<std::size_t>(workers), 0);
  verdict_.worker_loads.assign(static_cast<std::size_t>(workers), 0);
  computed_.assign(options.ordered ? 2 : 1, PairSet(items));
  alone_.assign(owner_.size(), false);
}

void LockstepCheck::fail(std::uint64_t worker, const std::string& what) {
  if (verdict_.fault.empty()) {
    verdict_.fault = fmt::format("step {}, worker {}: {}", verdict_.steps, worker, what);
  }
}

void LockstepCheck::evict(std::uint64_t worker, const WorkStep& step) {
  if (step.loads.number != verdict_.steps) {
    fail(worker, fmt::format("is numbered {}", step.loads.number));
  }
  for (const Element x : step.loads.evict) {
    if (x >= owner_.size() || owner_[x] != worker + 1) {
      fail(worker, fmt::format("evicts {}, which it does not hold", x));
      return;
    }
    owner_[x] = 0;
    --held_[static_cast<std::size_t>(worker)];
  }
}

void LockstepCheck::load(std::uint64_t worker, const WorkStep& step) {
  const auto w = static_cast<std::size_t>(worker);
  for (const Element x : step.loads.load) {
    if (x >= owner_.size()) {
      fail(worker, fmt::format("loads {}, which is no item", x));
      return;
    }
    if (owner_[x] != 0) {
      fail(worker, fmt::format("loads {}, which worker {} holds", x, owner_[x] - 1));
      return;
    }
    if (held_[w] == room_) {
      fail(worker, fmt::format("loads {} when its memory is full", x));
      return;
    }
    owner_[x] = worker + 1;
    ++held_[w];
  }
  verdict_.worker_loads[w] += step.loads.load.size();
}

void LockstepCheck::compute(std::uint64_t worker, const ItemPair& pair) {
  const auto [x, y] = pair;
  if (x >= owner_.size() || y >= owner_.size() || owner_[x] != worker + 1 ||
      owner_[y] != worker + 1) {
    fail(worker, fmt::format("computes ({},{}) without holding both", x, y));
  } else if (x == y ? !options_.self : x > y && !options_.ordered) {
    fail(worker, fmt::format("computes ({},{}), which is not wanted", x, y));
  } else {
    ++verdict_.computed;
    bool before = false;
    if (x == y) {
      before = alone_[x];
      alone_[x] = true;
    } else {
      PairSet& done = computed_[x < y ? 0 : 1];
      before = done.contains(x, y);
      done.insert(x, y);
    }
    verdict_.repeated += before ? 1U : 0U;
  }
}

void LockstepCheck::read(const std::vector<WorkStep>& steps) {
  if (!verdict_.fault.empty()) {
    return;
  }
  ++verdict_.steps;
  if (steps.size() != held_.size()) {
    verdict_.fault = fmt::format("step {} is of {} workers, not of {}", verdict_.steps,
                                 steps.size(), held_.size());
    return;
  }
  std::uint64_t slowest = 0;
  for (std::size_t w = 0; w < steps.size(); ++w) {
    evict(w, steps[w]);
    slowest = std::max<std::uint64_t>(slowest, steps[w].loads.load.size());
  }
  for (std::size_t w = 0; w < steps.size() && verdict_.fault.empty(); ++w) {
    load(w, steps[w]);
  }
  for (std::size_t w = 0; w < steps.size(); ++w) {
    for (const ItemPair& pair : steps[w].pairs) {
      if (verdict_.fault.empty()) {
        compute(w, pair);
      }
    }
  }
  verdict_.span += slowest;
}

LockstepVerdict LockstepCheck::finish() const {
  LockstepVerdict verdict = verdict_;
  verdict.loads =
      std::accumulate(verdict.worker_loads.begin(), verdict.worker_loads.end(), std::uint64_t{0});
  for (const PairSet& done : computed_) {
    verdict.missing += done.missing();
  }
  if (options_.self) {
    verdict.missing += static_cast<std::uint64_t>(std::count(alone_.begin(), alone_.end(), false));
  }
  return verdict;
}

}  // namespace changeover

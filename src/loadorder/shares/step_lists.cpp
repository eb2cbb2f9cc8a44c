#include "loadorder/shares/step_lists.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "loadorder/shares/idle_items.hpp"

namespace changeover {

namespace {

// What memory moves in each of these steps if it keeps what it evicts as long as there is room.
std::vector<Move> kept_longer(const std::vector<Move>& moves, std::uint64_t room,
                              const ItemSizes* sizes) {
  const auto size = [&](Element x) { return sizes != nullptr ? sizes->bytes[x] : 1; };
  if (sizes != nullptr) {
    room = sizes->memory;
  }
  std::size_t items = 0;
  for (const Move& move : moves) {
    for (const Element x : move.load) {
      items = std::max<std::size_t>(items, std::size_t{x} + 1);
    }
  }
  // The steps that load an item, the next one last.
  std::vector<std::vector<std::size_t>> loads(items);
  for (std::size_t i = moves.size(); i > 0; --i) {
    for (const Element x : moves[i - 1].load) {
      loads[x].push_back(i - 1);
    }
  }
  IdleItems idle(items);
  std::vector<Move> out;
  std::uint64_t held = 0;  // including idle items
  for (const Move& from : moves) {
    Move move;
    for (const Element x : from.evict) {
      idle.add(x, loads[x].empty() ? IdleItems::never : loads[x].back());
    }
    for (const Element x : from.load) {
      loads[x].pop_back();
      if (!idle.erase(x)) {
        move.load.push_back(x);
        held += size(x);
      }
    }
    while (held > room) {
      move.evict.push_back(idle.take_last());
      held -= size(move.evict.back());
    }
    out.push_back(std::move(move));
  }
  return out;
}

}  // namespace

std::vector<Move> lazily(const std::vector<Move>& moves, std::uint64_t room,
                         const ItemSizes* sizes) {
  std::vector<Move> kept = kept_longer(moves, room, sizes);
  std::erase_if(kept, [](const Move& move) { return move.load.empty(); });
  return kept;
}

std::vector<Move> with_a_cache(std::vector<Move> fast, std::uint64_t room, const ItemSizes* sizes) {
  std::vector<Move> moves = kept_longer(fast, room, sizes);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    moves[i].fast_evict = std::move(fast[i].evict);
    moves[i].fast_load = std::move(fast[i].load);
    moves[i].epoch = fast[i].epoch;
  }
  return moves;
}

std::vector<Element> items_in(const Groups& groups, const std::vector<Element>& numbers) {
  std::vector<Element> items;
  for (const Element number : numbers) {
    items.insert(items.end(), groups[number].begin(), groups[number].end());
  }
  return items;
}

std::vector<Move> moves_of(StepSource& steps) {
  std::vector<Move> moves;
  for (Step step; steps.next(step);) {
    moves.push_back({step.evict, step.load, step.fast_evict, step.fast_load, step.epoch});
  }
  return moves;
}

void give_names(std::vector<Move>& moves, const std::vector<Element>& items) {
  for (Move& move : moves) {
    for (auto* const list : {&move.evict, &move.load, &move.fast_evict, &move.fast_load}) {
      for (Element& x : *list) {
        x = items[x];
      }
    }
  }
}

struct StepLists::Lists {
  std::vector<Element> items;  // for each step its evictions, then its loads
  std::vector<std::pair<std::size_t, std::size_t>> ends;  // ends of both lists
  std::shared_ptr<const Lists> fast;  // the same on the accelerator, if anything moves there
  std::vector<std::size_t> epochs;    // the steps with which those after the first begin

  template <typename From>
  static std::shared_ptr<Lists> of(const std::vector<Move>& moves, From&& lists_of) {
    auto lists = std::make_shared<Lists>();
    for (const Move& move : moves) {
      const auto& [leave, come] = lists_of(move);
      lists->items.insert(lists->items.end(), leave.begin(), leave.end());
      const std::size_t middle = lists->items.size();
      lists->items.insert(lists->items.end(), come.begin(), come.end());
      lists->ends.emplace_back(middle, lists->items.size());
    }
    return lists;
  }

  // Reads step `at`, which begins at `begin`; returns where it ends.
  std::size_t read(std::size_t at, std::size_t begin, std::vector<Element>& leave,
                   std::vector<Element>& come) const {
    const auto [middle, end] = ends[at];
    const auto place = [&](std::size_t i) {
      return items.begin() + static_cast<std::ptrdiff_t>(i);
    };
    leave.assign(place(begin), place(middle));
    come.assign(place(middle), place(end));
    return end;
  }
};

void StepLists::add(const std::vector<Move>& moves) {
  auto lists = Lists::of(moves, [](const Move& move) { return std::tie(move.evict, move.load); });
  if (std::ranges::any_of(moves, [](const Move& move) { return !move.fast_load.empty(); })) {
    lists->fast = Lists::of(
        moves, [](const Move& move) { return std::tie(move.fast_evict, move.fast_load); });
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    lists->epochs.resize(static_cast<std::size_t>(moves[i].epoch - 1), i);
  }
  workers_.push_back(std::move(lists));
}

std::unique_ptr<StepSource> StepLists::of(std::uint64_t worker) const {
  class StepReader final : public StepSource {
   public:
    StepReader(std::shared_ptr<const Lists> lists, std::uint64_t worker)
        : lists_(std::move(lists)), worker_(worker) {}

    bool next(Step& step) override {
      if (at_ == lists_->ends.size()) {
        return false;
      }
      begin_ = lists_->read(at_, begin_, step.evict, step.load);
      if (lists_->fast) {
        fast_begin_ = lists_->fast->read(at_, fast_begin_, step.fast_evict, step.fast_load);
      } else {
        step.fast_evict.clear();
        step.fast_load.clear();
      }
      while (epoch_ <= lists_->epochs.size() && lists_->epochs[epoch_ - 1] == at_) {
        ++epoch_;
      }
      step.number = ++at_;
      step.epoch = epoch_;
      step.worker = worker_;
      return true;
    }

   private:
    std::shared_ptr<const Lists> lists_;
    std::uint64_t worker_;
    std::size_t at_ = 0;
    std::size_t epoch_ = 1;
    std::size_t begin_ = 0;
    std::size_t fast_begin_ = 0;
  };
  return std::make_unique<StepReader>(workers_[static_cast<std::size_t>(worker)], worker);
}

namespace {

class AsOneOrder final : public StepSource {
 public:
  AsOneOrder(std::shared_ptr<const WorkerSteps> steps, std::uint64_t workers)
      : steps_(std::move(steps)), workers_(workers) {}

  bool next(Step& step) override {
    while (!one_ || !one_->next(step)) {
      if (worker_ == workers_) {
        return false;
      }
      one_ = steps_->of(worker_++);
    }
    if (step.number == 1) {
      step.evict = held_;
      step.fast_evict = fast_held_;
    }
    follow(step.evict, step.load, held_);
    follow(step.fast_evict, step.fast_load, fast_held_);
    step.number = ++number_;
    step.worker = 0;
    return true;
  }

 private:
  static void follow(std::vector<Element> leave, const std::vector<Element>& come,
                     std::vector<Element>& held) {
    std::ranges::sort(leave);
    std::erase_if(held, [&](Element x) { return std::ranges::binary_search(leave, x); });
    held.insert(held.end(), come.begin(), come.end());
  }

  std::shared_ptr<const WorkerSteps> steps_;
  std::uint64_t workers_;
  std::unique_ptr<StepSource> one_;
  std::uint64_t worker_ = 0;
  std::uint64_t number_ = 0;
  std::vector<Element> held_;
  std::vector<Element> fast_held_;  // on the accelerator
};

}  // namespace

LoadOrder::Maker in_memory(const std::vector<Move>& moves) {
  const auto lists = std::make_shared<StepLists>();
  lists->add(moves);
  return [lists] { return lists->of(0); };
}

std::unique_ptr<StepSource> one_after_another(std::shared_ptr<const WorkerSteps> steps,
                                              std::uint64_t workers) {
  return std::make_unique<AsOneOrder>(std::move(steps), workers);
}

}  // namespace changeover

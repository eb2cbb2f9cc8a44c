#include "loadorder/shares/step_lists.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace changeover {

namespace {

// What memory moves in each of these steps if it keeps what it evicts as long as there is room.
std::vector<Move> kept_longer(const std::vector<Move>& moves, std::uint64_t room,
                              const ItemSizes* sizes) {
  const auto size = [&](Element x) { return sizes != nullptr ? sizes->bytes[x] : 1; };
  if (sizes != nullptr) {
    room = sizes->memory;
  }
  constexpr std::size_t never = ~std::size_t{0};
  // The step in which an evicted item is loaded again.
  std::unordered_map<Element, std::size_t> next;
  std::vector<std::vector<std::size_t>> again(moves.size());
  for (std::size_t i = moves.size(); i > 0; --i) {
    const Move& move = moves[i - 1];
    for (const Element x : move.load) {
      next[x] = i - 1;
    }
    for (const Element x : move.evict) {
      const auto found = next.find(x);
      again[i - 1].push_back(found == next.end() ? never : found->second);
    }
  }
  std::priority_queue<std::pair<std::size_t, Element>>
      idle;  // candidates for eviction, the one needed last first
  std::unordered_map<Element, std::size_t> is_idle;
  std::vector<Move> out;
  std::uint64_t held = 0;  // including idle items
  for (std::size_t i = 0; i < moves.size(); ++i) {
    Move move;
    for (std::size_t j = 0; j < moves[i].evict.size(); ++j) {
      idle.emplace(again[i][j], moves[i].evict[j]);
      is_idle[moves[i].evict[j]] = again[i][j];
    }
    for (const Element x : moves[i].load) {
      if (is_idle.erase(x) == 0) {
        move.load.push_back(x);
        held += size(x);
      }
    }
    while (held > room) {
      const auto [when, item] = idle.top();
      idle.pop();
      const auto found = is_idle.find(item);
      if (found != is_idle.end() && found->second == when) {
        is_idle.erase(found);
        move.evict.push_back(item);
        held -= size(item);
      }
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

#include "loadorder/shares/step_lists.hpp"

#include <algorithm>
#include <queue>
#include <unordered_map>
#include <utility>

namespace changeover {

std::vector<Move> lazily(std::vector<Move> moves, std::uint64_t room) {
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
  std::size_t held = 0;  // including idle items
  for (std::size_t i = 0; i < moves.size(); ++i) {
    Move move;
    for (std::size_t j = 0; j < moves[i].evict.size(); ++j) {
      idle.emplace(again[i][j], moves[i].evict[j]);
      is_idle[moves[i].evict[j]] = again[i][j];
    }
    for (const Element x : moves[i].load) {
      if (is_idle.erase(x) == 0) {
        move.load.push_back(x);
      }
    }
    while (held + move.load.size() > room) {
      const auto [when, item] = idle.top();
      idle.pop();
      const auto found = is_idle.find(item);
      if (found != is_idle.end() && found->second == when) {
        is_idle.erase(found);
        move.evict.push_back(item);
        --held;
      }
    }
    held += move.load.size();
    if (!move.load.empty()) {
      out.push_back(std::move(move));
    }
  }
  return out;
}

struct StepLists::Lists {
  std::vector<Element> items;  // for each step its evictions, then its loads
  std::vector<std::pair<std::size_t, std::size_t>> ends;  // ends of both lists
};

void StepLists::add(const std::vector<Move>& moves) {
  auto lists = std::make_shared<Lists>();
  for (const Move& move : moves) {
    lists->items.insert(lists->items.end(), move.evict.begin(), move.evict.end());
    const std::size_t middle = lists->items.size();
    lists->items.insert(lists->items.end(), move.load.begin(), move.load.end());
    lists->ends.emplace_back(middle, lists->items.size());
  }
  workers_.push_back(std::move(lists));
}

std::unique_ptr<StepSource> StepLists::of(std::uint64_t worker) const {
  class Reader final : public StepSource {
   public:
    Reader(std::shared_ptr<const Lists> lists, std::uint64_t worker)
        : lists_(std::move(lists)), worker_(worker) {}

    bool next(Step& step) override {
      if (at_ == lists_->ends.size()) {
        return false;
      }
      const auto [middle, end] = lists_->ends[at_];
      const auto place = [&](std::size_t i) {
        return lists_->items.begin() + static_cast<std::ptrdiff_t>(i);
      };
      step.evict.assign(place(begin_), place(middle));
      step.load.assign(place(middle), place(end));
      begin_ = end;
      step.number = ++at_;
      step.worker = worker_;
      return true;
    }

   private:
    std::shared_ptr<const Lists> lists_;
    std::uint64_t worker_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;
  };
  return std::make_unique<Reader>(workers_[static_cast<std::size_t>(worker)], worker);
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
    }
    std::vector<Element> left = step.evict;
    std::sort(left.begin(), left.end());
    std::erase_if(held_,
                  [&](Element x) { return std::binary_search(left.begin(), left.end(), x); });
    held_.insert(held_.end(), step.load.begin(), step.load.end());
    step.number = ++number_;
    step.worker = 0;
    return true;
  }

 private:
  std::shared_ptr<const WorkerSteps> steps_;
  std::uint64_t workers_;
  std::unique_ptr<StepSource> one_;
  std::uint64_t worker_ = 0;
  std::uint64_t number_ = 0;
  std::vector<Element> held_;
};

}  // namespace

std::unique_ptr<StepSource> one_after_another(std::shared_ptr<const WorkerSteps> steps,
                                              std::uint64_t workers) {
  return std::make_unique<AsOneOrder>(std::move(steps), workers);
}

}  // namespace changeover

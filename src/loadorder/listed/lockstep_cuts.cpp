#include "loadorder/listed/lockstep_cuts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/listed/parts.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/listed/stretches_in_lockstep.hpp"
#include "loadorder/listed/tasks.hpp"
#include "loadorder/order/lockstep/crews.hpp"
#include "loadorder/pairs/pair_bounds.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

/// A cut of the items into parts, or of an order into stretches, and the steps that it gives.
struct Cut {
  std::size_t order = of_parts;     // whose stretches they are
  std::vector<std::size_t> begins;  // the first is 0
  std::uint64_t busy = 0;           // workers
  LockstepLists lists;

  static constexpr std::size_t of_parts = ~std::size_t{0};

  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> cost() const {
    return {lists.span, lists.loads};
  }
};

/// Looks for a cut with a small span.
class CutSearch {
 public:
  /// `orders` are those of one worker, the best one first; `items` have to be loaded.
  CutSearch(const PairGraph& graph, const std::vector<std::vector<LoadMove>>& orders,
            std::uint64_t items, std::uint64_t room, std::uint64_t workers, std::uint64_t seed)
      : graph_(graph),
        items_(items),
        room_(room),
        crews_(crews(items, room, workers)),
        random_(seed),
        parts_(graph, orders.front(), room) {
    for (const std::vector<LoadMove>& order : orders) {
      stretches_.emplace_back(graph, order);
    }
  }

  /// Parts with about as many pairs each, W to 8 W of them, and stretches with as many jobs; if the
  /// workers together have room for more than all items, for fewer busy ones, too.
  void try_even_cuts() {
    for (const Crew& crew : crews_) {
      if (!best_ || least_span(crew.workers) <= best_->lists.span) {
        try_even_cuts(crew.workers);
      }
    }
  }

  /// Changes cuts a little, again and again, until this thread is asked to stop or the span is
  /// `bound`.
  void improve(std::uint64_t bound) {
    constexpr std::uint64_t patience = 300;
    try {
      Cut now = *best_;
      do {
        for (std::uint64_t since = 0; since < patience && best_->lists.span > bound; ++since) {
          tell(bound);
          auto next = changed(now);
          if (next && next->cost() <= now.cost()) {
            since = next->cost() < now.cost() ? 0 : since;
            now = *next;
            keep(std::move(next));
          }
        }
        now = another_start();
      } while (RunScope::current() != nullptr && best_->lists.span > bound);
    } catch (const Stopped&) {
      // The best cut so far is used.
    }
  }

  [[nodiscard]] Cut take() { return std::move(*best_); }

 private:
  static constexpr std::size_t most_tasks = 10'000;  // which a worker looks through

  void try_even_cuts(std::uint64_t busy) {
    const std::uint64_t most_work = 20'000'000 / crews_.size();  // some seconds in all
    std::uint64_t work = 0;
    for (const std::uint64_t times : {2U, 3U, 4U, 1U, 6U, 8U}) {
      if (!best_ || work <= most_work) {
        keep(of_parts(parts_.even_cut(times * busy), busy, most_tasks));
        work += graph_.pairs();
      }
    }
    for (std::uint64_t parts = 128; !best_; parts /= 2) {  // all have pairs with each other
      keep(of_parts(parts_.even_cut(parts), busy, not_again));
    }
    for (std::size_t order = 0; order < stretches_.size() && work <= most_work; ++order) {
      keep(of_stretches(order, stretches_[order].even_cut(busy), busy));
      work += graph_.pairs();
    }
  }

  // A lower bound: items and pairs are those of all busy workers.
  [[nodiscard]] std::uint64_t least_span(std::uint64_t busy) const {
    return std::max(ceil_div(items_, busy), least_loads(ceil_div(graph_.pairs(), busy), room_));
  }

  // The steps of the best choice of tasks; nullopt if there would be more than `most`.
  std::optional<Cut> of_parts(std::vector<std::size_t> begins, std::uint64_t workers,
                              std::size_t most) {
    const auto tasks = parts_.tasks(begins, most);
    if (!tasks) {
      return std::nullopt;
    }
    Cut cut{.begins = std::move(begins), .busy = workers, .lists = {}};
    for (const NextTask choice : {NextTask::most_left, NextTask::same_part, NextTask::largest}) {
      stop_if_asked();
      const std::uint64_t busy = std::min<std::uint64_t>(workers, tasks->parts.size());
      take_better(cut.lists,
                  lists_of(play_tasks(*tasks, graph_.items(), room_, busy, choice), &graph_));
    }
    return cut;
  }

  // The steps of stretches of an order; nullopt if they are far from the best.
  std::optional<Cut> of_stretches(std::size_t order, std::vector<std::size_t> begins,
                                  std::uint64_t workers) {
    Cut cut{.order = order, .begins = std::move(begins), .busy = workers, .lists = {}};
    stretches_[order].play_each(cut.begins, 2 * best_->lists.span, [&](LockstepEvents events) {
      take_better(cut.lists, lists_of(std::move(events), &graph_));
    });
    return cut.lists.lists == nullptr ? std::nullopt : std::optional(std::move(cut));
  }

  static void take_better(LockstepLists& best, LockstepLists lists) {
    if (best.lists == nullptr ||
        std::pair(lists.span, lists.loads) < std::pair(best.span, best.loads)) {
      best = std::move(lists);
    }
  }

  void keep(std::optional<Cut> cut) {
    if (cut && (!best_ || cut->cost() < best_->cost())) {
      best_ = std::move(cut);
    }
  }

  // A part or stretch begins somewhere else; or a part is joined to the one before it, or cut in
  // two.
  std::optional<Cut> changed(const Cut& from) {
    std::vector<std::size_t> begins = from.begins;
    const bool is_of_parts = from.order == Cut::of_parts;
    const std::size_t all = is_of_parts ? parts_.items() : stretches_[from.order].jobs();
    const std::size_t at = below(begins.size());
    const std::size_t end = at + 1 < begins.size() ? begins[at + 1] : all;
    const std::uint64_t kind = is_of_parts ? below(8) : 2;
    if (kind == 0) {
      begins.push_back(begins[at] + below(end - begins[at]));
    } else if (kind == 1 && at > 0) {
      begins.erase(begins.begin() + static_cast<std::ptrdiff_t>(at));
    } else if (at > 0) {
      const std::size_t before = begins[at - 1];
      const std::size_t reach = 1 + below(std::max<std::size_t>(1, (end - before) / 2));
      const std::size_t to =
          below(2) == 0 ? begins[at] + reach : begins[at] - std::min(reach, begins[at]);
      begins[at] = std::clamp(to, before, end);
    }
    std::ranges::sort(begins);
    begins.erase(std::unique(begins.begin(), begins.end()), begins.end());
    std::erase(begins, all);
    return begins == from.begins ? std::nullopt
           : is_of_parts         ? of_parts(std::move(begins), from.busy, most_tasks)
                                 : of_stretches(from.order, std::move(begins), from.busy);
  }

  // An even cut, or the best one.
  Cut another_start() {
    const std::uint64_t kind = below(4);
    const std::size_t order = below(stretches_.size());
    const std::uint64_t busy = best_->busy;
    auto start = kind == 0 ? of_parts(parts_.even_cut(busy + 1 + below(8 * busy)), busy, most_tasks)
                 : kind == 1 ? of_stretches(order, stretches_[order].even_cut(busy), busy)
                             : std::nullopt;
    keep(start);
    return start ? std::move(*start) : *best_;
  }

  std::size_t below(std::uint64_t limit) {
    return random_.below(static_cast<std::uint32_t>(limit));
  }

  void tell(std::uint64_t bound) const {
    if (progress_due()) {
      report_progress(
          {.phase = "improving the load order", .best = best_->lists.span, .lower_bound = bound});
    }
  }

  const PairGraph& graph_;
  std::uint64_t items_;
  std::uint64_t room_;
  std::vector<Crew> crews_;
  Random random_;
  TaskMaker parts_;
  std::vector<StretchesInLockstep> stretches_;  // by order
  std::optional<Cut> best_;
};

}  // namespace

LockstepLists lockstep_of_list(LoadOrderFacts& facts, const PairGraph& graph,
                               const LoadOrderOptions& options) {
  CutSearch search(graph, several_orders(graph, facts.room),
                   needed_items(facts.wanted.among(facts.items)), facts.room, facts.lockstep,
                   options.seed);
  search.try_even_cuts();
  if (options.search_pairs) {
    options.search_pairs([&] { search.improve(facts.makespan_bound.loads); });
  }
  Cut best = search.take();
  if (best.order == Cut::of_parts) {
    facts.method = "parts";
    facts.explanation = fmt::format(
        "The items are in {}. A worker has two of them at a time, which no other one has, "
        "and loads what their pairs need.",
        count_of(best.begins.size(), "part"));
  } else {
    facts.method = "stretches";
    facts.explanation = fmt::format(
        "An order of one worker is cut into {}. A worker waits for an item that another one holds "
        "and needs soon.",
        count_of(best.begins.size(), "stretch", "stretches"));
  }
  facts.explanation = say_idle(best.busy, facts.lockstep) + facts.explanation;
  return std::move(best.lists);
}

}  // namespace changeover

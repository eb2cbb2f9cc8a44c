#include "loadorder/sizes/closing_search.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "changeover/run/control.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/pairs/starts.hpp"

namespace changeover {

std::vector<Move> in_steps(const std::vector<SizedMove>& moves) {
  std::vector<Move> steps;
  for (const SizedMove& move : moves) {
    if (steps.size() == 1 && move.evict.empty()) {
      steps.front().load.push_back(move.load);
    } else {
      steps.push_back({move.evict, {move.load}});
    }
  }
  return steps;
}

std::vector<SizedMove> one_by_one(const std::vector<Move>& moves, const ItemSizes& sizes) {
  std::vector<SizedMove> all;
  std::uint64_t held = 0;
  for (const Move& move : moves) {
    auto goes = move.evict.begin();
    for (const Element x : move.load) {
      SizedMove& its = all.emplace_back(SizedMove{x, {}});
      for (held += sizes.bytes[x]; held > sizes.memory; held -= sizes.bytes[*goes++]) {
        its.evict.push_back(*goes);
      }
    }
  }
  return all;
}

void give_names(std::vector<SizedMove>& moves, const std::vector<Element>& items) {
  for (SizedMove& move : moves) {
    move.load = items[move.load];
    for (Element& x : move.evict) {
      x = items[x];
    }
  }
}

ClosingSearch::ClosingSearch(const ItemSizes& sizes, const PairGraph& graph, std::uint64_t room,
                             std::uint64_t least, std::uint64_t seed)
    : sizes_(sizes),
      graph_(graph),
      room_(room),
      least_(least),
      random_(seed),
      closing_(sizes, graph) {}

SizedOffer ClosingSearch::offer() {
  closing_.run(best_);
  return {closing_.moves(), bytes_, "closing, " + name_,
          "Items are closed one after another: what an item lacks is loaded while it stays; what "
          "is needed last is evicted, as much as makes room."};
}

void ClosingSearch::try_start(const std::string& name, std::vector<Element> order) {
  const std::uint64_t limit = best_.empty() ? ByteClosing::no_limit : bytes_ - 1;
  std::uint64_t bytes = ByteClosing::no_limit;
  const auto run = [&] { bytes = closing_.run(order, limit); };
  if (best_.empty()) {
    in_spite_of_the_time(run);
  } else if (!done(true, run)) {
    return;
  }
  if (best_.empty() || bytes <= limit) {
    bytes_ = bytes;
    best_ = std::move(order);
    name_ = name;
  }
  count_try();
}

// A load examines the items in memory, and the start examines all pairs.
void ClosingSearch::count_try() {
  looked_ += closing_.moves().size() * (4 + std::min<std::uint64_t>(room_, 64)) + graph_.pairs();
  ++tries_;
}

void ClosingSearch::begin(const Over& over) {
  std::vector<Element> order(static_cast<std::size_t>(graph_.items()));
  std::iota(order.begin(), order.end(), 0U);
  try_start("numbered", order);
  std::ranges::stable_sort(order,
                           [&](Element a, Element b) { return sizes_.bytes[a] > sizes_.bytes[b]; });
  try_start("largest first", order);
  std::ranges::reverse(order);
  try_start("smallest first", order);
  each_start(graph_, room_, [&](const std::string& name, std::vector<Element> start) {
    try_start(name, std::move(start));
    return bytes_ > least_ && !over();
  });
}

void ClosingSearch::improve(std::uint64_t work, const Over& over) {
  const std::uint64_t end = looked_ + std::min(work, ~std::uint64_t{0} - looked_);
  const auto items = static_cast<std::uint32_t>(best_.size());
  std::vector<Element> order;
  while (!is_done() && looked_ < end && !over()) {
    order = best_;
    const std::uint32_t from = random_.below(items);
    const std::uint32_t to = random_.below(items);
    if (random_.one_in_two()) {
      std::swap(order[from], order[to]);
    } else if (from < to) {
      std::rotate(order.begin() + from, order.begin() + from + 1, order.begin() + to + 1);
    } else {
      std::rotate(order.begin() + to, order.begin() + from, order.begin() + from + 1);
    }
    // An equally good order is kept, since it may lead to a better one.
    std::uint64_t bytes = 0;
    if (!done(true, [&] { bytes = closing_.run(order, bytes_); })) {
      return;
    }
    if (bytes <= bytes_) {
      name_ = bytes < bytes_ ? "improved" : name_;
      bytes_ = bytes;
      best_ = std::move(order);
    }
    count_try();
    if (progress_due()) {
      report_progress({.phase = "improving the load order",
                       .steps = tries_,
                       .unit = "orders",
                       .best = bytes_,
                       .lower_bound = least_});
    }
  }
}

SizedOffer best_closing(const ItemSizes& sizes, const PairGraph& graph, std::uint64_t room,
                        std::uint64_t least, const LoadOrderOptions& options) {
  ClosingSearch search(sizes, graph, room, least, options.seed);
  fixed_first(
      options,
      [&] {
        constexpr double most_work = 20'000'000;  // a second or so
        const auto work = static_cast<std::uint64_t>(options.effort * most_work);
        std::uint64_t tries = 0;
        constexpr std::uint64_t most_tries = 10'000;
        search.begin(must_hurry);
        search.improve(work - std::min(work, search.looked()),
                       [&] { return must_hurry() || tries++ == most_tries; });
      },
      [&](RunControl& control) {
        search.improve(~std::uint64_t{0}, [&] { return control.stop_wanted(); });
      });
  return search.offer();
}

}  // namespace changeover

#include "loadorder/listed/tasks.hpp"

#include <algorithm>
#include <unordered_map>

#include "changeover/run/control.hpp"
#include "loadorder/listed/quick_moves.hpp"

namespace changeover {
namespace {

// The items in the order of their first loads.
std::vector<Element> sequence_of(const PairGraph& graph, const std::vector<LoadMove>& moves) {
  std::vector<Element> sequence;
  std::vector<bool> seen(static_cast<std::size_t>(graph.items()), false);
  for (const LoadMove& move : moves) {
    if (!seen[move.load]) {
      seen[move.load] = true;
      sequence.push_back(move.load);
    }
  }
  return sequence;
}

}  // namespace

TaskMaker::TaskMaker(const PairGraph& graph, const std::vector<LoadMove>& order, std::uint64_t room)
    : graph_(graph), sequence_(sequence_of(graph, order)), room_(room) {}

std::vector<std::size_t> TaskMaker::even_cut(std::uint64_t wanted) const {
  constexpr std::uint64_t most_parts = 2'000;
  const std::uint64_t count =
      std::min({wanted, most_parts, static_cast<std::uint64_t>(sequence_.size())});
  std::vector<std::size_t> begins;
  const std::uint64_t all = 2 * graph_.pairs() + sequence_.size();
  std::uint64_t before = 0;
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < sequence_.size(); ++i) {
    if (const std::uint64_t part = before * count / all; i == 0 || part > last) {
      begins.push_back(i);
      last = part;
    }
    before += graph_.partners(sequence_[i]).size() + 1;
  }
  return begins;
}

std::optional<Tasks> TaskMaker::tasks(const std::vector<std::size_t>& begins, std::size_t most) {
  const std::size_t count = begins.size();
  const auto end_of = [&](std::size_t p) { return p + 1 < count ? begins[p + 1] : items(); };
  Tasks result;
  std::vector<std::size_t> part_of(static_cast<std::size_t>(graph_.items()), 0);
  for (std::size_t p = 0; p < count; ++p) {
    std::vector<Element>& part = result.parts.emplace_back();
    for (std::size_t i = begins[p]; i < end_of(p); ++i) {
      part.push_back(sequence_[i]);
      part_of[sequence_[i]] = p;
    }
  }
  const std::vector<std::vector<Element>>& parts = result.parts;
  std::vector<std::vector<ItemPair>> pairs;
  std::unordered_map<std::uint64_t, std::size_t> number;
  const auto task = [&](std::size_t a, std::size_t b) {
    const auto [found, is_new] = number.try_emplace(
        std::uint64_t{std::min(a, b)} * count + std::max(a, b), result.tasks.size());
    if (is_new) {
      result.tasks.push_back({std::min(a, b), std::max(a, b), nullptr});
      pairs.emplace_back();
    }
    return found->second;
  };
  for (const std::vector<Element>& part : parts) {
    for (const Element x : part) {
      for (const Element y : graph_.partners(x)) {
        if (x < y && part_of[x] != part_of[y]) {
          pairs[task(part_of[x], part_of[y])].emplace_back(x, y);
        }
      }
    }
    if (result.tasks.size() > most) {
      return std::nullopt;
    }
  }
  // Pairs within a part go to its largest task.
  std::vector<std::size_t> largest(count, not_again);
  for (std::size_t t = 0; t < result.tasks.size(); ++t) {
    for (const std::size_t p : {result.tasks[t].a, result.tasks[t].b}) {
      if (largest[p] == not_again || pairs[t].size() > pairs[largest[p]].size()) {
        largest[p] = t;
      }
    }
  }
  for (std::size_t p = 0; p < count; ++p) {
    for (const Element x : parts[p]) {
      for (const Element y : graph_.partners(x)) {
        if (x < y && part_of[y] == p) {
          largest[p] = largest[p] == not_again ? task(p, p) : largest[p];
          pairs[largest[p]].emplace_back(x, y);
        }
      }
      if (graph_.partners(x).empty()) {
        largest[p] = largest[p] == not_again ? task(p, p) : largest[p];
        pairs[largest[p]].emplace_back(x, x);
      }
    }
  }
  constexpr std::uint64_t most_known = 20'000'000;  // moves
  if (known_moves_ > most_known) {
    known_.clear();
    known_moves_ = 0;
  }
  for (std::size_t t = 0; t < result.tasks.size(); ++t) {
    stop_if_asked();
    Task& its = result.tasks[t];
    auto& order = known_[{begins[its.a], end_of(its.a), largest[its.a] == t, begins[its.b],
                          end_of(its.b), largest[its.b] == t}];
    if (order == nullptr) {
      order = std::make_shared<const std::vector<LoadMove>>(
          quick_moves(pairs[t], items_of(pairs[t]), room_));
      known_moves_ += order->size();
    }
    its.order = order;
    pairs[t] = {};
  }
  return result;
}

}  // namespace changeover

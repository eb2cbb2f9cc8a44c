#include "changeover/loadorder/wanted_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {

PairGraph::PairGraph(std::uint64_t items, std::span<const ItemPair> pairs,
                     std::vector<std::string> names)
    : PairGraph(
          items,
          [pairs](const Visit& visit) {
            for (const auto& [x, y] : pairs) {
              visit(x, y);
            }
          },
          std::move(names)) {}

PairGraph::PairGraph(std::uint64_t items, const std::function<void(const Visit&)>& each,
                     std::vector<std::string> names)
    : names_(std::move(names)) {
  if (items > most_items) {
    throw ImpossibleParameters(
        fmt::format("{} items: at most {}; group items into larger ones", items, most_items));
  }
  if (!names_.empty() && names_.size() != items) {
    throw BadInput(fmt::format("{} for {}; give all or none", count_of(names_.size(), "name"),
                               count_of(items, "item")));
  }
  begin_.assign(static_cast<std::size_t>(items) + 1, 0);
  needed_.assign(static_cast<std::size_t>(items), false);
  each([&](Element x, Element y) {
    if (x >= items || y >= items) {
      throw BadInput(
          fmt::format("the pair {{{},{}}} is not of {} numbered from 0; correct it, or "
                      "give more items",
                      x, y, count_of(items, "item")));
    }
    needed_[x] = needed_[y] = true;
    if (x != y) {
      ++begin_[x + std::size_t{1}];
      ++begin_[y + std::size_t{1}];
    }
  });
  for (std::size_t i = 1; i < begin_.size(); ++i) {
    begin_[i] += begin_[i - 1];
  }
  partners_.resize(begin_.back());
  std::vector<std::uint64_t> end(begin_.begin(), begin_.end() - 1);
  each([&](Element x, Element y) {
    if (x != y) {
      partners_[end[x]++] = y;
      partners_[end[y]++] = x;
    }
  });
  // Removes repeated pairs.
  std::uint64_t kept = 0;
  for (std::size_t x = 0; x < items; ++x) {
    const auto at = [&](std::uint64_t i) {
      return partners_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const std::uint64_t begin = kept;
    std::sort(at(begin_[x]), at(begin_[x + 1]));
    const auto last = std::unique(at(begin_[x]), at(begin_[x + 1]));
    kept += static_cast<std::uint64_t>(std::move(at(begin_[x]), last, at(begin)) - at(begin));
    begin_[x] = begin;
  }
  begin_.back() = kept;
  partners_.resize(kept);
}

std::optional<std::uint64_t> PairGraph::place(Element x, Element y) const {
  if (x > y) {
    std::swap(x, y);
  }
  const auto of_x = partners(x);
  const auto found = std::ranges::lower_bound(of_x, y);
  if (found == of_x.end() || *found != y) {
    return std::nullopt;
  }
  return begin_[x] + static_cast<std::uint64_t>(found - of_x.begin());
}

WantedPairs WantedPairs::between(std::uint64_t a, std::uint64_t b) {
  if (a == 0 || b == 0) {
    throw BadInput(fmt::format("{} with {}: give at least 1 of both", count_of(a, "item"),
                               count_of(b, "other")));
  }
  WantedPairs wanted;
  wanted.kind_ = Kind::between;
  wanted.items_ = checked_add(a, b);
  wanted.first_ = a;
  return wanted;
}

WantedPairs WantedPairs::beyond(std::uint64_t done, std::uint64_t items) {
  if (done >= items) {
    throw BadInput(fmt::format(
        "the pairs of {} of {} are done, and nothing is left to load; give fewer that are "
        "done",
        done, count_of(items, "item")));
  }
  WantedPairs wanted;
  wanted.kind_ = Kind::beyond;
  wanted.items_ = items;
  wanted.first_ = done;
  return wanted;
}

WantedPairs WantedPairs::listed(std::shared_ptr<const PairGraph> graph) {
  WantedPairs wanted;
  wanted.kind_ = Kind::listed;
  wanted.items_ = graph->items();
  wanted.graph_ = std::move(graph);
  for (Element x = 0; x < wanted.items_; ++x) {
    if (wanted.needs(x)) {
      return wanted;
    }
  }
  throw BadInput("no pair is listed; give two items per line");
}

WantedPairs WantedPairs::whole(std::shared_ptr<const PairGraph> graph) {
  WantedPairs wanted = listed(std::move(graph));
  wanted.whole_ = true;
  return wanted;
}

std::uint64_t WantedPairs::count() const {
  switch (kind_) {
    case Kind::all:
      return binomial(items_, 2);
    case Kind::between:
      return checked_multiply(first_, items_ - first_);
    case Kind::beyond:
      return binomial(items_, 2) - binomial(first_, 2);
    default:
      return graph_->pairs();
  }
}

std::string WantedPairs::describe() const {
  const std::uint64_t rest = items_ - first_;
  switch (kind_) {
    case Kind::all:
      return "all pairs";
    case Kind::between:
      return fmt::format("{} with {}", count_of(first_, "item"), count_of(rest, "other"));
    case Kind::beyond:
      return fmt::format("{} with {}{}", count_of(rest, "new item"),
                         rest == 1 ? "" : "each other and with ", count_of(first_, "old one"));
    default:
      return whole_ ? count_of(items_, "item") : count_of(graph_->pairs(), "listed pair");
  }
}

std::uint64_t WantedPairs::hash() const {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto mix = [&](std::uint64_t value) { hash = (hash ^ value) * 1099511628211ULL; };
  mix(static_cast<std::uint64_t>(kind_));
  mix(are_all() ? 0 : items_);
  mix(first_);
  if (graph_) {
    for (Element x = 0; x < items_; ++x) {
      mix(graph_->is_needed(x) ? 1 : 0);
      for (const Element y : graph_->partners(x)) {
        mix(y);
      }
    }
  }
  return hash;
}

}  // namespace changeover

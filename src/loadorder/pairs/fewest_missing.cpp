#include "loadorder/pairs/fewest_missing.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

class FewestMissing {
 public:
  FewestMissing(const PairGraph& graph, std::uint64_t room, BucketQueue::Ties ties)
      : graph_(graph),
        room_(room),
        begin_(static_cast<std::size_t>(graph.items()) + 1, 0),
        lacks_(static_cast<std::size_t>(graph.items())),
        closed_(static_cast<std::size_t>(graph.items()), false),
        there_(static_cast<std::size_t>(graph.items()), ties),
        gone_(static_cast<std::size_t>(graph.items()), ties),
        resting_(static_cast<std::size_t>(graph.items()), BucketQueue::Ties::oldest) {
    for (Element x = 0; x < graph.items(); ++x) {
      const std::size_t partners = graph.partners(x).size();
      begin_[x + std::size_t{1}] = begin_[x] + partners;
      lacks_[x] = static_cast<std::uint32_t>(partners);
    }
    met_.resize(static_cast<std::size_t>(begin_.back()), false);
  }

  std::vector<Element> order(const std::vector<Element>& roots,
                             const std::function<bool()>& give_up) {
    order_.reserve(roots.size());
    for (const Element root : roots) {
      for (std::optional<Element> x = root; x; x = take_next()) {
        if (!closed_[*x]) {
          close(*x);
        }
        if (give_up && give_up()) {
          return {};
        }
        if (progress_due()) {
          report_progress(
              {.phase = "choosing what is closed next", .steps = order_.size(), .unit = "items"});
        }
      }
    }
    return std::move(order_);
  }

 private:
  std::optional<Element> take_next() {
    if (const auto x = there_.take_lowest()) {
      keep(*x);
      return x;
    }
    return gone_.take_lowest();
  }

  void close(Element x) {
    if (!resting_.holds(x)) {
      load(x);
    }
    if (resting_.holds(x)) {  // it is not evicted now
      there_.remove(x);
      resting_.remove(x);
      --in_memory_;
    }
    held_ = 1;
    missing_.clear();
    const auto partners = graph_.partners(x);
    for (std::size_t i = 0; i < partners.size(); ++i) {
      if (!met_[begin_[x] + i]) {
        missing_.push_back(partners[i]);
      }
    }
    // Items that will be closed soon come last, so they stay longest.
    std::ranges::sort(missing_, [&](Element a, Element b) {
      return lacks_[a] != lacks_[b] ? lacks_[a] > lacks_[b] : a > b;
    });
    for (const Element y : missing_) {
      meet(x, y);
      load(y);
    }
    held_ = 0;
    finish(x);
  }

  void load(Element x) {
    while (in_memory_ + held_ >= room_) {
      const auto old = resting_.take_lowest();
      there_.remove(*old);
      gone_.put(*old, lacks_[*old]);
      --in_memory_;
    }
    gone_.remove(x);
    const auto partners = graph_.partners(x);
    for (std::size_t i = 0; i < partners.size(); ++i) {
      const Element y = partners[i];
      if (resting_.holds(y) && !met_[begin_[x] + i]) {
        meet(x, y);
        settle(y);
      }
    }
    ++in_memory_;
    settle(x);
  }

  // Called after x has met a partner.
  void settle(Element x) {
    if (lacks_[x] == 0) {
      there_.remove(x);
      resting_.remove(x);
      --in_memory_;
      finish(x);
    } else {
      keep(x);
    }
  }

  void keep(Element x) {
    there_.put(x, lacks_[x]);
    resting_.put(x, 0);
  }

  void meet(Element x, Element y) {
    for (const auto& [a, b] : {std::pair(x, y), std::pair(y, x)}) {
      const auto of_a = graph_.partners(a);
      const auto found = std::ranges::lower_bound(of_a, b);
      met_[begin_[a] + static_cast<std::uint64_t>(found - of_a.begin())] = true;
      --lacks_[a];
    }
  }

  void finish(Element x) {
    if (!closed_[x]) {
      closed_[x] = true;
      order_.push_back(x);
    }
  }

  const PairGraph& graph_;
  std::uint64_t room_;
  std::vector<std::uint64_t> begin_;  // start of an item's places in met_
  std::vector<bool> met_;
  std::vector<std::uint32_t> lacks_;
  std::vector<bool> closed_;
  BucketQueue there_;    // in memory, by missing partners
  BucketQueue gone_;     // evicted, by missing partners
  BucketQueue resting_;  // in memory, least recently met first
  std::uint64_t in_memory_ = 0;
  std::uint64_t held_ = 0;
  std::vector<Element> missing_;
  std::vector<Element> order_;
};

}  // namespace

std::vector<Element> fewest_missing_order(const PairGraph& graph, std::uint64_t room,
                                          const std::vector<Element>& roots, BucketQueue::Ties ties,
                                          const std::function<bool()>& give_up) {
  return FewestMissing(graph, room, ties).order(roots, give_up);
}

}  // namespace changeover

#include "loadorder/pairs/starts.hpp"

#include <algorithm>
#include <numeric>

#include "loadorder/pairs/bucket_queue.hpp"
#include "loadorder/pairs/fewest_missing.hpp"

namespace changeover {
namespace {

using Order = std::vector<Element>;

// Appends all items that are reachable from `root`, level by level; items with few partners come
// first.
void append_levels(const PairGraph& graph, Element root, std::vector<bool>& seen, Order& order) {
  std::size_t next = order.size();
  seen[root] = true;
  order.push_back(root);
  for (; next < order.size(); ++next) {
    const std::size_t first = order.size();
    for (const Element y : graph.partners(order[next])) {
      if (!seen[y]) {
        seen[y] = true;
        order.push_back(y);
      }
    }
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
              [&](Element a, Element b) {
                const std::size_t da = graph.partners(a).size();
                const std::size_t db = graph.partners(b).size();
                return da != db ? da < db : a < b;
              });
  }
}

// An end of each component: the last item of a breadth-first search that starts at the last item of
// another one.
Order ends(const PairGraph& graph) {
  Order roots;
  std::vector<bool> seen(static_cast<std::size_t>(graph.items()), false);
  std::vector<bool> scratch(seen);
  Order order;
  for (Element x = 0; x < graph.items(); ++x) {
    if (seen[x]) {
      continue;
    }
    order.clear();
    append_levels(graph, x, seen, order);
    Element root = order.back();
    for (int i = 0; i < 2; ++i) {
      order.clear();
      append_levels(graph, root, scratch, order);
      for (const Element y : order) {
        scratch[y] = false;
      }
      root = order.back();
    }
    roots.push_back(root);
  }
  return roots;
}

Order breadth(const PairGraph& graph, const Order& roots) {
  Order order;
  order.reserve(static_cast<std::size_t>(graph.items()));
  std::vector<bool> seen(static_cast<std::size_t>(graph.items()), false);
  for (const Element root : roots) {
    append_levels(graph, root, seen, order);
  }
  return order;
}

class Frontier {
 public:
  explicit Frontier(const PairGraph& graph)
      : graph_(graph),
        untouched_(static_cast<std::size_t>(graph.items())),
        is_touched_(static_cast<std::size_t>(graph.items()), false),
        touched_(static_cast<std::size_t>(graph.items())) {
    for (Element x = 0; x < graph.items(); ++x) {
      untouched_[x] = static_cast<std::uint32_t>(graph.partners(x).size());
    }
  }

  Order order(const Order& roots) {
    order_.reserve(static_cast<std::size_t>(graph_.items()));
    for (const Element root : roots) {
      touch(root);
      while (const auto x = touched_.take_lowest()) {
        order_.push_back(*x);
        for (const Element y : graph_.partners(*x)) {
          if (!is_touched_[y]) {
            touch(y);
          }
        }
      }
    }
    return std::move(order_);
  }

 private:
  void touch(Element x) {
    is_touched_[x] = true;
    touched_.put(x, untouched_[x]);
    for (const Element y : graph_.partners(x)) {
      --untouched_[y];
      if (touched_.holds(y)) {
        touched_.put(y, untouched_[y]);
      }
    }
  }

  const PairGraph& graph_;
  std::vector<std::uint32_t> untouched_;  // number of untouched partners
  std::vector<bool> is_touched_;
  BucketQueue touched_;  // and not closed
  Order order_;
};

}  // namespace

void each_start(
    const PairGraph& graph, std::uint64_t room,
    const std::function<bool(const std::string& name, std::vector<Element> order)>& visit,
    const std::function<bool()>& give_up) {
  const Order roots = ends(graph);
  const Order frontier = Frontier(graph).order(roots);
  if (!visit("frontier", frontier)) {
    return;
  }
  Order numbered(static_cast<std::size_t>(graph.items()));
  std::iota(numbered.begin(), numbered.end(), 0U);
  if (!visit("numbered", std::move(numbered))) {
    return;
  }
  for (const auto ties : {BucketQueue::Ties::oldest, BucketQueue::Ties::newest}) {
    Order lacking = fewest_missing_order(graph, room, frontier, ties, give_up);
    const char* const name =
        ties == BucketQueue::Ties::oldest ? "lacking, oldest" : "lacking, newest";
    if (lacking.empty() || !visit(name, std::move(lacking))) {
      return;
    }
  }
  visit("breadth", breadth(graph, roots));
}

}  // namespace changeover

#include "loadorder/pairs/starts.hpp"

#include <algorithm>
#include <numeric>

namespace changeover {
namespace {

using Order = std::vector<Element>;

// Appends all items that are reached from `root`, level by level; few partners come first.
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

// One item of each component, at an end of it: the last one of a search from the last one of a search.
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
        state_(static_cast<std::size_t>(graph.items()), State::untouched) {
    for (Element x = 0; x < graph.items(); ++x) {
      untouched_[x] = static_cast<std::uint32_t>(graph.partners(x).size());
    }
  }

  Order order(const Order& roots) {
    for (const Element root : roots) {
      touch(root);
      Element x = 0;
      while (take(x)) {
        state_[x] = State::closed;
        order_.push_back(x);
        for (const Element y : graph_.partners(x)) {
          if (state_[y] == State::untouched) {
            touch(y);
          }
        }
      }
    }
    return std::move(order_);
  }

 private:
  enum class State : std::uint8_t { untouched, touched, closed };

  void touch(Element x) {
    state_[x] = State::touched;
    put(x);
    for (const Element y : graph_.partners(x)) {
      --untouched_[y];
      if (state_[y] == State::touched) {
        put(y);
      }
    }
  }

  // An item may be in several buckets; only the one of its number counts.
  void put(Element x) {
    const std::size_t bucket = untouched_[x];
    if (bucket >= buckets_.size()) {
      buckets_.resize(bucket + 1);
    }
    buckets_[bucket].push_back(x);
    lowest_ = std::min(lowest_, bucket);
  }

  bool take(Element& x) {
    for (; lowest_ < buckets_.size(); ++lowest_) {
      std::vector<Element>& bucket = buckets_[lowest_];
      while (!bucket.empty()) {
        x = bucket.back();
        bucket.pop_back();
        if (state_[x] == State::touched && untouched_[x] == lowest_) {
          return true;
        }
      }
    }
    return false;
  }

  const PairGraph& graph_;
  std::vector<std::uint32_t> untouched_;  // partners
  std::vector<State> state_;
  std::vector<std::vector<Element>> buckets_;
  std::size_t lowest_ = 0;
  Order order_;
};

}  // namespace

std::vector<std::pair<std::string, std::vector<Element>>> start_orders(const PairGraph& graph) {
  std::vector<std::pair<std::string, Order>> starts;
  Order numbered(static_cast<std::size_t>(graph.items()));
  std::iota(numbered.begin(), numbered.end(), 0U);
  starts.emplace_back("numbered", std::move(numbered));
  const Order roots = ends(graph);
  starts.emplace_back("breadth", breadth(graph, roots));
  starts.emplace_back("frontier", Frontier(graph).order(roots));
  return starts;
}

}  // namespace changeover

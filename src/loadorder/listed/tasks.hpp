// Internal: the listed pairs as tasks, each of two parts of the items.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/closing.hpp"

namespace changeover {

struct Task {
  std::size_t a = 0;  // parts, possibly the same
  std::size_t b = 0;
  std::shared_ptr<const std::vector<LoadMove>> order;

  [[nodiscard]] const std::vector<LoadMove>& moves() const { return *order; }
};

struct Tasks {
  std::vector<std::vector<Element>> parts;  // their items
  std::vector<Task> tasks;
};

/// Cuts the items, as an order of one worker loads them first, into parts, and makes an order for
/// each task. Orders are kept for the next cut. The graph must outlive this.
class TaskMaker {
 public:
  TaskMaker(const PairGraph& graph, const std::vector<LoadMove>& order, std::uint64_t room);

  [[nodiscard]] std::size_t items() const { return sequence_.size(); }

  /// Where parts begin that have about as many pairs each, at most `count`.
  [[nodiscard]] std::vector<std::size_t> even_cut(std::uint64_t count) const;

  /// The tasks for parts that begin there; nullopt if there would be more than `most`.
  /// O(pairs) for each start of an order that is not known
  [[nodiscard]] std::optional<Tasks> tasks(const std::vector<std::size_t>& begins,
                                           std::size_t most);

 private:
  // Both parts, as ranges of the sequence, and whether the pairs within each belong to the task.
  using Key = std::tuple<std::size_t, std::size_t, bool, std::size_t, std::size_t, bool>;

  const PairGraph& graph_;
  std::vector<Element> sequence_;
  std::uint64_t room_;
  std::map<Key, std::shared_ptr<const std::vector<LoadMove>>> known_;
  std::uint64_t known_moves_ = 0;
};

}  // namespace changeover

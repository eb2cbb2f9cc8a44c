// Internal: steps of workers in memory, 4 bytes per load and 4 per eviction, at each level.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "changeover/loadorder/workers.hpp"

namespace changeover {

/// The evictions and loads of a step, in memory and, for two levels, on the accelerator.
struct Move {
  std::vector<Element> evict = {};
  std::vector<Element> load = {};
  std::vector<Element> fast_evict = {};
  std::vector<Element> fast_load = {};
  std::uint64_t epoch = 1;
};

/// Items that move together.
using Groups = std::vector<std::vector<Element>>;

/// The items of the groups with these numbers.
[[nodiscard]] std::vector<Element> items_in(const Groups& groups,
                                            const std::vector<Element>& numbers);

/// The same with fewer loads, if there is room: an item that is evicted and loaded again stays as
/// long as its place is not needed; the item that is needed last is evicted first. Steps without
/// loads are removed. With `sizes` room is counted in bytes. O(loads · log room)
[[nodiscard]] std::vector<Move> lazily(const std::vector<Move>& moves, std::uint64_t room,
                                       const ItemSizes* sizes = nullptr);

/// Two levels: `fast` is what the accelerator evicts and loads, and memory is a cache that keeps
/// items in the same way. As many steps as `fast` has.
[[nodiscard]] std::vector<Move> with_a_cache(std::vector<Move> fast, std::uint64_t room,
                                             const ItemSizes* sizes = nullptr);

/// How such an order is made.
inline constexpr std::string_view by_a_cache =
    "An order for the accelerator alone; what leaves it stays in memory, from which goes what is "
    "needed last.";

/// What the steps of one worker move.
[[nodiscard]] std::vector<Move> moves_of(StepSource& steps);

/// Gives each item, a number below items.size(), the name that stands there.
void give_names(std::vector<Move>& moves, const std::vector<Element>& items);

class StepLists final : public WorkerSteps {
 public:
  /// Adds the steps of the next worker; items left at its end are not evicted.
  void add(const std::vector<Move>& moves);

  [[nodiscard]] std::unique_ptr<StepSource> of(std::uint64_t worker) const override;

 private:
  struct Lists;
  std::vector<std::shared_ptr<const Lists>> workers_;
};

/// An order that makes these steps.
[[nodiscard]] LoadOrder::Maker in_memory(const std::vector<Move>& moves);

/// The steps of all workers, one after another, as one order: where the next worker begins, all of
/// memory is evicted, even items that are loaded again.
[[nodiscard]] std::unique_ptr<StepSource> one_after_another(
    std::shared_ptr<const WorkerSteps> steps, std::uint64_t workers);

}  // namespace changeover

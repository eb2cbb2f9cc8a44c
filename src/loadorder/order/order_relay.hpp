// Internal: a place in an order that one reader leaves and the next one takes over. Reading
// stretches one after another then costs one pass over the order, instead of one pass from the
// beginning for each.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

class OrderRelay {
 public:
  /// A place after a number of steps of the order.
  struct Place {
    std::unique_ptr<StepSource> order;
    std::uint64_t step = 0;
    std::vector<std::uint64_t> present;  // items in memory, one bit each
    std::vector<std::uint64_t> fast;     // items on the accelerator

    bool next(Step& next_step);
  };

  /// The stored place, if it is before step `before`; otherwise the beginning.
  [[nodiscard]] Place take(const LoadOrder& order, std::uint64_t before);
  /// Stores a place. Thread-safe.
  void give(Place place);

 private:
  std::mutex mutex_;
  Place left_;
};

/// Steps `first` to `first + count − 1` of an order of groups as steps of items; a place in the
/// order comes from the relay, and goes back to it if all are read.
[[nodiscard]] std::unique_ptr<StepSource> stretch_steps(std::shared_ptr<OrderRelay> relay,
                                                        const LoadOrder& order, std::uint64_t first,
                                                        std::uint64_t count, std::uint64_t items,
                                                        std::uint64_t worker);

}  // namespace changeover

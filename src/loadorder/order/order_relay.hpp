// Internal: a place in an order that one reader leaves and the next one takes, so that stretches
// that are read one after another cost one reading of the order, and not one each of all that comes
// before.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

class OrderRelay {
 public:
  /// Behind so many steps of the order.
  struct Place {
    std::unique_ptr<StepSource> order;
    std::uint64_t step = 0;
    std::vector<std::uint64_t> present;  // what is in memory, a bit each
    std::vector<std::uint64_t> fast;     // what is on the accelerator

    bool next(Step& next_step);
  };

  /// The place that was left, if it is before step `before`; otherwise the beginning.
  [[nodiscard]] Place take(const LoadOrder& order, std::uint64_t before);
  /// For any thread.
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

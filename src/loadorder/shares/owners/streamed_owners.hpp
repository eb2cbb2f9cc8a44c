// Internal: who computes what where stretches are those of a streamed order: said by its shape.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/order/streamed_order.hpp"

namespace changeover {

/// A pair is of the worker in whose stretch its items come together first.
class StreamedOwners final : public PairOwners {
 public:
  StreamedOwners(const LoadOrder& order, std::vector<WorkerFacts> workers);

  /// By worker. O(workers · rounds)
  [[nodiscard]] std::vector<std::uint64_t> pairs() const;

  [[nodiscard]] std::unique_ptr<const PairRule> of(std::uint64_t worker) const override;

 private:
  StreamedPairs pairs_;
  LoadOrder order_;
  std::vector<WorkerFacts> workers_;
};

}  // namespace changeover

// Internal: steps of workers that are kept in memory, 4 bytes a load and 4 an eviction.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"

namespace changeover {

/// What a step evicts and loads.
struct Move {
  std::vector<Element> evict;
  std::vector<Element> load;
};

/// The same with fewer loads, if there is room for it: what is evicted and loaded again stays as
/// long as its place is not needed, and what is needed last goes first. Steps that load nothing any
/// more are left out. O(loads · log room)
[[nodiscard]] std::vector<Move> lazily(std::vector<Move> moves, std::uint64_t room);

class StepLists final : public WorkerSteps {
 public:
  /// The steps of the next worker; what is still there at its end is not evicted.
  void add(const std::vector<Move>& moves);

  [[nodiscard]] std::unique_ptr<StepSource> of(std::uint64_t worker) const override;

 private:
  struct Lists;
  std::vector<std::shared_ptr<const Lists>> workers_;
};

/// The steps of all workers, one worker after another, as one order: where the next one begins all
/// that is in memory is evicted, even what it loads again.
[[nodiscard]] std::unique_ptr<StepSource> one_after_another(
    std::shared_ptr<const WorkerSteps> steps, std::uint64_t workers);

}  // namespace changeover

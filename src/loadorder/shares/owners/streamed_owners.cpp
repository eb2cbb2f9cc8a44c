#include "loadorder/shares/owners/streamed_owners.hpp"

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

/// What a stretch of a streamed order computes.
class StreamedRule final : public PairRule {
 public:
  StreamedRule(const StreamedPairs& pairs, const WorkerFacts& facts, std::vector<Element> arrived)
      : pairs_(pairs), first_(facts.first_step), arrived_(std::move(arrived)) {}

  [[nodiscard]] bool computes(std::uint64_t step, Element x, Element y) const override {
    const std::uint64_t in_order = first_ + step - 1;
    if (x == y) {
      return pairs_.first_load(x) == in_order;
    }
    // What was there before the first step has met before it.
    const auto arrived = [&](Element z) {
      return std::ranges::find(arrived_, z) != arrived_.end();
    };
    return (step > 1 || first_ == 1 || arrived(x) || arrived(y)) &&
           pairs_.meet_first(in_order, x, y);
  }

 private:
  const StreamedPairs& pairs_;
  std::uint64_t first_;
  std::vector<Element> arrived_;  // by the first step
};

}  // namespace

StreamedOwners::StreamedOwners(const LoadOrder& order, std::vector<WorkerFacts> workers)
    : pairs_(best_streamed_shape(order.facts().items, order.facts().room)),
      order_(order.facts(), order.maker()),
      workers_(std::move(workers)) {}

std::vector<std::uint64_t> StreamedOwners::pairs() const {
  std::vector<std::uint64_t> pairs;
  pairs.reserve(workers_.size());
  for (const WorkerFacts& worker : workers_) {
    pairs.push_back(worker.steps == 0 ? 0
                                      : pairs_.met_after(worker.first_step + worker.steps - 1) -
                                            pairs_.met_after(worker.first_step - 1));
  }
  return pairs;
}

std::unique_ptr<const PairRule> StreamedOwners::of(std::uint64_t worker) const {
  const WorkerFacts& facts = workers_[static_cast<std::size_t>(worker)];
  Step step;
  if (facts.first_step > 1) {
    const auto steps = order_.stream();
    std::vector<Element> held;
    if (!steps->jump(facts.first_step, held) || !steps->next(step)) {
      throw InternalError("a streamed load order has no step where a worker begins");
    }
  }
  return std::make_unique<StreamedRule>(pairs_, facts, std::move(step.load));
}

}  // namespace changeover

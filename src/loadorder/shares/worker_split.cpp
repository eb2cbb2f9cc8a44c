#include <fmt/format.h>

#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/order/order_relay.hpp"

namespace changeover {
namespace {

class OneAfterAnother final : public StepSource {
 public:
  explicit OneAfterAnother(const WorkerSplit& split) : split_(split) {}

  bool next(Step& step) override {
    while (!steps_ || !steps_->next(step)) {
      steps_.reset();  // leaves its place in the order to the next one
      if (worker_ == split_.facts().workers.size()) {
        return false;
      }
      steps_ = split_.stream(worker_++);
    }
    return true;
  }

 private:
  const WorkerSplit& split_;
  std::unique_ptr<StepSource> steps_;
  std::uint64_t worker_ = 0;
};

}  // namespace

WorkerSplit::WorkerSplit(SplitFacts facts, LoadOrder order)
    : facts_(std::move(facts)), order_(std::move(order)), relay_(std::make_shared<OrderRelay>()) {
  facts_.explanation = order_.facts().explanation;
}

std::unique_ptr<StepSource> WorkerSplit::stream(std::uint64_t worker) const {
  if (worker >= facts_.workers.size()) {
    throw BadInput(fmt::format("there is no worker {}: the order is for {}; count from 0", worker,
                               facts_.workers.size()));
  }
  if (steps_) {
    return steps_->of(worker);
  }
  const WorkerFacts& facts = facts_.workers[static_cast<std::size_t>(worker)];
  return stretch_steps(relay_, order_, facts.first_step, facts.steps, facts_.items, worker);
}

std::unique_ptr<StepSource> WorkerSplit::stream() const {
  return std::make_unique<OneAfterAnother>(*this);
}

ScheduleRules WorkerSplit::rules(const std::optional<ComputeRules>& compute) const {
  const LoadOrderFacts& whole = order_.facts();
  return {.items = facts_.items,
          .room = facts_.room,
          .fast_room = whole.fast_room,
          .wanted = whole.wanted,
          .compute = compute,
          .sizes = whole.sizes,
          .epochs = facts_.epochs,
          .shares = true};
}

}  // namespace changeover

#include "changeover/loadorder/load_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "loadorder/order/of_worker.hpp"
#include "loadorder/order/order_relay.hpp"

namespace changeover {
namespace {

/// Steps under the numbers that they have in the order.
class Renumbered final : public StepSource {
 public:
  Renumbered(std::unique_ptr<StepSource> steps, std::uint64_t before)
      : steps_(std::move(steps)), before_(before) {}

  bool next(Step& step) override {
    if (!steps_->next(step)) {
      return false;
    }
    step.number += before_;
    return true;
  }

 private:
  std::unique_ptr<StepSource> steps_;
  std::uint64_t before_;
};

}  // namespace

double LoadOrderFacts::gap() const {
  if (sizes) {
    return static_cast<double>(bytes) / static_cast<double>(byte_bound.loads) - 1;
  }
  return static_cast<double>(loads) / static_cast<double>(bound.loads) - 1;
}

LoadOrder::LoadOrder(LoadOrderFacts facts, Maker maker)
    : facts_(std::move(facts)), maker_(std::move(maker)) {}

std::unique_ptr<StepSource> LoadOrder::stream(std::uint64_t worker) const {
  const std::uint64_t workers = std::max<std::uint64_t>(1, facts_.lockstep);
  if (worker >= workers) {
    throw BadInput(
        fmt::format("there is no worker {}: the order is for {}; count from 0", worker, workers));
  }
  return std::make_unique<OfWorker>(stream(), worker);
}

std::unique_ptr<StepSource> LoadOrder::stream_from(std::uint64_t step) const {
  if (step == 0 || step > facts_.steps || facts_.lockstep > 0) {
    throw BadInput(
        facts_.lockstep > 0
            ? std::string("an order for workers in lockstep can only be read from its first step")
            : fmt::format("there is no step {}: the order has {}; count from 1", step,
                          facts_.steps));
  }
  return std::make_unique<Renumbered>(stretch_steps(std::make_shared<OrderRelay>(), *this, step,
                                                    facts_.steps - step + 1, facts_.items, 0),
                                      step - 1);
}

}  // namespace changeover

// Repeats shares, alternating between forward and backward epochs.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/shares/owners/pair_table.hpp"
#include "loadorder/shares/split_maker.hpp"
#include "loadorder/training/epochs.hpp"

namespace changeover {
namespace {

class RepeatedSteps final : public WorkerSteps {
 public:
  RepeatedSteps(WorkerSplit once, std::uint64_t epochs)
      : once_(std::make_shared<const WorkerSplit>(std::move(once))), epochs_(epochs) {}

  [[nodiscard]] std::unique_ptr<StepSource> of(std::uint64_t worker) const override {
    return back_and_forth([once = once_, worker] { return once->stream(worker); }, epochs_, 0);
  }

 private:
  std::shared_ptr<const WorkerSplit> once_;
  std::uint64_t epochs_;
};

}  // namespace

void SplitMaker::repeat(WorkerSplit& split, std::uint64_t epochs) {
  constexpr std::uint64_t most_bits = std::uint64_t{1} << 34;  // 2 GB, for pairs in all epochs
  constexpr std::uint64_t most_pairs = 30'000'000;
  const std::uint64_t workers = split.facts_.workers.size();
  for (const WorkerFacts& worker : split.facts_.workers) {
    const std::uint64_t stays = std::min(worker.loads, split.facts_.room);
    check_moves_kept(checked_add(worker.loads, worker.loads - stays), worker.steps);
  }
  // Owners may assign a pair by the step in which it meets; a table assigns it by the pair.
  const bool by_table = are_few(split);
  if (workers > 1 && by_table && split.owners_ != nullptr &&
      !are_given_one_by_one(*split.owners_)) {
    spread(split);
  }
  WorkerSplit once_only(split.facts_, LoadOrder(split.order_.facts(), split.order_.maker()));
  once_only.steps_ = std::move(split.steps_);
  split.steps_ = std::make_shared<const RepeatedSteps>(std::move(once_only), epochs);
  if (!by_table) {
    split.owners_ = nullptr;
  }
  SplitFacts& facts = split.facts_;
  const LoadOrderFacts& whole = split.order_.facts();
  const std::uint64_t pairs = facts.all_pairs;
  const LoadBound once = load_lower_bound(whole.wanted.among(facts.items), facts.room);
  facts.epochs = epochs;
  facts.makespan_bound = epochs_makespan_bound(
      facts.makespan_bound, epochs_lower_bound(once, pairs, facts.room, workers, epochs), workers);
  facts.all_pairs = checked_multiply(pairs, epochs);
  for (WorkerFacts& worker : facts.workers) {
    worker.steps = checked_multiply(worker.steps, epochs);
    worker.pairs = checked_multiply(worker.pairs, epochs);
    worker.cost *= static_cast<double>(epochs);
  }
  facts.most_pairs = checked_multiply(facts.most_pairs, epochs);
  facts.most_cost *= static_cast<double>(epochs);
  facts.all_costs *= static_cast<double>(epochs);

  ScheduleVerdict verdict;
  const bool read = whole.every_step_read && checked_multiply(pairs, epochs) <= most_bits &&
                    checked_multiply(facts.loads, epochs) <= most_loads_read;
  if (read) {
    ScheduleRules rules = split.rules();
    std::unique_ptr<StepSource> steps = split.stream();
    if (checked_multiply(pairs, epochs) <= most_pairs &&
        (split.owners_ != nullptr || workers == 1)) {
      rules.compute = ComputeRules{};
      steps = std::make_unique<StepWork>(std::move(steps), rules, split.owners_);
    }
    verdict = check_schedule(*steps, rules);
    if (!verdict.valid()) {
      throw InternalError(fmt::format("the shares of {} epochs are wrong: {}{}", epochs,
                                      verdict.fault, verdict.example));
    }
  } else {
    const auto steps = split.stream();
    static_cast<ScheduleFacts&>(verdict) = count_moves(*steps, 1, whole.sizes.get());
  }
  verdict.worker_loads.resize(facts.workers.size(), 0);
  verdict.worker_bytes.resize(facts.workers.size(), 0);
  facts.loads = verdict.loads;
  facts.transfers = verdict.transfers;
  facts.makespan = verdict.makespan();
  facts.bytes = verdict.bytes;
  facts.makespan_bytes = *std::ranges::max_element(verdict.worker_bytes);
  facts.epoch_loads = verdict.epoch_loads;
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    facts.workers[w].loads = verdict.worker_loads[w];
    facts.workers[w].bytes = verdict.worker_bytes[w];
  }
  LoadOrderFacts its = whole;
  if (whole.fast_room) {
    its.transfer_bound =
        epochs_lower_bound(whole.transfer_bound, pairs, *whole.fast_room, workers, epochs);
  }
  if (whole.sizes) {
    its.bytes = verdict.bytes;
    its.byte_bound = epochs_byte_bound(whole.byte_bound, whole.sizes->memory, workers, epochs);
    facts.makespan_bytes_bound =
        epochs_makespan_bound(facts.makespan_bytes_bound, its.byte_bound, workers, "bytes");
    its.most_bytes = std::max(its.most_bytes, verdict.most_bytes);
    its.transfer_bytes = verdict.transfer_bytes;
    if (whole.fast_room) {
      its.transfer_byte_bound =
          epochs_byte_bound(whole.transfer_byte_bound, whole.sizes->fast_memory, workers, epochs);
    }
  }
  its.every_step_read = read;
  its.certificate = facts.certificate = read ? in_each_epoch(whole.certificate, epochs)
                                             : whole.certificate + ", and read back and forth";
  split.order_ = LoadOrder(std::move(its), split.order_.maker());
}

WorkerSplit repeat_shares(WorkerSplit split, std::uint64_t epochs) {
  check_epochs(epochs);
  if (epochs == 1) {
    return split;
  }
  if (split.facts().epochs != 1) {
    throw BadInput("shares of several epochs are not repeated; give those of one epoch");
  }
  SplitMaker::repeat(split, epochs);
  return split;
}

}  // namespace changeover

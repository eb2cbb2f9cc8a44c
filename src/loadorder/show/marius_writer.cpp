#include "loadorder/show/marius_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"

namespace changeover {

void MariusWriter::write(const Step& step) {
  if (step.epoch != epoch_) {
    end();
    epoch_ = step.epoch;
  }
  // Loaded items take the places of the evicted ones, as in the buffer.
  if (!memory_.empty() && step.load.size() != step.evict.size()) {
    throw BadInput(fmt::format(
        "step {} evicts {} and loads {}: Marius exchanges as many partitions as it evicts; "
        "list more pairs or all, or give items of one size",
        step.number, step.evict.size(), step.load.size()));
  }
  for (std::size_t i = 0; i < step.evict.size(); ++i) {
    *std::ranges::find(memory_, step.evict[i]) = step.load[i];
  }
  if (memory_.empty()) {
    memory_ = step.load;
    if (memory_.size() != std::min(room_, items_)) {
      throw BadInput(fmt::format(
          "step {} fills {} of {} places: Marius' buffer is always full; list more pairs or all, "
          "or give items of one size",
          step.number, memory_.size(), std::min(room_, items_)));
    }
  }
  states_ += states_.empty() ? "[" : ",[";
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    states_ += i == 0 ? "" : ",";
    states_ += fmt::format_int(memory_[i]).c_str();
  }
  states_ += ']';
  buckets_ += buckets_.empty() ? "[" : ",[";
  for (std::size_t i = 0; i < step.compute.size(); ++i) {
    buckets_ += i == 0 ? "[" : ",[";
    buckets_ += fmt::format_int(step.compute[i].first).c_str();
    buckets_ += ',';
    buckets_ += fmt::format_int(step.compute[i].second).c_str();
    buckets_ += ']';
  }
  buckets_ += ']';
}

void MariusWriter::end() {
  if (epoch_ > 0) {
    out_.write(
        fmt::format(R"({{"epoch":{},"num_partitions":{},"buffer_capacity":{},"buffer_states":[{}],)"
                    R"("edge_buckets_per_buffer":[{}]}})"
                    "\n",
                    epoch_, items_, std::min(room_, items_), states_, buckets_));
  }
  states_.clear();
  buckets_.clear();
}

void write_steps_for_marius(const LoadOrderFacts& facts, StepSource& steps, Sink& out) {
  for (Element x = 0; x < facts.items; ++x) {
    if (!facts.wanted.are_all() && !facts.wanted.needs(x)) {
      throw BadInput(fmt::format(
          "partition {} is in no pair, and Marius needs all of them; list it with itself", x));
    }
  }
  MariusWriter writer(out, facts.items, facts.room);
  for (Step step; steps.next(step);) {
    writer.write(step);
  }
  writer.end();
}

}  // namespace changeover

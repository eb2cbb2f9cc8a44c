// Internal: describes the pairs that the workers of a schedule compute, their costs, and how even
// both are.
#pragma once

#include <cstdint>
#include <string>

#include "changeover/loadorder/workers.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {

class WorkerWords {
 public:
  /// For workers in lockstep, or for those of a split. Both must outlive this object.
  WorkerWords(const LoadOrderFacts& facts, const SplitFacts* split);

  /// Writes keys of the head: the most pairs of one worker, the mean, and the lower bound.
  void say(JsonWriter& json) const;
  /// Writes the same for each worker.
  void say_each(JsonWriter& json) const;
  /// Lines of text; empty if the numbers are unknown.
  [[nodiscard]] std::string text() const;

 private:
  const LoadOrderFacts& facts_;
  const SplitFacts* split_;
  std::uint64_t workers_ = 0;
  std::uint64_t all_ = 0;  // pairs; 0 if unknown
  std::uint64_t most_ = 0;
};

}  // namespace changeover

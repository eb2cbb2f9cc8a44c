// Internal: how many pairs the workers of a schedule compute, what they cost, and how even that is.
#pragma once

#include <cstdint>
#include <string>

#include "changeover/loadorder/workers.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {

class WorkerWords {
 public:
  /// Of workers in lockstep, or of those of a split. Both must outlive this.
  WorkerWords(const LoadOrderFacts& facts, const SplitFacts* split);

  /// Keys of the head: the most of one worker, the mean, and the fewest there can be.
  void say(JsonWriter& json) const;
  /// The same of each worker.
  void say_each(JsonWriter& json) const;
  /// Lines, or nothing if it is not known.
  [[nodiscard]] std::string text() const;

 private:
  const LoadOrderFacts& facts_;
  const SplitFacts* split_;
  std::uint64_t workers_ = 0;
  std::uint64_t all_ = 0;  // pairs; 0 if it is not known
  std::uint64_t most_ = 0;
};

}  // namespace changeover

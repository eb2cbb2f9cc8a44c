// Internal: describes what the workers of a schedule load and compute, what pairs cost, and how
// even that is.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "changeover/loadorder/workers.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {

/// How far a count is over its bound.
[[nodiscard]] std::string over(std::uint64_t count, const LoadBound& bound);

/// The loads of each of several epochs, as a line; empty for one.
[[nodiscard]] std::string epochs_in_words(const LoadOrderFacts& facts);

/// Writes a key with the most of something and the mean.
template <typename Number>
void say_most(JsonWriter& json, std::string_view key, Number most, double mean) {
  json.key(key).begin_object().key("max").value(most).key("mean").value(mean).end_object();
}

/// Writes the key "time_is_up", and returns the line that says the same.
[[nodiscard]] std::string say_that_time_is_up(JsonWriter& json);

class WorkerWords {
 public:
  /// For workers in lockstep, or for those of a split. Both must outlive this object.
  WorkerWords(const LoadOrderFacts& facts, const SplitFacts* split);

  /// Writes keys of the head: the most pairs of one worker, the mean, and the lower bound.
  void say(JsonWriter& json) const;
  /// If items have sizes: the bytes that the busiest worker loads, and the bound; for workers in
  /// lockstep the span, too.
  void say_bytes(JsonWriter& json) const;
  /// Writes the same for each worker.
  void say_each(JsonWriter& json) const;
  /// Lines of text; empty if the numbers are unknown.
  [[nodiscard]] std::string text() const;
  /// "49 loads for 4 workers, the busiest has 13, …", and text(); empty unless shares are.
  [[nodiscard]] std::string busiest() const;
  /// The first lines on workers in lockstep: `what` meets in so many steps and epochs.
  [[nodiscard]] std::string in_lockstep(const std::string& what, const std::string& epochs,
                                        std::uint64_t steps, const LoadBound& bound) const;

 private:
  const LoadOrderFacts& facts_;
  const SplitFacts* split_;
  std::uint64_t workers_ = 0;
  std::uint64_t all_ = 0;  // pairs; 0 if unknown
  std::uint64_t most_ = 0;
};

}  // namespace changeover

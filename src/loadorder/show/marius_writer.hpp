// Internal: writes an order in the form of Marius: the content of its buffer, state by state, and
// the edge buckets that are trained on in each.
//
//     MariusWriter writer(out, 64, 16);
//     writer.write(step);                   // with its pairs both ways, and each item with itself
//     writer.end();
//
// A line for each epoch, with the lists that Marius' PartitionBufferStorage.setBufferOrdering()
// (buffer_states) and DataLoader.edge_buckets_per_buffer take as tensors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/io/output.hpp"
#include "changeover/loadorder/load_order.hpp"

namespace changeover {

class MariusWriter {
 public:
  MariusWriter(Sink& out, std::uint64_t items, std::uint64_t room)
      : out_(out), items_(items), room_(room) {}

  /// @throws BadInput if the step loads more or less than it evicts while memory is full
  void write(const Step& step);

  void end();

 private:
  Sink& out_;
  std::uint64_t items_;
  std::uint64_t room_;
  std::uint64_t epoch_ = 0;
  std::vector<Element> memory_;
  std::string states_;
  std::string buckets_;
};

/// Writes all steps. @throws BadInput as write(), and if an item is in no pair
void write_steps_for_marius(const LoadOrderFacts& facts, StepSource& steps, Sink& out);

}  // namespace changeover

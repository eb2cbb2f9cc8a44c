// Reads the benches of a request, without parts that broke.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/request/parts_left.hpp"

namespace changeover {

/// Options for a list that may be older than the parts list.
struct OldListOptions {
  const std::vector<std::string>* names = nullptr;  ///< of all parts of the list
  const Job* all_values = nullptr;                  ///< of a model: its job with all values
  const PartsLeft* left = nullptr;
  std::vector<std::string>* gone = nullptr;   ///< receives unknown names, which are left out
  std::vector<std::string>* notes = nullptr;  ///< receives what else people should know
};

/// The benches of a list, with the current numbers of parts. @throws as read_benches()
[[nodiscard]] std::vector<Bench> listed_benches(Input& input, const OldListOptions& options);

/// The most parts that fit on one of the benches; without benches, the value of the job.
[[nodiscard]] std::uint64_t most_at_once(const Job& job, const std::vector<Bench>& benches);

/// @throws BadInput with the first of bench_defects(), with `file` as its place unless empty.
void check_benches(const Job& job, const std::vector<Bench>& benches, const std::string& file);

/// Removes triples that no bench can hold, and returns their number. Does nothing without benches.
[[nodiscard]] std::uint64_t drop_impossible_triples(Job& job, const std::vector<Bench>& benches);

/// A part may be in the last test of more benches than there are pieces of it: removes it from all
/// of them, with a note.
void drop_overdrawn(const Job& job, std::vector<Bench>& benches, std::vector<std::string>& notes);

}  // namespace changeover

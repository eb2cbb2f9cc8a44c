// The benches of a request: read, without the parts that broke, and where their tests were done.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/request/parts_left.hpp"

namespace changeover {

/// How a list is read that may be older than the parts list.
struct OldListOptions {
  const std::vector<std::string>* names = nullptr;  ///< of all parts of the list
  const PartsLeft* left = nullptr;
  std::vector<std::string>* gone = nullptr;  ///< gets names that are no parts and were left out
};

/// The benches of a list, with parts as they are numbered now. @throws as read_benches()
[[nodiscard]] std::vector<Bench> listed_benches(Input& input, const OldListOptions& options);

/// The most parts that fit on one of the benches, or what the job says without any.
[[nodiscard]] std::uint64_t most_at_once(const Job& job, const std::vector<Bench>& benches);

/// @throws BadInput with the first of bench_defects(), and `file` as its place if that is not
/// empty.
void check_benches(const Job& job, const std::vector<Bench>& benches, const std::string& file);

/// Reads the set-ups that come first: those without a bench come first on every bench, those with
/// one only there, after the others. @throws as read_first()
void take_first(Input& input, const OldListOptions& options, Job& job, std::vector<Bench>& benches);

/// Triples that no bench can hold need not meet; returns how many. Nothing without benches.
[[nodiscard]] std::uint64_t drop_impossible_triples(Job& job, const std::vector<Bench>& benches);

/// Of the parts that stand on more benches than there are of them, since each was in the last test
/// there: takes them off all these, with a note.
void drop_overdrawn(const Job& job, std::vector<Bench>& benches, std::vector<std::string>& notes);

}  // namespace changeover

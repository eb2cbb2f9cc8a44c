// Writes the lists of a request as rows, so that it needs no files.
#pragma once

#include <vector>

#include "changeover/plan/job_request.hpp"

namespace changeover {

/// The parts of a list with their costs in the job, whose first parts are those of the list.
[[nodiscard]] RequestList part_rows(const PartList& list, const Job& job);
[[nodiscard]] RequestList slot_rows(const std::vector<Slot>& slots);
/// Pairs by name, with reasons if there are any.
[[nodiscard]] RequestList pair_rows(const PairSet& pairs, const Job& job,
                                    const PairReasons& why = {});
[[nodiscard]] RequestList weight_rows(const Job& job);
/// The set-ups that come first: on all benches, and then those that do so on some.
[[nodiscard]] RequestList setup_rows(const std::vector<Block>& setups, const Job& job,
                                     const std::vector<Bench>& benches);
[[nodiscard]] RequestList bench_rows(const std::vector<Bench>& benches, const Job& job);
/// The square table of what changes cost by what is replaced, of the parts that are no further
/// pieces of others.
[[nodiscard]] RequestList change_cost_rows(const Job& job);
/// The costs of setting values of a model, including those that depend on what is replaced.
[[nodiscard]] RequestList value_cost_rows(const Job& job);

/// The first names of a list from an index on, for a note: "DIMM #2, DIMM #3, CPU #2, …".
[[nodiscard]] std::string first_names(const std::vector<std::string>& names, std::size_t from);

/// A note on pairs (at least one) that need not meet: "2 pairs cannot meet by the rules and need
/// not: A and B; C and D". Of many it names the first and says how many more there are.
[[nodiscard]] std::string apart_note(const PairSet& apart, const Job& job, std::string_view where);

}  // namespace changeover

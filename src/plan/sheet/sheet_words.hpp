// What all formats of a run sheet say in the same words.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "changeover/plan/run_plan.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"

namespace changeover {

/// Costs with the decimals that the costs of a job need.
class Money {
 public:
  Money(const Job& job, std::optional<Amount> budget = {});
  [[nodiscard]] std::string operator()(Amount amount) const { return to_string(amount, decimals_); }
  [[nodiscard]] unsigned decimals() const { return decimals_; }
  /// With the decimals that this needs, too.
  void widen(Amount amount) { decimals_ = std::max(decimals_, decimals_needed(amount)); }

 private:
  unsigned decimals_ = 0;
};

/// So many slots that a page on its side has room for their columns.
[[nodiscard]] inline bool has_many_slots(const Job& job) {
  constexpr std::size_t few = 3;
  return job.slots.size() > few;
}

/// How many parts there are, further pieces not counted.
[[nodiscard]] std::uint64_t parts_listed(const Job& job);

/// "cost 117", or of times "cost 95 minutes, 1:35 on the clock".
[[nodiscard]] std::string cost_words(const Job& job, const Money& money, Amount cost);

/// The names of some parts.
[[nodiscard]] std::vector<std::string> names_of(const Job& job, const Block& parts);

/// What a step puts in, each "A for B" where it matters what it replaces.
[[nodiscard]] std::vector<std::string> put_in_words(const Job& job, const RunStep& step);

/// "17 tests, 20 changes, cost 117", and what is to be said of the budget and the bound, a line
/// each.
[[nodiscard]] std::vector<std::string> summary(const SheetDocument& document);

/// What is to be said beside the ranges of ratios, a line each.
[[nodiscard]] std::vector<std::string> what_if_notes(const Job& job, const WhatIf& answer);

/// What met only in tests that did not pass, in a line.
[[nodiscard]] std::string failed_line(const Job& job);

/// How far a is above b: "0.9 %".
[[nodiscard]] std::string per_cent_above(Amount a, Amount b);

/// "pairs", or "triples" where these have to meet.
[[nodiscard]] std::string what_meets(const Job& job);

/// How many of them a candidate tests.
[[nodiscard]] std::uint64_t tested_by(const Job& job, const Candidate& candidate);

/// How many of them a step tests first.
[[nodiscard]] std::uint64_t new_here(const Job& job, const RunStep& step);

/// How much more a candidate costs than the first: "+1 (0.9 %)"; empty for the first and under a
/// budget.
[[nodiscard]] std::string difference(const SheetDocument& document, const Candidate& candidate);

}  // namespace changeover

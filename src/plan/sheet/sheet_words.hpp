// Texts shared by all formats of a run sheet.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "changeover/plan/run_plan.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"

namespace changeover {

/// Writes costs with as many decimals as the costs of a job need.
class Money {
 public:
  Money(const Job& job, std::optional<Amount> budget = {});
  [[nodiscard]] std::string operator()(Amount amount) const { return to_string(amount, decimals_); }
  [[nodiscard]] unsigned decimals() const { return decimals_; }
  /// Uses the decimals that this amount needs, too.
  void widen(Amount amount) { decimals_ = std::max(decimals_, decimals_needed(amount)); }

 private:
  unsigned decimals_ = 0;
};

/// Whether there are so many slots that their columns need a landscape page.
[[nodiscard]] inline bool has_many_slots(const Job& job) {
  constexpr std::size_t few = 3;
  return job.slots.size() > few;
}

/// The number of parts, without further pieces.
[[nodiscard]] std::uint64_t parts_listed(const Job& job);

/// "9 parts, 3 at a time", or the parameters and values of a model.
[[nodiscard]] std::string what_there_is(const Job& job);

/// That the tests follow the rules of the model, if it has any.
[[nodiscard]] std::optional<std::string> rules_line(const Job& job);

/// "1 hour", "2.5 hours" of the unit "hours".
[[nodiscard]] std::string with_unit(const Money& money, Amount amount, std::string_view unit);

/// "cost 117", or for times "cost 95 minutes, 1:35 on the clock".
[[nodiscard]] std::string cost_words(const Job& job, const Money& money, Amount cost);

/// The names of some parts.
[[nodiscard]] std::vector<std::string> names_of(const Job& job, const Block& parts);

/// The parts that a step puts in, each as "A for B" if costs depend on what is replaced.
[[nodiscard]] std::vector<std::string> put_in_words(const Job& job, const RunStep& step);

/// "17 tests, 20 changes, cost 117", and facts on the budget and the bound, one per line.
[[nodiscard]] std::vector<std::string> summary(const SheetDocument& document);

/// How far the number of tests is above its lower bound. `of_all`: the tests of the plan that was
/// found for all pairs, if the budget does not suffice for them.
[[nodiscard]] std::string fewest_tests_line(std::uint64_t tests,
                                            std::optional<std::uint64_t> of_all,
                                            std::uint64_t bound, const std::string& all);

/// Notes on the ranges of ratios, one per line.
[[nodiscard]] std::vector<std::string> what_if_notes(const Job& job, const WhatIf& answer);

/// A line on what met only in tests that did not pass.
[[nodiscard]] std::string failed_line(const Job& job);

/// "weight of the pairs tested: 3 of 5", and how much more a plan within the budget can test, if
/// `most` says it.
[[nodiscard]] std::string weight_words(Amount tested, Amount needed, std::optional<Amount> most);

/// The excess of a over b: "0.9 %".
[[nodiscard]] std::string per_cent_above(Amount a, Amount b);

/// Whether triples have to meet, or had to.
[[nodiscard]] inline bool is_of_triples(const Job& job) {
  return job.asks_for_triples || !job.triples.empty();
}

/// "pairs", or "triples" if these have to meet.
[[nodiscard]] std::string what_meets(const Job& job);

/// The number of them that a candidate or a sheet tests.
template <typename Tests>
[[nodiscard]] std::uint64_t tested_by(const Job& job, const Tests& what) {
  return is_of_triples(job) ? what.triples_tested : what.pairs_tested;
}

/// "5 of 6 needed pairs tested, checked by an independent count", of a sheet or of all benches.
template <typename Count>
[[nodiscard]] std::string tested_line(const Job& job, const Count& count, std::string_view where) {
  return fmt::format("{} of {} tested{}, checked by an independent count", tested_by(job, count),
                     is_of_triples(job) ? count_of(count.triples_needed, "needed triple")
                                        : count_of(count.pairs_needed, "needed pair"),
                     where);
}

/// "budget 20: testing all pairs would cost 31".
[[nodiscard]] std::string budget_line(const Job& job, const Money& money,
                                      std::optional<Amount> budget, Amount cost);

/// The number of them that a step tests first.
[[nodiscard]] std::uint64_t new_here(const Job& job, const RunStep& step);

/// How much more a candidate costs than the first: "+1 (0.9 %)"; empty for the first and under a
/// budget.
[[nodiscard]] std::string difference(const SheetDocument& document, const Candidate& candidate);

}  // namespace changeover

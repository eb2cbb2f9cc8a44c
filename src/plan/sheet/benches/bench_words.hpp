// Texts shared by all formats of the sheets of several benches.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

/// The calendar of a document. @throws BadInput for an invalid first day.
[[nodiscard]] BenchCalendar calendar_of(const BenchDocument& document);

/// Costs and times with as many decimals as those of the job and its benches need.
[[nodiscard]] Money money_of(const BenchDocument& document);

/// Whether some step begins later than the one before it ends: then times are more than sums of
/// costs.
[[nodiscard]] bool some_bench_waits(const BenchPlan& plan);

/// The number of earlier tests on all benches, including tests on unknown ones.
[[nodiscard]] std::uint64_t tests_done_of(const BenchDocument& document);

/// The summary of a plan, one line per fact.
[[nodiscard]] std::vector<std::string> bench_summary(const BenchDocument& document);

/// The names of the sheets of a workbook, one for each bench: unique, and as spreadsheets allow.
[[nodiscard]] std::vector<std::string> bench_sheet_names(const std::vector<Bench>& benches);

/// The properties of a bench: "8 hours a day", "mounted at the start: A, B"; empty if it has no
/// separate properties.
[[nodiscard]] std::vector<std::string> bench_facts(const BenchDocument& document,
                                                   std::size_t bench);

}  // namespace changeover

// What all formats of the sheets of several benches say in the same words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

/// The days of a document. @throws BadInput for a first day that is none.
[[nodiscard]] BenchCalendar calendar_of(const BenchDocument& document);

/// Costs and times with the decimals that those of a job and its benches need.
[[nodiscard]] Money money_of(const BenchDocument& document);

/// Whether some step begins later than the one before it ends: then times are more than sums of
/// costs.
[[nodiscard]] bool some_bench_waits(const BenchPlan& plan);

/// On all benches, and on none that is known.
[[nodiscard]] std::uint64_t tests_done_of(const BenchDocument& document);

/// What is to be said of a plan, a line each.
[[nodiscard]] std::vector<std::string> bench_summary(const BenchDocument& document);

/// What distinguishes a bench: "8 hours a day", "mounted at the start: A, B"; empty if nothing
/// does.
[[nodiscard]] std::vector<std::string> bench_facts(const BenchDocument& document,
                                                   std::size_t bench);

}  // namespace changeover

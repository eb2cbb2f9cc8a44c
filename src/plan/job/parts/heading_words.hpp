// Recognises the columns of lists by the words in their headings, in the languages of docs/plan.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// The words of a heading in lower case: separated by blanks and signs, or by a capital in the
/// middle as in "changeCost".
[[nodiscard]] std::vector<std::string> heading_words(std::string_view text);

/// Whether a text is the heading of a column of parts: "Part", "component 2", "sample".
[[nodiscard]] bool heads_parts(std::string_view text);
/// Or one that may contain names: "Part name", "Model", "Description".
[[nodiscard]] bool heads_names(std::string_view text);
/// Or one of row numbers: "#", "No.", "ID".
[[nodiscard]] bool heads_row_numbers(std::string_view text);

/// A column of costs in money: "Change cost", "Preis".
[[nodiscard]] bool heads_costs(std::string_view text);
/// A column of costs in time or work: "Swap time (min)", "Hours", "Duration", "Effort".
[[nodiscard]] bool heads_times(std::string_view text);
/// A heading for costs of changes, preferred to others: "Change cost", "Swap time".
[[nodiscard]] bool is_of_changes(std::string_view text);
/// The unit of the numbers below such a heading: "Hours", "Duration [h]", "Cost (min)".
[[nodiscard]] CostUnit unit_in_heading(std::string_view text);

[[nodiscard]] bool heads_slots(std::string_view text);
/// A column of numbers of pieces: "Quantity", "Qty (pcs)", "How many?", "In stock", "Anzahl".
[[nodiscard]] bool heads_quantities(std::string_view text);
/// The limits of a slot: "least", "min", "from"; "most", "max", "to".
[[nodiscard]] bool heads_least(std::string_view text);
[[nodiscard]] bool heads_most(std::string_view text);
/// The weights of pairs.
[[nodiscard]] bool heads_weights(std::string_view text);
/// The reasons why pairs are forbidden: "why", "Reason", "Comment".
[[nodiscard]] bool heads_reasons(std::string_view text);
/// Remarks on tests or results, by any of its words: "Comment", "Result note", "Bemerkung".
[[nodiscard]] bool heads_remarks(std::string_view text);
/// One of the two parts of a pair: as heads_parts(), or "A", "Part B", "with".
[[nodiscard]] bool heads_part_of_pair(std::string_view text);

/// The results of tests: "result", "Result (pass/fail)", "Ergebnis", "Verdict".
[[nodiscard]] bool heads_results(std::string_view text);
/// When or by whom a test was run, which is no result: "Date", "Uhrzeit", "Operator".
[[nodiscard]] bool heads_occasions(std::string_view text);
/// The numbers of steps or tests: "step", "Test no.", "Schritt".
[[nodiscard]] bool heads_steps(std::string_view text);

}  // namespace changeover

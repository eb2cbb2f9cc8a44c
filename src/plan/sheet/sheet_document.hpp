// Run sheets as documents that every format can write.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/run_plan.hpp"
#include "io/table/table_document.hpp"
#include "plan/sheet/places.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

/// The data that these refer to must outlive the document.
[[nodiscard]] TableDocument table_document(const SheetDocument& document);
[[nodiscard]] TableDocument table_document(const BenchDocument& document);
[[nodiscard]] TableDocument table_document(const Job& job, const WhatIf& answer);
[[nodiscard]] TableDocument table_document(const DiagnosisDocument& document);

/// The page style of a job: landscape if there are many slots, which have a column each.
[[nodiscard]] std::string style_of(const Job& job, bool compact = false);

/// Adds the sheets of a workbook from which the lists of a job can be read again: `Parts`, `Slots`,
/// `Never` and, of rows or a number of them, `Benches`. The job must outlive the document.
void add_lists_of_job(TableDocument& document, const Job& job, const Money& money,
                      const RequestList& benches);

/// Adds what a workbook must have besides so that it is all that is needed to go on: the lists of
/// the job, the tests that were done, and the question. `done` may be null, `question` and
/// `benches` empty.
void add_what_goes_on(TableDocument& document, const Job& job, const Money& money,
                      const DoneRecord* done, const std::vector<std::string>& question,
                      const RequestList& benches = {});

/// Adds the list of what stays mounted all the time, unless it is empty.
void add_mounted(TableDocument& document, const Job& job, const Block& mounted);

/// For a page: "Stay mounted: A · B", "Mounted before the first step: C"; empty if no part is.
[[nodiscard]] std::vector<std::string> mounted_on_page(const Job& job, bool has_steps = true);

/// Sets the lines; the first one is the headline.
void set_lines(TableDocument& document, std::vector<std::string> lines);

/// The sheets of all benches. Each has a job with the start of its bench, and with the same places
/// as all others.
struct BenchSheets {
  std::vector<Job> jobs;
  std::vector<ShownSheet> shown;  ///< with names and without times

  explicit BenchSheets(const BenchDocument& document);
  BenchSheets(const BenchSheets&) = delete;  // The sheets refer to the jobs.
  BenchSheets& operator=(const BenchSheets&) = delete;
};

/// The steps of all benches in one table, with a column for the bench.
[[nodiscard]] Table bench_step_table(const BenchDocument& document);

/// One line for programs.
[[nodiscard]] std::string json_of(const SheetDocument& document);
[[nodiscard]] std::string json_of(const BenchDocument& document);
[[nodiscard]] std::string json_of(const Job& job, const WhatIf& answer);
[[nodiscard]] std::string json_of(const DiagnosisDocument& document);

}  // namespace changeover

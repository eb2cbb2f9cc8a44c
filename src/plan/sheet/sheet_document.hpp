// Run sheets as documents that every format can write.
#pragma once

#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/run_plan.hpp"
#include "io/table/table_document.hpp"

namespace changeover {

/// What these refer to must outlive the document.
[[nodiscard]] TableDocument table_document(const SheetDocument& document);
[[nodiscard]] TableDocument table_document(const BenchDocument& document);
[[nodiscard]] TableDocument table_document(const Job& job, const WhatIf& answer);
[[nodiscard]] TableDocument table_document(const Job& job, const Diagnosis& found);

/// One line for programs.
[[nodiscard]] std::string json_of(const SheetDocument& document);
[[nodiscard]] std::string json_of(const BenchDocument& document);
[[nodiscard]] std::string json_of(const Job& job, const WhatIf& answer);
[[nodiscard]] std::string json_of(const Job& job, const Diagnosis& found);

}  // namespace changeover

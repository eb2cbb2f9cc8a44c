// What a user changed on the sheets of a workbook that have the lists of its plan.
#pragma once

#include <string>
#include <string_view>

#include "changeover/io/input.hpp"
#include "changeover/plan/job_request.hpp"
#include "io/table/table.hpp"
#include "plan/request/workbook/run_workbook.hpp"

namespace changeover {

/// The name of the sheet with the costs of the values of a model.
inline constexpr std::string_view costs_sheet = "Costs";

/// Whether a sheet says what this table said when the workbook was written.
[[nodiscard]] bool is_as_written(const RunWorkbook& book, const std::string& name,
                                 const Table& table);

/// The costs of values of this job as a sheet of costs has them. What such a sheet does not say
/// stays: quantities, and costs that depend on what is replaced. @throws BadInput as
/// read_value_costs()
[[nodiscard]] RequestList changed_costs(Input& sheet, const Job& job);

}  // namespace changeover

// Reads from the workbook of a parts list the request that it was made for, or lists on its other
// sheets.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job_request.hpp"

namespace changeover {

/// The hidden sheet with the request: below a head, which is the format of the document, the
/// document in pieces, one per row.
inline constexpr std::string_view question_sheet = "changeover-question";
/// The sheets of a run sheet: its steps, and the earlier tests.
inline constexpr std::string_view steps_sheet = "Run sheet";
inline constexpr std::string_view done_sheet = "Done";
inline constexpr std::string_view parts_sheet = "Parts";

/// The pieces of a document for that sheet, each short enough for a cell.
[[nodiscard]] std::vector<std::string> question_pieces(const std::string& document);

/// The inputs of a list of tests that were done, in order: from a workbook that has both, the
/// sheets `Done` and `Run sheet`; otherwise the list itself. @throws as open()
[[nodiscard]] std::vector<std::unique_ptr<Input>> open_done(const RequestList& list,
                                                            const std::string& spelled);

}  // namespace changeover

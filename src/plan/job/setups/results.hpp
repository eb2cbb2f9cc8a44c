// Interprets the column `result`, for which changeover/plan/job.hpp has result_of(), too. A
// doubtful result is unread, because a wrong pass would hide a fault.
#pragma once

#include <string_view>

namespace changeover {

/// Whether what stands under `result` says that the test was run.
[[nodiscard]] bool was_run(std::string_view result);

}  // namespace changeover

// The answer where there is no design to show.
#pragma once

#include <string>
#include <vector>

#include "request/request.hpp"

namespace changeover::cli {

/// Writes to standard output what is known of parameters that nothing serves: why no design exists, or the
/// lower bound, what is near, what would help. `construction` is the only one that was asked, or empty.
/// Returns the exit code.
int decline(const std::vector<Parameters>& asked, const std::string& construction,
            const OutputRequest& output);

}  // namespace changeover::cli

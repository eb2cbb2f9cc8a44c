// An answer never goes over what it was made from.
//
//     refuse_to_overwrite_inputs(request.output.path, {{"the parts list", request.parts}, …});
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace changeover::cli {

/// An input: what the user calls it, as in "--never", and its path; "" if it was not given, "-" for
/// standard input.
using InputFile = std::pair<std::string, std::string>;

/// @throws UsageError if the output is a regular file that is one of the inputs, by whatever path or link.
void refuse_to_overwrite_inputs(const std::string& output, const std::vector<InputFile>& inputs);

}  // namespace changeover::cli

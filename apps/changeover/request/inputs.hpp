// The files that a verb reads: an answer never goes over what it was made from, and "-" is read
// once.
//
//     check_inputs(request.output, {{"the parts list", request.parts}, {"--never", request.never}});
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "request/output.hpp"

namespace changeover::cli {

/// An input: what the user calls it, as in "--never", and its path; "" if it was not given, "-" for
/// standard input.
using InputFile = std::pair<std::string, std::string>;

/// @throws UsageError if the output is a regular file that is one of the inputs, by whatever path
/// or link, or if more than one of them is standard input.
void check_inputs(const OutputRequest& output, const std::vector<InputFile>& inputs);

/// @throws UsageError if the output is a file in which something is kept from one run to the next,
/// or one beside it that belongs to it: a lock, SQLite's journals.
void check_kept(const std::string& output, const InputFile& kept);

/// @throws UsageError if a file that is read and replaced is "-". `why` says what is done with it.
void require_file(const std::string& option, const std::string& path, const std::string& why);

}  // namespace changeover::cli
